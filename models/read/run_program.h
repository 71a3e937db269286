// Another program, run with limits; its output is taken.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "models/read/guarded_work.h"

namespace dockyard {

struct ProgramEnd {
  std::string out, err;
  std::string failure;  // "took more than 60 s", "ended with exit code 2"; empty when it went well
};

/// The file of a program on PATH.
std::optional<std::filesystem::path> FindProgram(const std::string& name);

/// Runs the program without input and waits for its end. It and what it has started are killed at
/// a limit. Throws std::system_error when no process can be had.
ProgramEnd RunProgram(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments, const WorkLimits& limits);

}  // namespace dockyard
