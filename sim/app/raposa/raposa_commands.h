// RAPOSA's own commands: `dockyard alpha`, `dockyard belt`, `dockyard socket`, `dockyard tune`, and
// `dockyard detect` for its robot.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard::raposa {

std::vector<SystemCommand> RaposaCommands();
/// `dockyard detect IMAGE --scenario FILE ...`, as System::detect.
SystemCommand DetectCommand();

}  // namespace dockyard::raposa
