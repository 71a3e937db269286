#include "sim/drives/motor_drive.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

// Closed loop of the drive's angle servo, critically damped: 16 Hz (assumed, range 5-30 Hz).
constexpr double kServo_rad_s = 100.0;
// A shaft gives this much before its gears slide (assumed, range 0.5-5 mrad: gear backlash) ...
constexpr double kBristleTravel_rad = 2e-3;
// ... but never so stiff that it rings faster than this, so that 1 ms steps carry it well.
constexpr double kBristle_rad_s = 150.0;
// A shaft that turns slower than this draws no no-load current (assumed, range 1e-4 to 1e-2).
constexpr double kStandstill_rad_s = 1e-3;
// Stiffness over that of the servo, of teeth with backlash and no bend (assumed, range 10-1000).
constexpr double kTeethOverServo = 100.0;

ShaftBristle MakeBristle(double limit_nm, double inertia_kg_m2) {
  if (limit_nm <= 0.0) return {};
  const double stiffness =
      std::min(limit_nm / kBristleTravel_rad, inertia_kg_m2 * kBristle_rad_s * kBristle_rad_s);
  return {stiffness, std::sqrt(stiffness * inertia_kg_m2), limit_nm};
}

bool IsFinite(const MotorCommand& command) {
  return std::isfinite(command.target) && std::isfinite(command.speed_limit_rad_s) &&
         std::isfinite(command.accel_rad_s2) && std::isfinite(command.current_limit_a);
}

}  // namespace

MotorDrive::MotorDrive(const MotorModel& motor, double inertia_kg_m2)
    : motor_(motor),
      gears_(MakeBristle(motor.gear_friction_nm + (1.0 - motor.gear_efficiency) *
                                                      LosslessTorquePerAmp() * motor.max_current_a,
                         inertia_kg_m2)),
      brake_(MakeBristle(motor.brake_torque_nm, inertia_kg_m2)),
      servo_stiffness_nm_per_rad_(inertia_kg_m2 * kServo_rad_s * kServo_rad_s),
      servo_damping_nms_per_rad_(2.0 * inertia_kg_m2 * kServo_rad_s),
      bend_nm_per_rad_(motor.bend_nm_per_rad) {
  DOCKYARD_CHECK(inertia_kg_m2 > 0.0 && motor.gear_efficiency > 0.0);
  if (motor.backlash_rad > 0.0 && bend_nm_per_rad_ == 0.0) {
    bend_nm_per_rad_ = kTeethOverServo * servo_stiffness_nm_per_rad_;
  }
}

DriveOutput MotorDrive::Step(const MotorCommand& command, double angle_rad, double speed_rad_s,
                             double dt_s) {
  DOCKYARD_CHECK(IsFinite(command));
  angle_rad += motor_.homing_error_rad;
  const bool was_driving = mode_ == MotorMode::kVelocity || mode_ == MotorMode::kPosition;
  const bool driving = command.mode == MotorMode::kVelocity || command.mode == MotorMode::kPosition;
  if (driving && !was_driving) StartProfile(angle_rad + lead_rad_, speed_rad_s);
  if (command.mode != MotorMode::kBrake) brake_bend_rad_ = 0.0;
  mode_ = command.mode;
  const double was_rad = profile_.angle_rad;
  if (driving) AdvanceAlong(command, dt_s);
  if (bend_nm_per_rad_ > 0.0) {
    const double before_rad = std::exchange(lead_rad_, Lead(command, angle_rad, speed_rad_s, dt_s));
    angle_rad += lead_rad_;
    speed_rad_s += (lead_rad_ - before_rad) / dt_s;
  }
  DriveOutput out = Work(command, angle_rad, speed_rad_s, dt_s);
  out.lead_rad = lead_rad_;
  profile_moved_rad_ = driving ? profile_.angle_rad - was_rad : 0.0;
  return out;
}

