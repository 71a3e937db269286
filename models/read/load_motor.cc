#include "models/read/load_motor.h"

namespace dockyard {

void VisitMotor(Keys& keys, MotorModel& motor, Presence needed) {
  const auto key = [&](const char* name) { return Key(name, "", "", needed); };
  keys.Number(key("torque_per_amp_nm"), motor.torque_per_amp_nm, Positive(1e4));
  keys.Number(key("no_load_current_a"), motor.no_load_current_a, NonNegative(100.0));
  keys.Number(key("max_current_a"), motor.max_current_a, Positive(1000.0));
  keys.Number(key("gear_friction_nm"), motor.gear_friction_nm, NonNegative(1e3));
  keys.Number(key("brake_torque_nm"), motor.brake_torque_nm, NonNegative(1e5));
  keys.Number(key("max_speed_rad_s"), motor.max_speed_rad_s, Positive(100.0));
  keys.Number(key("max_accel_rad_s2"), motor.max_accel_rad_s2, Positive(1000.0));
  keys.Number(key("reflected_inertia_kg_m2"), motor.reflected_inertia_kg_m2, Positive(1e4));
  keys.Integer(key("counts_per_rev"), motor.counts_per_rev, 16, 1 << 30);
  keys.Number(key("current_noise_a"), motor.current_noise_a, NonNegative(10.0));
  keys.Number(Optional("gear_efficiency"), motor.gear_efficiency, Between(0.2, 1.0));
  keys.Number(Optional("current_offset_a"), motor.current_offset_a, Between(-10.0, 10.0));
  keys.Degrees(Optional("backlash_deg"), motor.backlash_rad, NonNegative(30.0));
  keys.Number(Optional("bend_nm_per_rad"), motor.bend_nm_per_rad, NonNegative(1e8));
  keys.Degrees(Optional("homing_error_deg"), motor.homing_error_rad, Between(-30.0, 30.0));
  keys.Choice(Optional("profile"), motor.profile, {"trapezoid", "spline"});
  keys.Check("max_current_a", motor.max_current_a > motor.no_load_current_a,
             "more than no_load_current_a");
}

}  // namespace dockyard
