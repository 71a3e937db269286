// `dockyard belt`: one belt, and the robot turning in place, on a ground.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard::raposa {

/// A CommandFunction. Throws CLI::ParseError and ConfigError.
int BeltOnGround(const std::string& program, const std::vector<std::string>& words);

/// For completion.
std::vector<CommandOption> BeltOptions();

}  // namespace dockyard::raposa
