// A robot's pose as six numbers, for logs and tables.
#pragma once

#include <array>

#include "controller/geometry/robot_pose.h"

namespace dockyard {

/// The planar view first. Roll and pitch are of X, about moving axes with its yaw.
inline constexpr std::array<const char*, 6> kPoseNames{"x_m", "y_m",         "heading_rad",
                                                       "z_m", "roll_DR_rad", "pitch_DR_rad"};

inline std::array<double, 6> PoseNumbers(const RobotPose& X_DR) {
  const RollPitchYaw angles = ToRollPitchYaw(X_DR.X.R);
  // A level pose has no negative zeros.
  return {X_DR.x, X_DR.y, X_DR.heading, X_DR.X.p.z(), angles.roll + 0.0, angles.pitch + 0.0};
}

/// The planar view comes back bit for bit, and so does a pose that was set from it.
inline RobotPose PoseFromNumbers(const std::array<double, 6>& n) {
  return RobotPose::FromAngles({n[0], n[1], n[3]}, {.roll = n[4], .pitch = n[5], .yaw = n[2]});
}

}  // namespace dockyard
