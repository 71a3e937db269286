// Lines with fewer points.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace dockyard {

/// The points without those that lie within the tolerance of a line between others, the first and
/// the last kept (Douglas and Peucker, Cartographica 10(2), 1973).
std::vector<Eigen::Vector3d> Simplified(const std::vector<Eigen::Vector3d>& points,
                                        double tolerance);

}  // namespace dockyard
