// `dockyard alpha`: the angle about the pyramid and the distance from two lengths in an image.
#pragma once

#include <string>
#include <vector>

namespace dockyard::raposa {

/// Gets the words after `alpha`; returns the exit code. Throws CLI::ParseError.
int Alpha(const std::vector<std::string>& words);

}  // namespace dockyard::raposa
