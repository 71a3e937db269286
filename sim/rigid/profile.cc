#include "sim/rigid/profile.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

// The fastest speed from which the shaft still stops on the target, in steps of dt.
double StoppingSpeed(double distance_rad, double accel_rad_s2, double dt_s) {
  const double slope = accel_rad_s2 * dt_s;
  const double speed = std::sqrt(0.25 * slope * slope + 2.0 * accel_rad_s2 * distance_rad);
  return std::min(speed - 0.5 * slope, distance_rad / dt_s);
}

// Samples at which a spline is held against its limits, and the step by which it is stretched.
constexpr int kSamples = 64;
constexpr double kStretch = 1.05;
constexpr int kMostStretches = 200;
constexpr double kSlack = 1.0 + 1e-9;  // for rounding

}  // namespace

ProfileState AdvanceProfile(const ProfileState& at, const MotorCommand& command,
                            const MotorModel& motor, double dt_s) {
  const double accel = std::clamp(command.accel_rad_s2, 0.0, motor.max_accel_rad_s2);
  double wanted = 0.0;
  if (command.mode == MotorMode::kVelocity) {
    wanted = std::clamp(command.target, -motor.max_speed_rad_s, motor.max_speed_rad_s);
  } else {
    const double to_go = command.target - at.angle_rad;
    const double cruise = std::clamp(command.speed_limit_rad_s, 0.0, motor.max_speed_rad_s);
    wanted = std::copysign(std::min(cruise, StoppingSpeed(std::abs(to_go), accel, dt_s)), to_go);
  }
  ProfileState next;
  next.speed_rad_s =
      std::clamp(wanted, at.speed_rad_s - accel * dt_s, at.speed_rad_s + accel * dt_s);
  next.angle_rad = at.angle_rad + next.speed_rad_s * dt_s;
  return next;
}

SplineMove::SplineMove(const ProfileState& from, const MotorCommand& command,
                       const MotorModel& motor) {
  const double accel = std::clamp(command.accel_rad_s2, 1e-6, motor.max_accel_rad_s2);
  const bool to_speed = command.mode == MotorMode::kVelocity;
  double speed = motor.max_speed_rad_s, target = 0.0;
  if (to_speed) {
    target = std::clamp(command.target, -speed, speed);
    duration_s_ = 1.5 * std::abs(target - from.speed_rad_s) / accel;
  } else {
    target = command.target;
    speed = std::clamp(command.speed_limit_rad_s, 1e-6, speed);
    const double way = std::abs(target - from.angle_rad);
    duration_s_ = std::max(1.875 * way / speed, std::sqrt(10.0 / std::sqrt(3.0) * way / accel));
  }
  duration_s_ = std::max(duration_s_, 1e-3);
  const double most_speed = std::max(speed, std::abs(from.speed_rad_s)) * kSlack;
  const double most_accel = std::max(accel, std::abs(from.accel_rad_s2)) * kSlack;
  Fit(from, command, target);
  for (int i = 0; i < kMostStretches && !Keeps(most_speed, most_accel); ++i) {
    duration_s_ *= kStretch;
    Fit(from, command, target);
  }
}

void SplineMove::Fit(const ProfileState& from, const MotorCommand& command, double target) {
  const double T = duration_s_, v = from.speed_rad_s, a = from.accel_rad_s2;
  c_ = {from.angle_rad, v, 0.5 * a, 0.0, 0.0, 0.0};
  if (command.mode == MotorMode::kVelocity) {
    c_[4] = (v + 0.5 * a * T - target) / (2.0 * T * T * T);
    c_[3] = (-a - 12.0 * c_[4] * T * T) / (6.0 * T);
    return;
  }
  // The error at the end in angle, speed and acceleration, in units of the way.
  const double D = target - from.angle_rad - v * T - 0.5 * a * T * T;
  const double V = (-v - a * T) * T, A = -a * T * T;
  c_[3] = (10.0 * D - 4.0 * V + 0.5 * A) / (T * T * T);
  c_[4] = (-15.0 * D + 7.0 * V - A) / (T * T * T * T);
  c_[5] = (6.0 * D - 3.0 * V + 0.5 * A) / (T * T * T * T * T);
}

bool SplineMove::Keeps(double speed_rad_s, double accel_rad_s2) const {
  for (int i = 0; i <= kSamples; ++i) {
    const ProfileState at = At(duration_s_ * i / kSamples);
    if (std::abs(at.speed_rad_s) > speed_rad_s || std::abs(at.accel_rad_s2) > accel_rad_s2) {
      return false;
    }
  }
  return true;
}

ProfileState SplineMove::At(double time_s) const {
  const double t = std::min(time_s, duration_s_);
  ProfileState at;
  at.angle_rad = c_[0] + t * (c_[1] + t * (c_[2] + t * (c_[3] + t * (c_[4] + t * c_[5]))));
  at.speed_rad_s =
      c_[1] + t * (2.0 * c_[2] + t * (3.0 * c_[3] + t * (4.0 * c_[4] + t * 5.0 * c_[5])));
  at.accel_rad_s2 = 2.0 * c_[2] + t * (6.0 * c_[3] + t * (12.0 * c_[4] + t * 20.0 * c_[5]));
  at.angle_rad += at.speed_rad_s * (time_s - t);  // on at the speed reached: zero on a target
  return at;
}

}  // namespace dockyard
