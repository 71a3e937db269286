// MuJoCo's own renderer beside ours: the same size, the same OSMesa, one sun with its shadow.
#pragma once

namespace dockyard::axel {

/// CPU seconds of a stereo pair by MuJoCo (pinhole, 4 samples a pixel as it does by default, shadow
/// map of 2048 texels) of a comparable yard: uneven ground, station, board, arm, wheels. Throws
/// std::runtime_error when MuJoCo or OSMesa refuses.
double MujocoPairSeconds(int width, int height);

}  // namespace dockyard::axel
