// Park and Kuipers, "A smooth control law for graceful motion of differential wheeled mobile robots
// in 2D environment" (ICRA 2011), and its limits as Nav2's graceful controller has them.
#pragma once

#include "controller/custom/nominal/docking.h"
#include "controller/geometry/pose.h"
#include "controller/motion/path_follower.h"

namespace dockyard::custom {

/// The robot against the line of sight to its target: theta is the target's heading, delta the
/// robot's, both counter-clockwise from that line.
struct SightCoords {
  double r_m = 0.0, theta_rad = 0.0, delta_rad = 0.0;
};
/// @param X_AT  the target in the robot
SightCoords ToSightCoords(const Pose2& X_AT);

/// Equation (14): the curvature to drive [1/m]. k_phi is the paper's k1, k_delta its k2.
double GracefulCurvature(const SightCoords& at, const DockingOptions& options);

/// The speed of equation (15), slower within slowdown_m, within the limits of speed and turning
/// rate; the curvature stays.
/// @param travel  1: forward, -1: backward; then the target's heading is reached backward
Twist GracefulTwist(const Pose2& X_AT, double travel, const DockingOptions& options);

}  // namespace dockyard::custom
