#include "controller/axel/righting.h"

#include <cmath>

#include "controller/axel/drive.h"

namespace dockyard::axel {

void Righting::Begin(const Senses& senses) {
  moves_ = 0;
  left_ = false;
  over_since_.reset();
  Enter(Stage::kRest, senses);
}

bool Righting::TurnedOver(const Senses& senses, bool at_rest) {
  const bool over = senses.arm_trails() || (at_rest && !Upright(senses, options_));
  if (!over) over_since_.reset();
  if (over && !over_since_) over_since_ = senses.now();
  return over && senses.now() - *over_since_ >= options_.over_for;
}

void Righting::Enter(Stage stage, const Senses& senses) {
  const auto Within = [&](double turn_rad, double speed_rad_s) {
    const double seconds = options_.patience * std::abs(turn_rad) / speed_rad_s;
    return senses.now() + static_cast<Tick>(seconds / kTickSeconds) + options_.rest_limit;
  };
  stage_ = stage;
  held_rad_ = senses.arm_rad();
  slow_since_ = senses.now();
  switch (stage) {
    case Stage::kRest:
      deadline_ = senses.now() + options_.rest_limit;
      break;
    case Stage::kCounter:
      deadline_ = Within(senses.arm_rad(), options_.turn_rad_s);
      break;
    case Stage::kSwing:
      deadline_ = Within(ToSwing(senses), options_.swing_rad_s);
      break;
    case Stage::kTurn:
      deadline_ = Within(2.0 * kPi, options_.turn_rad_s);
      break;
    case Stage::kLeave:
      deadline_ = senses.now() + options_.leave_time;
      break;
  }
}

bool Righting::Rested(const Senses& senses) {
  if (senses.imu().rate_R.norm() > options_.rest_rad_s) slow_since_ = senses.now();
  return senses.now() - slow_since_ >= options_.rest_time || TooLong(senses);
}

double Righting::ToSwing(const Senses& senses) const {
  // Its turn from level ahead, downwards: trailing from 90 to 270 deg, then over the top, down to
  // the ground ahead at more than 360.
  double turned = -senses.elevation_rad();
  if (turned <= 0.5 * kPi) turned += 2.0 * kPi;
  return 2.0 * kPi + options_.down_rad - turned;
}

MotorCommand Righting::ArmTo(double arm_rad, double speed_rad_s) const {
  const NominalMotor& arm = nominal_.motors[static_cast<std::size_t>(Motor::kArm)];
  return {.mode = MotorMode::kPosition,
          .target = arm_rad - nominal_.arm_at_zero_rad,
          .speed_limit_rad_s = speed_rad_s,
          .accel_rad_s2 = options_.accel_rad_s2,
          .current_limit_a = arm.max_current_a};
}

Righting::Status Righting::Step(const Senses& senses, Commands* commands) {
  MotorCommand& arm = commands->motors[static_cast<std::size_t>(Motor::kArm)];
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] = {.mode = MotorMode::kFree};
  const bool rolls = stage_ == Stage::kCounter || stage_ == Stage::kTurn;
  SetWheels(rolls ? MotorMode::kFree : MotorMode::kBrake, commands);
  switch (stage_) {
    case Stage::kRest: {
      arm = ArmTo(held_rad_, options_.turn_rad_s);
      if (!Rested(senses)) break;
      const bool trails = senses.arm_trails();
      if (!trails && Upright(senses, options_)) return Status::kDone;
      // One try is a swing and a turn.
      if (moves_ == 2 * options_.tries) return Status::kFailed;
      if (moves_ >= 2 && !left_) {
        Enter(Stage::kLeave, senses);
        left_ = true;
        break;
      }
      ++moves_;
      left_ = false;
      const bool counters = std::abs(WrapPi(senses.arm_rad())) <= options_.counter_rad;
      Enter(!trails ? Stage::kTurn : counters ? Stage::kSwing : Stage::kCounter, senses);
      break;
    }
    case Stage::kCounter:
      arm = ArmTo(0.0, options_.turn_rad_s);
      if (std::abs(senses.arm_rad()) > 0.5 * options_.counter_rad && !TooLong(senses)) break;
      Enter(Stage::kSwing, senses);
      break;
    case Stage::kSwing: {
      const double left = ToSwing(senses);
      arm = ArmTo(senses.arm_rad() + left, options_.swing_rad_s);
      if (left > options_.near_rad && !TooLong(senses)) break;
      Enter(Stage::kRest, senses);
      break;
    }
    case Stage::kTurn:
      // The tip lies still, so an arm turned by the body's pitch leaves the body level.
      arm = ArmTo(WrapPi(senses.arm_rad() + senses.pitch_rad()), options_.turn_rad_s);
      if (std::abs(senses.pitch_rad()) > options_.near_rad && !senses.arm_trails() &&
          !TooLong(senses)) {
        break;
      }
      Enter(Stage::kRest, senses);
      break;
    case Stage::kLeave: {
      const double away_m_s = senses.arm_trails() ? options_.leave_m_s : -options_.leave_m_s;
      CommandWheels(nominal_, {away_m_s, 0.0}, options_.leave_accel_rad_s2, commands);
      arm = ArmTo(held_rad_, options_.turn_rad_s);
      if (TooLong(senses)) Enter(Stage::kRest, senses);
      break;
    }
  }
  return Status::kUnderWay;
}

}  // namespace dockyard::axel
