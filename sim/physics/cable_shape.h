// How the hanging tether looks: sag by its own weight, or slack on the ground. For drawing only.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/parts/tether.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// Points from tip to support, both included, on a catenary z = a cosh((s - s0) / a) + c: taut, of
/// the tether's tension at the tip; slacker than a tenth of a newton, of its length, the straight
/// distance and excess_m; lying on the ground where it would pass below.
std::vector<Eigen::Vector3d> HangingTether(const TetherModel& tether, const HeightGrid& ground,
                                           const Eigen::Vector3d& tip_G,
                                           const Eigen::Vector3d& support_G, double tension_n,
                                           double excess_m);

}  // namespace dockyard
