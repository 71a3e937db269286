#include "controller/axel/odometry.h"

namespace dockyard::axel {

double MotorAngle(const Nominal& nominal, const SensorFrame& sensed, Motor motor) {
  const auto i = static_cast<std::size_t>(motor);
  return static_cast<double>(sensed.motors[i].encoder_counts) * nominal.motors[i].rad_per_count;
}

double ArmAngle(const Nominal& nominal, const SensorFrame& sensed) {
  return nominal.arm_at_zero_rad + MotorAngle(nominal, sensed, Motor::kArm);
}

double ArmElevation(const Nominal& nominal, const SensorFrame& sensed) {
  return -(sensed.imu.pitch_rad + ArmAngle(nominal, sensed));
}

Motion Odometer::Read(const SensorFrame& sensed) {
  const Last now{MotorAngle(nominal_, sensed, Motor::kLeftWheel),
                 MotorAngle(nominal_, sensed, Motor::kRightWheel), sensed.imu.pitch_rad,
                 sensed.imu.yaw_rad};
  Motion motion;
  if (last_) {
    const double rolled = 0.5 * (now.left_rad - last_->left_rad + now.right_rad - last_->right_rad);
    motion.length_m = nominal_.wheel_radius_m * (rolled + WrapPi(now.pitch_rad - last_->pitch_rad));
    motion.turn_rad = WrapPi(now.yaw_rad - last_->yaw_rad);
  }
  last_ = now;
  return motion;
}

}  // namespace dockyard::axel
