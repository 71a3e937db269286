// The shape of the hanging tether: sag by its own weight, or slack on the ground. For drawing only.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/parts/tether.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// Points from tip to support, both included, on a catenary z = a cosh((s - s0) / a) + c. When
/// taut, it has the tether's tension at the tip. When slacker than a tenth of a newton, it has the
/// length of the straight distance plus excess_m. Where it would pass below the ground, it lies on
/// the ground. R_LG: the site's axes in a frame with z up. gravity_m_s2: what it hangs in.
std::vector<Eigen::Vector3d> HangingTether(const TetherModel& tether, const HeightGrid& ground,
                                           const Eigen::Matrix3d& R_LG,
                                           const Eigen::Vector3d& tip_G,
                                           const Eigen::Vector3d& support_G, double tension_n,
                                           double excess_m, double gravity_m_s2);

}  // namespace dockyard
