// The true state of one motor at its output shaft.
#pragma once

namespace dockyard {

struct MotorTruth {
  double angle_rad = 0.0, speed_rad_s = 0.0, torque_nm = 0.0;
  double current_a = 0.0;  // as drawn, without reading noise
  double lead_rad = 0.0;   // of the motor's side, where the encoder is, before the output
};

}  // namespace dockyard
