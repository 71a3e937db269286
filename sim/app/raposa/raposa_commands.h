// RAPOSA's own commands: `dockyard alpha`, `dockyard tune`, and `dockyard detect` for its robot.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard::raposa {

std::vector<SystemCommand> RaposaCommands();
/// `dockyard detect IMAGE --robot FILE ...`. Gets the words after `detect`; returns the exit code.
/// Throws ConfigError and CLI::ParseError.
int DetectMarks(const std::vector<std::string>& words);

}  // namespace dockyard::raposa
