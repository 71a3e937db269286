// The data sheet that the rover's brain is given: nominal numbers, from calibration and drawings.
// The world is built from its own, dispersed numbers.
#pragma once

#include <Eigen/Core>
#include <array>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/io/sensors.h"
#include "controller/io/vision_settings.h"

namespace dockyard {

struct MotorSheet {
  double rad_per_count = 0.0;      // encoder step at the output shaft
  double torque_per_amp_nm = 0.0;  // at the output, efficiency included
  double no_load_current_a = 0.0;  // the drive's own friction
  double max_current_a = 0.0;
  double max_speed_rad_s = 0.0;  // at the output
  double max_accel_rad_s2 = 0.0;
};

struct RoverSheet {
  StereoRig rig;  // calibration, not truth
  FiducialBoard board;
  VisionSettings vision{};
  Pose3 X_DB;  // board in the dock, station standing level on flat ground
  std::array<MotorSheet, kMotorCount> motors;  // by Motor
  double wheel_radius_m = 0.0;                 // rolling radius on firm ground: rim plus paddle
  double track_m = 0.0;                        // between the wheels' middles
  double arm_length_m = 0.0;                   // axle to arm tip
  double arm_at_zero_rad = 0.0;  // arm against body at encoder zero, about +y: tip-down positive
  double drum_radius_m = 0.0;
  double mouth_height_m = 0.0;   // centre of the cone's mouth above the ground
  double anchor_depth_m = 0.0;   // tether anchor behind the mouth plane, along the axis
  double mating_depth_m = 0.25;  // how far to reel the tip in (Tsai et al., II)
};

}  // namespace dockyard
