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
// Of the search for a shaft's lead. Numerical.
constexpr int kHalvings = 40, kMostSecants = 12;
constexpr double kCloseShare = 4e-12;  // four times what the halvings leave

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
  if (command.mode != MotorMode::kBrake) at_.brake_bend_rad = 0.0;
  mode_ = command.mode;
  const double was_rad = at_.profile.angle_rad;
  if (driving) AdvanceAlong(command, dt_s);
  if (bend_nm_per_rad_ > 0.0) {
    const double before_rad = std::exchange(lead_rad_, Lead(command, angle_rad, speed_rad_s, dt_s));
    angle_rad += lead_rad_;
    speed_rad_s += (lead_rad_ - before_rad) / dt_s;
  }
  DriveOutput out = Work(command, angle_rad, speed_rad_s, dt_s, at_);
  out.lead_rad = lead_rad_;
  profile_moved_rad_ = driving ? at_.profile.angle_rad - was_rad : 0.0;
  return out;
}

// The gears pass on more with more lead and the motor's side gives less, so that halving finds it:
// to 1e-12 of the lead at the largest torque. Secants narrow it first: what is known to be below or
// above needs no trial.
double MotorDrive::Lead(const MotorCommand& command, double angle_rad, double speed_rad_s,
                        double dt_s) const {
  const double play_rad = 0.5 * motor_.backlash_rad;
  const double most_nm = LosslessTorquePerAmp() * motor_.max_current_a * 2.0 +
                         motor_.gear_friction_nm + motor_.brake_torque_nm;
  double low = -play_rad - most_nm / bend_nm_per_rad_, high = -low;
  double below = low, above = high;
  const auto TooMuch_nm = [&](double lead) {
    Working trial = at_;
    const double given_nm =
        Work(command, angle_rad + lead, speed_rad_s + (lead - lead_rad_) / dt_s, dt_s, trial)
            .torque_nm();
    const double much_nm =
        bend_nm_per_rad_ * (lead - std::clamp(lead, -play_rad, play_rad)) - given_nm;
    if (much_nm < 0.0 && lead > below) below = lead;
    if (much_nm >= 0.0 && lead < above) above = lead;
    return much_nm;
  };
  double last = lead_rad_, last_nm = TooMuch_nm(last);
  double slope = servo_stiffness_nm_per_rad_ + servo_damping_nms_per_rad_ / dt_s;
  const double close_rad = (high - low) * kCloseShare;
  for (int i = 0; i < kMostSecants && above - below > 2.0 * close_rad && slope > 0.0; ++i) {
    double next = last - last_nm / slope;
    // Past the root that the secant meets, so that the bracket closes from both sides.
    if (std::abs(next - last) <= close_rad) next += last_nm < 0.0 ? close_rad : -close_rad;
    if (next <= below || next >= above) next = 0.5 * (below + above);
    const double next_nm = TooMuch_nm(next);
    if (next != last) slope = (next_nm - last_nm) / (next - last);
    last = next;
    last_nm = next_nm;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double lead = 0.5 * (low + high);
    const bool is_below = lead <= below || (lead < above && TooMuch_nm(lead) < 0.0);
    (is_below ? low : high) = lead;
  }
  return 0.5 * (low + high);
}

DriveOutput MotorDrive::Work(const MotorCommand& command, double angle_rad, double speed_rad_s,
                             double dt_s, Working& at) const {
  DriveOutput out;
  const bool driving = mode_ == MotorMode::kVelocity || mode_ == MotorMode::kPosition;
  if (driving) out.motor_torque_nm = ServoTorque(command, angle_rad, speed_rad_s, at);
  ShaftBristle gears = gears_;
  gears.limit_nm =
      motor_.gear_friction_nm + (1.0 - motor_.gear_efficiency) * std::abs(out.motor_torque_nm);
  out.friction_torque_nm = BristleTorque(gears, speed_rad_s, dt_s, at.gear_bend_rad);
  if (mode_ == MotorMode::kBrake) {
    out.friction_torque_nm += BristleTorque(brake_, speed_rad_s, dt_s, at.brake_bend_rad);
  }
  if (!driving) return out;
  const bool turning = std::abs(speed_rad_s) > kStandstill_rad_s ||
                       std::abs(at.profile.speed_rad_s) > kStandstill_rad_s;
  out.current_a = std::abs(out.motor_torque_nm) / LosslessTorquePerAmp() +
                  (turning ? motor_.no_load_current_a : 0.0);
  return out;
}

void MotorDrive::AdvanceAlong(const MotorCommand& command, double dt_s) {
  if (motor_.profile == ProfileShape::kTrapezoid) {
    at_.profile = AdvanceProfile(at_.profile, command, motor_, dt_s);
    return;
  }
  if (!at_.on_move || command != move_command_) {
    move_ = SplineMove(at_.profile, command, motor_);
    move_command_ = command;
    move_time_s_ = 0.0;
    at_.on_move = true;
  }
  move_time_s_ += dt_s;
  at_.profile = move_.At(move_time_s_);
}

double MotorDrive::ServoTorque(const MotorCommand& command, double angle_rad, double speed_rad_s,
                               Working& at) const {
  const double current = std::clamp(command.current_limit_a, 0.0, motor_.max_current_a);
  const double limit = LosslessTorquePerAmp() * std::max(0.0, current - motor_.no_load_current_a);
  // Leash: a shaft that is dragged off its profile takes the profile along, at the distance where
  // the servo alone gives the limit; nothing winds up.
  const double leash = limit / servo_stiffness_nm_per_rad_;
  const double held = std::clamp(at.profile.angle_rad, angle_rad - leash, angle_rad + leash);
  if (held != at.profile.angle_rad) {
    at.profile = {held, at.profile.speed_rad_s};
    at.on_move = false;
  }
  const double torque = servo_stiffness_nm_per_rad_ * (at.profile.angle_rad - angle_rad) +
                        servo_damping_nms_per_rad_ * (at.profile.speed_rad_s - speed_rad_s);
  return std::clamp(torque, -limit, limit);
}

std::uint64_t MotorDrive::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, static_cast<std::uint64_t>(mode_));
  for (double value : {at_.profile.angle_rad, at_.profile.speed_rad_s, at_.profile.accel_rad_s2,
                       move_time_s_, move_.duration_s(), at_.gear_bend_rad, at_.brake_bend_rad}) {
    hash = HashDouble(hash, value);
  }
  return bend_nm_per_rad_ > 0.0 ? HashDouble(hash, lead_rad_) : hash;
}

}  // namespace dockyard
