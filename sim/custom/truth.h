// What is true of a robot and a dock that are described by files. Never handed to a controller.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/pose.h"
#include "sim/drives/motor_truth.h"

namespace dockyard::custom {

/// An electrical contact.
struct ContactTruth {
  bool closed = false;
  double force_n = 0.0;                     // sum of its pins
  double voltage_v = 0.0, current_a = 0.0;  // at the robot
  double offset_m = 0.0;  // the worst of its tips from its pad's middle, along the pad
};

struct Truth {
  double time_s = 0.0;
  std::vector<Pose3> X_WL, X_WK;  // links of the robot, and of the dock; the roots first
  Eigen::Vector3d v_WR_W{0, 0, 0}, w_WR_W{0, 0, 0};
  Pose3 X_DR;  // D: the dock's root link now
  Pose3 X_QP;  // the robot's frame P in the dock's frame Q, which meet when docked
  Pose3 X_GR;  // G: the dock's nominal place
  double speed_m_s = 0.0, turning_rad_s = 0.0;  // of the robot's root, against the ground
  std::vector<MotorTruth> motors;
  std::vector<double> wheel_load_n, wheel_slip;
  std::vector<ContactTruth> contacts;  // in the order of the pins' names
  std::vector<bool> switches;
  std::vector<double> ranges_m;
  double touch_n = 0.0, peak_touch_n = 0.0;  // between robot and dock; the sum, its most
  double dock_moved_m = 0.0, dock_turned_rad = 0.0, dock_tilt_rad = 0.0;  // since the start
  double tilt_rad = 0.0;  // of the robot's root from upright

  const Pose3& X_WR() const { return X_WL.front(); }
};

}  // namespace dockyard::custom
