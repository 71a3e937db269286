// A plane through the ground among other things.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace dockyard {

/// Heights (1, x, y) . plane, from points of the ground and of what is on it, by least squares
/// through the points within 12 cm of the plane that is expected, then within 6 and 3 cm of the one
/// found (assumed, 8-15, 4-8 and 2-4 cm), as long as enough points are there; none where they are
/// not to begin with.
std::optional<Eigen::Vector3d> FitGroundPlane(const std::vector<Eigen::Vector3d>& points,
                                              const Eigen::Vector3d& expected, int least_points);

}  // namespace dockyard
