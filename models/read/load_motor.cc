#include "models/read/load_motor.h"

namespace dockyard {

void VisitMotor(Keys& keys, MotorModel& motor, Presence needed) {
  const auto key = [&](const char* name, const char* unit, const char* meaning) {
    return Key(name, unit, meaning, needed);
  };
  keys.Number(key("torque_per_amp_nm", "N m/A", "at the output shaft, as all of these"),
              motor.torque_per_amp_nm, Positive(1e4));
  keys.Number(key("no_load_current_a", "A", "drawn to turn its own gears"), motor.no_load_current_a,
              NonNegative(100.0));
  keys.Number(key("max_current_a", "A", "limit of the drive"), motor.max_current_a,
              Positive(1000.0));
  keys.Number(key("gear_friction_nm", "N m", "Coulomb's, in every mode"), motor.gear_friction_nm,
              NonNegative(1e3));
  keys.Number(key("brake_torque_nm", "N m", "held by the brake"), motor.brake_torque_nm,
              NonNegative(1e5));
  keys.Number(key("max_speed_rad_s", "rad/s", "limit of the drive's profile"),
              motor.max_speed_rad_s, Positive(100.0));
  keys.Number(key("max_accel_rad_s2", "rad/s^2", "slope of the drive's profile, at most"),
              motor.max_accel_rad_s2, Positive(1000.0));
  keys.Number(
      key("reflected_inertia_kg_m2", "kg m^2", "rotor's inertia times the gear's ratio squared"),
      motor.reflected_inertia_kg_m2, Positive(1e4));
  keys.Integer(key("counts_per_rev", "", "of the encoder, for a turn of the output"),
               motor.counts_per_rev, 16, 1 << 30);
  keys.Number(key("current_noise_a", "A", "1 sigma of a reading"), motor.current_noise_a,
              NonNegative(10.0));
  keys.Number({"gear_efficiency", "",
               "share that loaded teeth pass on; the rest resists being driven back"},
              motor.gear_efficiency, Between(0.2, 1.0));
  keys.Number({"current_offset_a", "A", "of each reading"}, motor.current_offset_a,
              Between(-10.0, 10.0));
  keys.Number(
      {"current_offset_sigma_a", "A", "drawn for each run on top of current_offset_a, 1 sigma"},
      motor.current_offset_sigma_a, NonNegative(10.0));
  keys.Number(
      {"current_scale_share", "", "error of a reading's scale, drawn for each run, 1 sigma"},
      motor.current_scale_share, NonNegative(0.5));
  keys.Degrees({"backlash_deg", "deg", "the output's whole play"}, motor.backlash_rad,
               NonNegative(30.0));
  keys.Number({"bend_nm_per_rad", "N m/rad", "stiffness of gears and shaft; 0: rigid"},
              motor.bend_nm_per_rad, NonNegative(1e8));
  keys.Degrees({"homing_error_deg", "deg", "what the encoder reads at the true zero"},
               motor.homing_error_rad, Between(-30.0, 30.0));
  keys.Choice({"profile", "", "of a move"}, motor.profile, {"trapezoid", "spline"});
  keys.Check("max_current_a", motor.max_current_a > motor.no_load_current_a,
             "more than no_load_current_a");
}

}  // namespace dockyard
