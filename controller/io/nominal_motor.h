// A motor's nominal parameters, from its drawing and data sheet, at the output shaft.
#pragma once

namespace dockyard {

struct NominalMotor {
  double rad_per_count = 0.0;      // encoder step
  double torque_per_amp_nm = 0.0;  // efficiency included
  double no_load_current_a = 0.0;  // the drive's own friction
  double max_current_a = 0.0;
  double max_speed_rad_s = 0.0;
  double max_accel_rad_s2 = 0.0;

  bool operator==(const NominalMotor&) const = default;
};

}  // namespace dockyard
