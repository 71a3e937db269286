// A robot's pose in its target's frame: in space, with its planar view.
#pragma once

#include "controller/geometry/pose.h"

namespace dockyard {

/// The planar view is kept as numbers: a rotation matrix rounds a heading, and a heading need not
/// be that of the x axis (AxleOnGround). So a robot that believes in the plane keeps every bit.
struct RobotPose {
  Pose3 X;
  double x = 0.0, y = 0.0;  // [m]
  double heading = 0.0;     // [rad], (-pi, pi]

  RobotPose() = default;
  RobotPose(const Pose3& in_space, const Pose2& plane)
      : X(in_space), x(plane.x), y(plane.y), heading(plane.heading) {}
  // Implicit on purpose, as is the view below: most robots know no more than the plane.
  RobotPose(const Pose2& plane) : RobotPose(FromGround(plane, 0.0), plane) {}
  RobotPose(double x_m, double y_m, double heading_rad) : RobotPose(Pose2{x_m, y_m, heading_rad}) {}
  explicit RobotPose(const Pose3& in_space) : RobotPose(in_space, ToGround(in_space)) {}

  /// Turned by roll, pitch and heading about moving axes.
  static RobotPose FromAngles(const Eigen::Vector3d& p, const RollPitchYaw& angles) {
    return {Pose3{ToRotation(angles), p}, {p.x(), p.y(), angles.yaw}};
  }

  operator Pose2() const { return {x, y, heading}; }
};

}  // namespace dockyard
