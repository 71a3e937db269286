// Whether two images are a pair of their rig: corners of the left rectified image are sought in the
// right one, in other rows and on the wrong side, too.
#pragma once

#include <vector>

#include "controller/geometry/image.h"
#include "controller/stereo/rectify.h"

namespace dockyard {

/// A corner of the left rectified image that was found in the right one.
struct FoundCorner {
  Eigen::Vector2d left{0, 0};  // [px]
  double disparity_px = 0.0;   // u of the left image less that of the right one
  double lower_px = 0.0;       // v of the right image less that of the left one
};

struct PairCheck {
  int corners = 0;    // searched for
  int both_ways = 0;  // found from left to right and back at the same place
  /// Those of them in rows that agree with each other.
  std::vector<FoundCorner> found{};
  double lower_px = 0.0;  // median of found
  /// By how many px the right image's rows go off those of the left one from the left to the right
  /// of the corners found, and from the top to the bottom: a turn about the view, and a scale.
  double across_px = 0.0, down_px = 0.0;
  double turn_rad = 0.0, scale = 0.0;  // the same as an angle, and as a share
  double farthest_row_px = 0.0;        // rows were sought so far off
  double pixel_px = 1.0;               // of the images in which they were sought
};

/// Of the images as the cameras took them. No corners where an image is too small or has none.
PairCheck CheckPair(const Rectifier& rectifier, const StereoImages& images);

}  // namespace dockyard
