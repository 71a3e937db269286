// Time of images and of what is read from them, of a rover at the start of a scenario.
#pragma once

#include <string>

namespace dockyard::axel {

/// CPU time [s]: of a stereo pair, of detection in an image, of a pair to the board's pose, and of
/// the latter without the detection.
struct VisionSpeed {
  double pair_s = 0.0, detect_s = 0.0, locate_s = 0.0, alone_s = 0.0;
};
VisionSpeed TimeVision(int width, int height);

/// CPU time [s] of a pair at 1024 x 768; the least of several, which other programs disturb least.
double PairSeconds(const std::string& light, const std::string& range_m);

}  // namespace dockyard::axel
