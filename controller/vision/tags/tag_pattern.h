// Internal to the tags room. The printed pattern as a blurred image shows it.
#pragma once

#include <Eigen/Core>

#include "controller/geometry/board.h"

namespace dockyard {

/// How black a blurred pattern is at a point, 0 to 1, and the derivatives by the point.
struct Blackness {
  double share = 0.0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();     // by the point
  Eigen::Vector2d by_sigma = Eigen::Vector2d::Zero();  // by the blur along x and along y
};

/// @param at     in cells from the tag's middle, x right, y down
/// @param sigma  of the Gaussian blur, in cells
/// All beyond the pattern counts as white.
Blackness BlacknessAt(const TagCells& cells, const Eigen::Vector2d& at,
                      const Eigen::Vector2d& sigma);

}  // namespace dockyard
