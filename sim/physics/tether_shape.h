// How the hanging tether looks: sag by its own weight, or slack on the ground. For drawing only.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/rover_model.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// Points from tip to support, both included. A parabola: sag w D^2 / (8 T) when taut; with excess
/// length e beyond the distance D the sag is sqrt(3 D e / 8), from the parabola's length
/// D + 8 s^2 / (3 D); lying on the ground where it would pass below.
std::vector<Eigen::Vector3d> HangingTether(const TetherModel& tether, const HeightGrid& ground,
                                           const Eigen::Vector3d& tip_G,
                                           const Eigen::Vector3d& support_G, double tension_n,
                                           double excess_m);

}  // namespace dockyard
