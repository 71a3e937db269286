// A geared motor with its drive.
#pragma once

#include <cstdint>

#include "controller/geometry/pose.h"
#include "controller/io/nominal_motor.h"

namespace dockyard {

/// The path of a drive to its target: a trapezoid of speed, or a smooth polynomial (spline).
enum class ProfileShape : std::uint8_t { kTrapezoid, kSpline };

/// A geared motor with its drive, all at the output shaft.
struct MotorModel {
  double torque_per_amp_nm = 0.0;  // while the motor drives; gear efficiency included
  double gear_efficiency = 1.0;    // of the loaded teeth; below 1 they resist being driven back
  ProfileShape profile = ProfileShape::kTrapezoid;
  double no_load_current_a = 0.0;  // drawn to turn its own gears
  double max_current_a = 0.0;      // drive limit
  double gear_friction_nm = 0.0;   // Coulomb friction at the output, present in every mode
  double brake_torque_nm = 0.0;    // held by MotorMode::kBrake
  double max_speed_rad_s = 0.0;
  double max_accel_rad_s2 = 0.0;         // the drive caps profiles at these
  double reflected_inertia_kg_m2 = 0.0;  // rotor inertia times gear ratio squared
  int counts_per_rev = 0;                // encoder at the output shaft
  double current_noise_a = 0.0;          // 1 sigma of one reading
  double current_offset_a = 0.0;         // of each reading
  // Each run draws, 1 sigma: what is added to the offset, and the error of the readings' scale.
  double current_offset_sigma_a = 0.0, current_scale_share = 0.0;
  // The encoder and the servo are on the motor's side of these. 0: none.
  double backlash_rad = 0.0;      // the output's whole play
  double bend_nm_per_rad = 0.0;   // stiffness of gears and shaft; 0: rigid
  double homing_error_rad = 0.0;  // what the encoder reads at the true zero
};

/// What a controller is told of it.
inline NominalMotor NominalOf(const MotorModel& motor) {
  return {.rad_per_count = 2.0 * kPi / motor.counts_per_rev,
          .torque_per_amp_nm = motor.torque_per_amp_nm,
          .no_load_current_a = motor.no_load_current_a,
          .max_current_a = motor.max_current_a,
          .max_speed_rad_s = motor.max_speed_rad_s,
          .max_accel_rad_s2 = motor.max_accel_rad_s2};
}

}  // namespace dockyard
