// Poses that put three known points on three lines of sight.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard {

/// Grunert's solution in the form of Haralick et al. (IJCV 13(3), 1994): up to four poses X_CB.
/// Lines of sight are unit vectors in C through its origin. None for points on a line.
std::vector<Pose3> PosesFromThreePoints(const std::array<Eigen::Vector3d, 3>& points_B,
                                        const std::array<Eigen::Vector3d, 3>& sights_C);

}  // namespace dockyard
