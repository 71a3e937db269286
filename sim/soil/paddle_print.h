// The print that a wheel's paddle leaves in a rut, on the height grid.
#pragma once

#include <Eigen/Core>

#include "sim/soil/height_grid.h"

namespace dockyard {

/// A thin plate upright in the ground, where it was deepest.
struct PaddlePrint {
  Eigen::Vector2d at{0, 0};      // middle of its tip in G
  Eigen::Vector2d across{0, 1};  // unit, along the tip
  double width_m = 0.0, thickness_m = 0.0;
  double depth_m = 0.0;  // of the tip below the ground; 0: it left none
};

/// Leaves the groove that remains when the plate is out and its walls have slid down to the angle
/// of repose: a V of the plate's cross-section. As much soil becomes a ridge on either side, half
/// on each, no steeper.
void LeavePrint(HeightGrid& grid, const PaddlePrint& print, double tan_repose);

}  // namespace dockyard
