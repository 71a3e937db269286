#include "controller/motion/drive.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr double kArrivedM = 0.004;  // well below the vision's 2.5 cm at 1 m (Tsai et al., V-E)

const MotorSheet& SheetOf(const RoverSheet& sheet, Motor motor) {
  return sheet.motors[static_cast<std::size_t>(motor)];
}
MotorCommand& CommandOf(Commands* commands, Motor motor) {
  return commands->motors[static_cast<std::size_t>(motor)];
}

}  // namespace

PathFollower::PathFollower(const Pose2& X_DR_start, std::vector<Arc> arcs)
    : arcs_(std::move(arcs)) {
  Pose2 pose = X_DR_start;
  for (const Arc& arc : arcs_) {
    starts_.push_back(pose);
    pose = Advance(pose, arc);
  }
}

Pose2 PathFollower::Reference() const {
  if (arcs_.empty()) return {};
  const std::size_t i = std::min(current_, arcs_.size() - 1);
  const double length = std::abs(arcs_[i].length_m);
  const double share = done() || length == 0.0 ? 1.0 : std::min(1.0, progress_m_ / length);
  return Advance(starts_[i], Part(arcs_[i], share));
}

double PathFollower::Remaining() const {
  double left = -progress_m_;
  for (std::size_t i = current_; i < arcs_.size(); ++i) left += std::abs(arcs_[i].length_m);
  return done() ? 0.0 : std::max(0.0, left);
}

Twist PathFollower::Follow(const Pose2& X_DR, double speed_m_s, const Steering& steering) {
  while (!done()) {
    const Arc& arc = arcs_[current_];
    const double direction = arc.length_m < 0.0 ? -1.0 : 1.0;
    const Pose2 ahead = Inverse(Reference()) * X_DR;
    progress_m_ = std::max(0.0, progress_m_ + direction * ahead.x);
    if (progress_m_ >= std::abs(arc.length_m) - kArrivedM) {
      ++current_;
      progress_m_ = 0.0;
      continue;
    }
    const Pose2 error = Inverse(Reference()) * X_DR;
    const double v = direction * speed_m_s, s = steering.settle_m;
    const double turn = v * arc.turn_rad / arc.length_m - 2.0 * std::abs(v) / s * error.heading -
                        v / (s * s) * error.y;
    return {v, std::clamp(turn, -steering.max_turn_rad_s, steering.max_turn_rad_s)};
  }
  return {};
}

void CommandWheels(const RoverSheet& sheet, const Twist& twist, double accel_rad_s2,
                   Commands* commands) {
  const double difference = 0.5 * sheet.track_m * twist.turn_rad_s;
  double left = (twist.speed_m_s - difference) / sheet.wheel_radius_m;
  double right = (twist.speed_m_s + difference) / sheet.wheel_radius_m;
  const double limit = std::min(SheetOf(sheet, Motor::kLeftWheel).max_speed_rad_s,
                                SheetOf(sheet, Motor::kRightWheel).max_speed_rad_s);
  const double fastest = std::max(std::abs(left), std::abs(right));
  if (fastest > limit) left *= limit / fastest, right *= limit / fastest;
  for (const Motor wheel : {Motor::kLeftWheel, Motor::kRightWheel}) {
    CommandOf(commands, wheel) = {.mode = MotorMode::kVelocity,
                                  .target = wheel == Motor::kLeftWheel ? left : right,
                                  .accel_rad_s2 = accel_rad_s2,
                                  .current_limit_a = SheetOf(sheet, wheel).max_current_a};
  }
}

void SetWheels(MotorMode mode, Commands* commands) {
  DOCKYARD_CHECK(mode == MotorMode::kFree || mode == MotorMode::kBrake);
  CommandOf(commands, Motor::kLeftWheel) = {.mode = mode};
  CommandOf(commands, Motor::kRightWheel) = {.mode = mode};
}

double CurrentForTension(const RoverSheet& sheet, double tension_n) {
  const MotorSheet& spool = SheetOf(sheet, Motor::kSpool);
  return spool.no_load_current_a + tension_n * sheet.drum_radius_m / spool.torque_per_amp_nm;
}

double TensionFromCurrent(const RoverSheet& sheet, double current_a) {
  const MotorSheet& spool = SheetOf(sheet, Motor::kSpool);
  return std::max(0.0, current_a - spool.no_load_current_a) * spool.torque_per_amp_nm /
         sheet.drum_radius_m;
}

MotorCommand Winch(const RoverSheet& sheet, double reel_m_s, double tension_n,
                   double accel_rad_s2) {
  return {.mode = MotorMode::kVelocity,
          .target = reel_m_s / sheet.drum_radius_m,
          .accel_rad_s2 = accel_rad_s2,
          .current_limit_a = CurrentForTension(sheet, tension_n)};
}

Commands WithinLimits(const RoverSheet& sheet, const Commands& commands) {
  Commands bounded = commands;
  for (std::size_t i = 0; i < bounded.motors.size(); ++i) {
    MotorCommand& motor = bounded.motors[i];
    const MotorSheet& limit = sheet.motors[i];
    DOCKYARD_CHECK(std::isfinite(motor.target) && std::isfinite(motor.speed_limit_rad_s) &&
                   std::isfinite(motor.accel_rad_s2) && std::isfinite(motor.current_limit_a));
    if (motor.mode == MotorMode::kVelocity)
      motor.target = std::clamp(motor.target, -limit.max_speed_rad_s, limit.max_speed_rad_s);
    motor.speed_limit_rad_s = std::clamp(motor.speed_limit_rad_s, 0.0, limit.max_speed_rad_s);
    motor.accel_rad_s2 = std::clamp(motor.accel_rad_s2, 0.0, limit.max_accel_rad_s2);
    motor.current_limit_a = std::clamp(motor.current_limit_a, 0.0, limit.max_current_a);
  }
  return bounded;
}

}  // namespace dockyard
