#include "controller/motion/odometry.h"

namespace dockyard {

double MotorAngle(const RoverSheet& sheet, const SensorFrame& sensed, Motor motor) {
  const auto i = static_cast<std::size_t>(motor);
  return static_cast<double>(sensed.encoder_counts[i]) * sheet.motors[i].rad_per_count;
}

double ArmAngle(const RoverSheet& sheet, const SensorFrame& sensed) {
  return sheet.arm_at_zero_rad + MotorAngle(sheet, sensed, Motor::kArm);
}

double ArmElevation(const RoverSheet& sheet, const SensorFrame& sensed) {
  return -(sensed.imu.pitch_rad + ArmAngle(sheet, sensed));
}

Motion Odometer::Read(const SensorFrame& sensed) {
  const Last now{MotorAngle(sheet_, sensed, Motor::kLeftWheel),
                 MotorAngle(sheet_, sensed, Motor::kRightWheel), sensed.imu.pitch_rad,
                 sensed.imu.yaw_rad};
  Motion motion;
  if (last_) {
    const double rolled = 0.5 * (now.left_rad - last_->left_rad + now.right_rad - last_->right_rad);
    motion.length_m = sheet_.wheel_radius_m * (rolled + WrapPi(now.pitch_rad - last_->pitch_rad));
    motion.turn_rad = WrapPi(now.yaw_rad - last_->yaw_rad);
  }
  last_ = now;
  return motion;
}

}  // namespace dockyard
