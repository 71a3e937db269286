#include "sim/physics/drive.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

// Closed loop of the drive's angle servo, critically damped: 16 Hz (assumed, range 5-30 Hz).
constexpr double kServoRadPerS = 100.0;
// A shaft gives this much before its gears slide (assumed, range 0.5-5 mrad: gear backlash) ...
constexpr double kBristleTravelRad = 2e-3;
// ... but never so stiff that it rings faster than this, so that 1 ms steps carry it well.
constexpr double kBristleRadPerS = 150.0;
// A shaft that turns slower than this draws no no-load current.
constexpr double kStandstillRadPerS = 1e-3;

ShaftBristle MakeBristle(double limit_nm, double inertia_kg_m2) {
  if (limit_nm <= 0.0) return {};
  const double stiffness =
      std::min(limit_nm / kBristleTravelRad, inertia_kg_m2 * kBristleRadPerS * kBristleRadPerS);
  return {stiffness, std::sqrt(stiffness * inertia_kg_m2), limit_nm};
}

bool IsFinite(const MotorCommand& command) {
  return std::isfinite(command.target) && std::isfinite(command.speed_limit_rad_s) &&
         std::isfinite(command.accel_rad_s2) && std::isfinite(command.current_limit_a);
}

// The fastest speed from which the shaft still stops on the target, in steps of dt.
double StoppingSpeed(double distance_rad, double accel_rad_s2, double dt_s) {
  const double slope = accel_rad_s2 * dt_s;
  const double speed = std::sqrt(0.25 * slope * slope + 2.0 * accel_rad_s2 * distance_rad);
  return std::min(speed - 0.5 * slope, distance_rad / dt_s);
}

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

MotorDrive::MotorDrive(const MotorModel& motor, double inertia_kg_m2)
    : motor_(motor),
      gears_(MakeBristle(motor.gear_friction_nm, inertia_kg_m2)),
      brake_(MakeBristle(motor.brake_torque_nm, inertia_kg_m2)),
      servo_stiffness_nm_per_rad_(inertia_kg_m2 * kServoRadPerS * kServoRadPerS),
      servo_damping_nms_per_rad_(2.0 * inertia_kg_m2 * kServoRadPerS) {
  DOCKYARD_CHECK(inertia_kg_m2 > 0.0);
}

DriveOutput MotorDrive::Step(const MotorCommand& command, double angle_rad, double speed_rad_s,
                             double dt_s) {
  if (!IsFinite(command)) throw std::invalid_argument("motor command is not a finite number");
  const bool was_driving = mode_ == MotorMode::kVelocity || mode_ == MotorMode::kPosition;
  const bool driving = command.mode == MotorMode::kVelocity || command.mode == MotorMode::kPosition;
  if (driving && !was_driving) profile_ = {angle_rad, speed_rad_s};
  if (command.mode != MotorMode::kBrake) brake_bend_rad_ = 0.0;
  mode_ = command.mode;

  DriveOutput out;
  out.friction_torque_nm = BristleTorque(gears_, speed_rad_s, dt_s, gear_bend_rad_);
  if (mode_ == MotorMode::kBrake) {
    out.friction_torque_nm += BristleTorque(brake_, speed_rad_s, dt_s, brake_bend_rad_);
  }
  profile_moved_rad_ = 0.0;
  if (!driving) return out;
  out.motor_torque_nm = ServoTorque(command, angle_rad, speed_rad_s, dt_s);
  const bool turning = std::abs(speed_rad_s) > kStandstillRadPerS ||
                       std::abs(profile_.speed_rad_s) > kStandstillRadPerS;
  out.current_a = std::abs(out.motor_torque_nm) / motor_.torque_per_amp_nm +
                  (turning ? motor_.no_load_current_a : 0.0);
  return out;
}

double MotorDrive::ServoTorque(const MotorCommand& command, double angle_rad, double speed_rad_s,
                               double dt_s) {
  const double current = std::clamp(command.current_limit_a, 0.0, motor_.max_current_a);
  const double limit = motor_.torque_per_amp_nm * std::max(0.0, current - motor_.no_load_current_a);
  const double was_rad = profile_.angle_rad;
  profile_ = AdvanceProfile(profile_, command, motor_, dt_s);
  // Leash: a shaft that is dragged off its profile takes the profile along, at the distance where
  // the servo alone gives the limit; nothing winds up.
  const double leash = limit / servo_stiffness_nm_per_rad_;
  profile_.angle_rad = std::clamp(profile_.angle_rad, angle_rad - leash, angle_rad + leash);
  profile_moved_rad_ = profile_.angle_rad - was_rad;
  const double torque = servo_stiffness_nm_per_rad_ * (profile_.angle_rad - angle_rad) +
                        servo_damping_nms_per_rad_ * (profile_.speed_rad_s - speed_rad_s);
  return std::clamp(torque, -limit, limit);
}

std::uint64_t MotorDrive::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, static_cast<std::uint64_t>(mode_));
  for (double value : {profile_.angle_rad, profile_.speed_rad_s, gear_bend_rad_, brake_bend_rad_}) {
    hash = HashDouble(hash, value);
  }
  return hash;
}

}  // namespace dockyard
