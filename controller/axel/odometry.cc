#include "controller/axel/odometry.h"

#include "controller/geometry/axle_attitude.h"

namespace dockyard::axel {
namespace {

struct Turned {
  double pitch_rad = 0.0, turn_rad = 0.0, roll_rad = 0.0;
};

// The inertial unit gives the body's rotation between two readings in its own axes. About a slope's
// normal that is another turn than about the vertical.
Turned TurnedOnGround(const ImuSample& from, const ImuSample& to, const GroundSlope& ground,
                      double heading_rad) {
  if (ground.level()) {
    const Attitude before = AttitudeOf(from), after = AttitudeOf(to);
    return {WrapPi(after.pitch_rad - before.pitch_rad), WrapPi(HeadingOf(to) - HeadingOf(from)),
            WrapPi(after.roll_rad - before.roll_rad)};
  }
  const Attitude before = ground.Against(from, heading_rad);
  const Eigen::Matrix3d R_DR =
      RotZ(heading_rad) * Tilt(before) * RotationOf(from).transpose() * RotationOf(to);
  const double heading_after = ToAxleAttitude(R_DR).heading;
  const Attitude after = ground.Against(to, heading_after);
  return {WrapPi(after.pitch_rad - before.pitch_rad), WrapPi(heading_after - heading_rad),
          WrapPi(after.roll_rad - before.roll_rad)};
}

}  // namespace

double MotorAngle(const Nominal& nominal, const SensorFrame& sensed, Motor motor) {
  const auto i = static_cast<std::size_t>(motor);
  return static_cast<double>(sensed.motors[i].encoder_counts) * nominal.motors[i].rad_per_count;
}

double ArmAngle(const Nominal& nominal, const SensorFrame& sensed) {
  return nominal.arm_at_zero_rad + MotorAngle(nominal, sensed, Motor::kArm);
}

Motion Odometer::Read(const SensorFrame& sensed, const GroundSlope& ground, double heading_rad) {
  const Last now{MotorAngle(nominal_, sensed, Motor::kLeftWheel),
                 MotorAngle(nominal_, sensed, Motor::kRightWheel), sensed.imu};
  Motion motion;
  if (last_) {
    const double rolled = 0.5 * (now.left_rad - last_->left_rad + now.right_rad - last_->right_rad);
    const Turned turned = TurnedOnGround(last_->imu, now.imu, ground, heading_rad);
    motion.length_m = nominal_.wheel_radius_m * (rolled + turned.pitch_rad);
    motion.turn_rad = turned.turn_rad;
    motion.wheel_turn_rad = nominal_.wheel_radius_m / nominal_.track_m *
                            (now.right_rad - last_->right_rad - now.left_rad + last_->left_rad);
    motion.lean_m = -nominal_.wheel_radius_m * turned.roll_rad;
  }
  last_ = now;
  return motion;
}

}  // namespace dockyard::axel
