#include "controller/axel/drive.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard::axel {
namespace {

const NominalMotor& NominalOf(const Nominal& nominal, Motor motor) {
  return nominal.motors[static_cast<std::size_t>(motor)];
}

}  // namespace

void CommandWheels(const Nominal& nominal, const Twist& twist, double accel_rad_s2,
                   Commands* commands) {
  const double difference = 0.5 * nominal.track_m * twist.turn_rad_s;
  double left = (twist.speed_m_s - difference) / nominal.wheel_radius_m;
  double right = (twist.speed_m_s + difference) / nominal.wheel_radius_m;
  const double limit = std::min(NominalOf(nominal, Motor::kLeftWheel).max_speed_rad_s,
                                NominalOf(nominal, Motor::kRightWheel).max_speed_rad_s);
  const double fastest = std::max(std::abs(left), std::abs(right));
  if (fastest > limit) left *= limit / fastest, right *= limit / fastest;
  for (const Motor wheel : {Motor::kLeftWheel, Motor::kRightWheel}) {
    CommandOf(commands, wheel) = {.mode = MotorMode::kVelocity,
                                  .target = wheel == Motor::kLeftWheel ? left : right,
                                  .accel_rad_s2 = accel_rad_s2,
                                  .current_limit_a = NominalOf(nominal, wheel).max_current_a};
  }
}

void SetWheels(MotorMode mode, Commands* commands) {
  DOCKYARD_CHECK(mode == MotorMode::kFree || mode == MotorMode::kBrake);
  CommandOf(commands, Motor::kLeftWheel) = {.mode = mode};
  CommandOf(commands, Motor::kRightWheel) = {.mode = mode};
}

void LimitThrust(const Nominal& nominal, double thrust_n, Commands* commands) {
  for (const Motor wheel : {Motor::kLeftWheel, Motor::kRightWheel}) {
    const NominalMotor& motor = NominalOf(nominal, wheel);
    const double torque_nm = 0.5 * thrust_n * nominal.wheel_radius_m;
    CommandOf(commands, wheel).current_limit_a = std::min(
        motor.max_current_a, motor.no_load_current_a + torque_nm / motor.torque_per_amp_nm);
  }
}

double WheelThrust(const Nominal& nominal, const SensorFrame& sensed) {
  double thrust_n = 0.0;
  for (const Motor wheel : {Motor::kLeftWheel, Motor::kRightWheel}) {
    const NominalMotor& motor = NominalOf(nominal, wheel);
    const double current_a = sensed.motors[static_cast<std::size_t>(wheel)].current_a;
    const double driving_a = std::max(0.0, current_a - motor.no_load_current_a);
    thrust_n += driving_a * motor.torque_per_amp_nm / nominal.wheel_radius_m;
  }
  return thrust_n;
}

double CurrentForTension(const Nominal& nominal, double tension_n) {
  const NominalMotor& spool = NominalOf(nominal, Motor::kSpool);
  return spool.no_load_current_a + tension_n * nominal.drum_radius_m / spool.torque_per_amp_nm;
}

double TensionFromCurrent(const Nominal& nominal, double current_a) {
  const NominalMotor& spool = NominalOf(nominal, Motor::kSpool);
  return std::max(0.0, current_a - spool.no_load_current_a) * spool.torque_per_amp_nm /
         nominal.drum_radius_m;
}

MotorCommand PayOut(const Nominal& nominal, double speed_m_s, double accel_rad_s2) {
  return {.mode = MotorMode::kVelocity,
          .target = -speed_m_s / nominal.drum_radius_m,
          .accel_rad_s2 = accel_rad_s2,
          .current_limit_a = nominal.motors[static_cast<std::size_t>(Motor::kSpool)].max_current_a};
}

MotorCommand Winch(const Nominal& nominal, double reel_m_s, double tension_n, double accel_rad_s2) {
  return {.mode = MotorMode::kVelocity,
          .target = reel_m_s / nominal.drum_radius_m,
          .accel_rad_s2 = accel_rad_s2,
          .current_limit_a = CurrentForTension(nominal, tension_n)};
}

}  // namespace dockyard::axel
