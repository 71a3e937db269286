#include "models/read/load_motor.h"

namespace dockyard {

MotorModel ReadMotor(const YamlNode& node, const std::string& path) {
  const YamlReader in(
      node, path,
      {"torque_per_amp_nm", "no_load_current_a", "max_current_a", "gear_friction_nm",
       "brake_torque_nm", "max_speed_rad_s", "max_accel_rad_s2", "reflected_inertia_kg_m2",
       "counts_per_rev", "current_noise_a", "gear_efficiency", "profile", "current_offset_a",
       "backlash_deg", "bend_nm_per_rad", "homing_error_deg"});
  MotorModel motor;
  motor.torque_per_amp_nm = in.Number("torque_per_amp_nm", Positive(1e4));
  motor.no_load_current_a = in.Number("no_load_current_a", NonNegative(100.0));
  motor.max_current_a = in.Number("max_current_a", Positive(1000.0));
  motor.gear_friction_nm = in.Number("gear_friction_nm", NonNegative(1e3));
  motor.brake_torque_nm = in.Number("brake_torque_nm", NonNegative(1e5));
  motor.max_speed_rad_s = in.Number("max_speed_rad_s", Positive(100.0));
  motor.max_accel_rad_s2 = in.Number("max_accel_rad_s2", Positive(1000.0));
  motor.reflected_inertia_kg_m2 = in.Number("reflected_inertia_kg_m2", Positive(1e4));
  motor.counts_per_rev = in.Integer("counts_per_rev", 16, 1 << 30);
  motor.current_noise_a = in.Number("current_noise_a", NonNegative(10.0));
  motor.gear_efficiency = in.NumberOr("gear_efficiency", 1.0, Between(0.2, 1.0));
  motor.current_offset_a = in.NumberOr("current_offset_a", 0.0, Between(-10.0, 10.0));
  motor.backlash_rad = in.DegreesOr("backlash_deg", 0.0, NonNegative(30.0));
  motor.bend_nm_per_rad = in.NumberOr("bend_nm_per_rad", 0.0, NonNegative(1e8));
  motor.homing_error_rad = in.DegreesOr("homing_error_deg", 0.0, Between(-30.0, 30.0));
  motor.profile = in.ChoiceOr("profile", 0, {"trapezoid", "spline"}) == 0 ? ProfileShape::kTrapezoid
                                                                          : ProfileShape::kSpline;
  if (motor.max_current_a <= motor.no_load_current_a) {
    in.Refuse("max_current_a", "more than no_load_current_a");
  }
  return motor;
}

}  // namespace dockyard
