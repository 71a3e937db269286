#include "controller/custom/twist_limits.h"

#include <algorithm>
#include <cmath>

namespace dockyard::custom {
namespace {

// Braking begins as if the accelerations were this share, for delays of motors. Assumed, 0.4-0.8.
constexpr double kBrakingShare = 0.5;
constexpr double kLeast_rad_s = 0.03;  // of a turn that is not over; assumed, 0.01-0.1

double Ramped(double from, double to, double step) {
  return from + std::clamp(to - from, -step, step);
}

double OutOfDeadBand(double value, double wanted, double dead) {
  if (wanted == 0.0 || std::abs(value) >= dead) return value;
  return std::copysign(dead, wanted);
}

}  // namespace

Twist TwistLimits::Step(const Twist& wanted, double dt_s) {
  ramp_.speed_m_s = Ramped(ramp_.speed_m_s, wanted.speed_m_s, options_.accel_m_s2 * dt_s);
  ramp_.turn_rad_s = Ramped(ramp_.turn_rad_s, wanted.turn_rad_s, options_.accel_rad_s2 * dt_s);
  twist_ = ramp_;
  twist_.speed_m_s = OutOfDeadBand(ramp_.speed_m_s, wanted.speed_m_s, options_.dead_m_s);
  // Wheels that roll have overcome their friction: only a turn in place has a dead band.
  if (wanted.speed_m_s == 0.0)
    twist_.turn_rad_s = OutOfDeadBand(ramp_.turn_rad_s, wanted.turn_rad_s, options_.dead_rad_s);
  return twist_;
}

double BrakingSpeed(double left_m, double end_m_s, double accel_m_s2) {
  const double accel = kBrakingShare * accel_m_s2;
  return std::sqrt(end_m_s * end_m_s + 2.0 * accel * std::max(0.0, left_m));
}

Twist TurnBy(double left_rad, const DockingOptions& options) {
  const double rate = std::sqrt(2.0 * kBrakingShare * options.accel_rad_s2 * std::abs(left_rad));
  return {0.0, std::copysign(std::clamp(rate, kLeast_rad_s, options.most_rad_s), left_rad)};
}

}  // namespace dockyard::custom
