#include "controller/raposa/odometry.h"

#include "controller/motion/arcs.h"

namespace dockyard::raposa {
double MotorAngle(const Nominal& nominal, const SensorFrame& sensed, Motor motor) {
  const auto i = static_cast<std::size_t>(motor);
  return static_cast<double>(sensed.motors[i].encoder_counts) * nominal.motors[i].rad_per_count;
}

BeltMotion MotionOfBelts(const Nominal& nominal, double left_rad, double right_rad) {
  const double radius_m = nominal.sprocket_radius_m;
  return {.length_m = -0.5 * radius_m * (right_rad + left_rad),
          .turn_rad = radius_m * (right_rad - left_rad) / nominal.effective_gauge_m};
}

BeltSpeeds SpeedsOfBelts(const Nominal& nominal, const Twist& twist_N) {
  const double across_m_s = 0.5 * nominal.effective_gauge_m * twist_N.turn_rad_s;
  return {.left_rad_s = (-twist_N.speed_m_s - across_m_s) / nominal.sprocket_radius_m,
          .right_rad_s = (-twist_N.speed_m_s + across_m_s) / nominal.sprocket_radius_m};
}

BeltMotion BeltOdometry::Update(const SensorFrame& sensed) {
  const Angles now{MotorAngle(nominal_, sensed, Motor::kLeftBelt),
                   MotorAngle(nominal_, sensed, Motor::kRightBelt)};
  BeltMotion motion;
  if (last_) {
    motion =
        MotionOfBelts(nominal_, now.left_rad - last_->left_rad, now.right_rad - last_->right_rad);
    X_ON_ = Advance(X_ON_, Arc{motion.length_m, motion.turn_rad});
  }
  last_ = now;
  return motion;
}

}  // namespace dockyard::raposa
