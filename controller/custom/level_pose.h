// From a board's pose in a camera to the dock's pose in the plane. Robot and dock are on one floor,
// so the dock's tilt and height are known: they judge the pose and narrow it.
//
// Frame H: R without roll and pitch.
#pragma once

#include <Eigen/Core>

#include "controller/custom/sighting.h"

namespace dockyard::custom {

/// Errors, 1 sigma, of what the floor and the drawings say.
struct FloorSpread {
  double height_m = 0.02;           // uneven floor, mountings; assumed, 0.01-0.05
  double tilt_rad = Radians(2.0);   // the same, and the robot's nod as it brakes; assumed, 1-4 deg
  double range_share = 0.005;       // calibration of lens and board; assumed, 0.2-1 %
  double aside_rad = Radians(0.3);  // mounting of the camera; assumed, 0.1-0.5 deg
  double place_m = 0.002;           // of board and camera; assumed, 1-5 mm
  double heading_rad = Radians(0.5);  // of the board on the dock; assumed, 0.2-1 deg
};

/// The dock in the plane, by one branch.
struct PlacedDock {
  Pose2 X_HD;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of x, y [m], heading [rad]
  Eigen::Matrix3d lasting = Eigen::Matrix3d::Zero();     // the part that each sighting shares
  double floor_misfit = 0.0;  // chi-square of tilt and height, 3 degrees of freedom
};

/// @param imu  its roll and pitch; zero without a unit
PlacedDock PlaceDock(const PoseBranch& branch, const Pose3& X_RC, const Pose3& X_DB,
                     double height_m, const ImuSample& imu, const FloorSpread& spread = {});

}  // namespace dockyard::custom