// The gears pass on more with more lead and the motor's side gives less, so that halving finds it:
// to 1e-12 of the lead at the largest torque.
double MotorDrive::Lead(const MotorCommand& command, double angle_rad, double speed_rad_s,
                        double dt_s) const {
  const double play_rad = 0.5 * motor_.backlash_rad;
  const double most_nm = LosslessTorquePerAmp() * motor_.max_current_a * 2.0 +
                         motor_.gear_friction_nm + motor_.brake_torque_nm;
  double low = -play_rad - most_nm / bend_nm_per_rad_, high = -low;
  for (int i = 0; i < 40; ++i) {
    const double lead = 0.5 * (low + high);
    MotorDrive trial = *this;
    const double given_nm =
        trial.Work(command, angle_rad + lead, speed_rad_s + (lead - lead_rad_) / dt_s, dt_s)
            .torque_nm();
    const double passed_nm = bend_nm_per_rad_ * (lead - std::clamp(lead, -play_rad, play_rad));
    (passed_nm < given_nm ? low : high) = lead;
  }
  return 0.5 * (low + high);
}

DriveOutput MotorDrive::Work(const MotorCommand& command, double angle_rad, double speed_rad_s,
                             double dt_s) {
  DriveOutput out;
  const bool driving = mode_ == MotorMode::kVelocity || mode_ == MotorMode::kPosition;
  if (driving) out.motor_torque_nm = ServoTorque(command, angle_rad, speed_rad_s);
  gears_.limit_nm =
      motor_.gear_friction_nm + (1.0 - motor_.gear_efficiency) * std::abs(out.motor_torque_nm);
  out.friction_torque_nm = BristleTorque(gears_, speed_rad_s, dt_s, gear_bend_rad_);
  if (mode_ == MotorMode::kBrake) {
    out.friction_torque_nm += BristleTorque(brake_, speed_rad_s, dt_s, brake_bend_rad_);
  }
  if (!driving) return out;
  const bool turning = std::abs(speed_rad_s) > kStandstill_rad_s ||
                       std::abs(profile_.speed_rad_s) > kStandstill_rad_s;
  out.current_a = std::abs(out.motor_torque_nm) / LosslessTorquePerAmp() +
                  (turning ? motor_.no_load_current_a : 0.0);
  return out;
}

void MotorDrive::AdvanceAlong(const MotorCommand& command, double dt_s) {
  if (motor_.profile == ProfileShape::kTrapezoid) {
    profile_ = AdvanceProfile(profile_, command, motor_, dt_s);
    return;
  }
  if (!on_move_ || command != move_command_) {
    move_ = SplineMove(profile_, command, motor_);
    move_command_ = command;
    move_time_s_ = 0.0;
    on_move_ = true;
  }
  move_time_s_ += dt_s;
  profile_ = move_.At(move_time_s_);
}

double MotorDrive::ServoTorque(const MotorCommand& command, double angle_rad, double speed_rad_s) {
  const double current = std::clamp(command.current_limit_a, 0.0, motor_.max_current_a);
  const double limit = LosslessTorquePerAmp() * std::max(0.0, current - motor_.no_load_current_a);
  // Leash: a shaft that is dragged off its profile takes the profile along, at the distance where
  // the servo alone gives the limit; nothing winds up.
  const double leash = limit / servo_stiffness_nm_per_rad_;
  const double held = std::clamp(profile_.angle_rad, angle_rad - leash, angle_rad + leash);
  if (held != profile_.angle_rad) {
    profile_ = {held, profile_.speed_rad_s};
    on_move_ = false;
  }
  const double torque = servo_stiffness_nm_per_rad_ * (profile_.angle_rad - angle_rad) +
                        servo_damping_nms_per_rad_ * (profile_.speed_rad_s - speed_rad_s);
  return std::clamp(torque, -limit, limit);
}

std::uint64_t MotorDrive::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, static_cast<std::uint64_t>(mode_));
  for (double value : {profile_.angle_rad, profile_.speed_rad_s, profile_.accel_rad_s2,
                       move_time_s_, move_.duration_s(), gear_bend_rad_, brake_bend_rad_}) {
    hash = HashDouble(hash, value);
  }
  return bend_nm_per_rad_ > 0.0 ? HashDouble(hash, lead_rad_) : hash;
}

}  // namespace dockyard
