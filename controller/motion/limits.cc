#include "controller/motion/limits.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {

void KeepLimits(std::span<const NominalMotor> motors, Commands* commands) {
  DOCKYARD_CHECK(commands->motors.size() == motors.size());
  for (std::size_t i = 0; i < motors.size(); ++i) {
    MotorCommand& motor = commands->motors[i];
    const NominalMotor& limit = motors[i];
    DOCKYARD_CHECK(std::isfinite(motor.target) && std::isfinite(motor.speed_limit_rad_s) &&
                   std::isfinite(motor.accel_rad_s2) && std::isfinite(motor.current_limit_a));
    if (motor.mode == MotorMode::kVelocity)
      motor.target = std::clamp(motor.target, -limit.max_speed_rad_s, limit.max_speed_rad_s);
    motor.speed_limit_rad_s = std::clamp(motor.speed_limit_rad_s, 0.0, limit.max_speed_rad_s);
    motor.accel_rad_s2 = std::clamp(motor.accel_rad_s2, 0.0, limit.max_accel_rad_s2);
    motor.current_limit_a = std::clamp(motor.current_limit_a, 0.0, limit.max_current_a);
  }
}

}  // namespace dockyard
