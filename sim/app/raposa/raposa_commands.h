// RAPOSA's own commands: `dockyard alpha`, `dockyard tune`, and `dockyard detect` for its robot.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard::raposa {

std::vector<SystemCommand> RaposaCommands();
/// `dockyard detect IMAGE --robot FILE ...`, as System::detect. Throws ConfigError and
/// CLI::ParseError.
int DetectMarks(const std::string& program, const std::vector<std::string>& words);

}  // namespace dockyard::raposa
