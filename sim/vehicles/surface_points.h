// Points on the surface of a convex part, to be held against a body that has dents.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/parts/wheel.h"
#include "sim/rigid/convex_body.h"

namespace dockyard {

/// The corners, and others no more than this apart.
std::vector<Eigen::Vector3d> SurfacePoints(const ConvexBody& body, double apart_m);
/// On the circle of the paddles' tips, about y.
std::vector<Eigen::Vector3d> WheelPoints(const WheelModel& wheel, double apart_m);

}  // namespace dockyard
