// How a robot is to dock: states, limits and gains that a user may set.
#pragma once

#include "controller/geometry/pose.h"

namespace dockyard::custom {

/// Angles, speeds and times of the controller `graceful`. Names and defaults follow Nav2's docking
/// server (opennav_docking, graceful controller), so that its users can compare.
struct DockingOptions {
  // The smooth control law of Park and Kuipers (ICRA 2011), equations (8), (14) and (15).
  double k_phi = 3.0, k_delta = 2.0;  // Nav2's; the paper has 1 and 3
  double beta = 0.4, lambda = 2.0;    // how curvature slows the robot: 1 / (1 + beta |k|^lambda)
  double slowdown_m = 0.25;           // from the pose on which speed falls
  double least_m_s = 0.10, most_m_s = 0.25, most_rad_s = 0.75;  // Nav2's
  double accel_m_s2 = 0.5, accel_rad_s2 = 1.5;                  // assumed, 0.2-2 and 0.5-4
  // Below these the wheels' motors do not overcome their friction; they are skipped. Assumed,
  // 0-0.03 m/s and 0-0.1 rad/s.
  double dead_m_s = 0.0, dead_rad_s = 0.0;
  double staging_m = 0.7;      // out of the docked pose, along x of D: Nav2's staging_x_offset
  double perception_s = 5.0;   // the marks are awaited so long: Nav2's initial_perception_timeout
  double approach_s = 30.0;    // Nav2's dock_approach_timeout
  double wait_charge_s = 5.0;  // Nav2's wait_charge_timeout
  int retries = 3;             // Nav2's max_retries
  double wiggle_rad = 0.04;  // either side, with the wheels pressing on; assumed, 0.02-0.1; 0: none
  // A robot off the docked pose by more backs off before it touches. Assumed: half of what a flat
  // contact allows, 3-8 mm and 1-4 deg.
  double aligned_m = 0.004, aligned_rad = 0.035;
  double press_m = 0.02;  // driven on beyond the docked pose to press; assumed, 0-0.05

  double press_m_s = 0.03;    // speed at which the robot touches and presses; assumed, 0.01-0.1
  double search_rad_s = 0.4;  // turning in place to find the dock; assumed, 0.2-0.8
  // Without a contact: docked within these of the docked pose, along and across x of D, and turned.
  // Assumed, 0.01-0.03 m, 0.005-0.02 m, 0.02-0.09 rad.
  double docked_along_m = 0.015, docked_aside_m = 0.010, docked_rad = 0.05;

  bool operator==(const DockingOptions&) const = default;
};

}  // namespace dockyard::custom
