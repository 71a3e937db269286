// `dockyard alpha`: the angle about the pyramid and the distance from two lengths in an image.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard::raposa {

/// A CommandFunction. Throws CLI::ParseError.
int Alpha(const std::string& program, const std::vector<std::string>& words);

/// For completion.
std::vector<CommandOption> AlphaOptions();

}  // namespace dockyard::raposa
