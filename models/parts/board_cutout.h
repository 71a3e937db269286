// A circular cut-out of a fiducial board.
#pragma once

#include <Eigen/Core>

namespace dockyard {

/// Where something, such as a docking cone, passes through the board.
struct BoardCutout {
  Eigen::Vector2d p_B = Eigen::Vector2d::Zero();  // centre on the board [m]
  double radius_m = 0.0;
};

}  // namespace dockyard
