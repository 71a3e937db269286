#include "controller/axel/leg.h"

#include <algorithm>
#include <cmath>

#include "controller/axel/mouth_way.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {

void ArmLevel::Level(const Senses& senses, double target_pitch_rad) {
  const Tick since = last_level_ < 0 ? 0 : senses.now() - last_level_;
  last_level_ = senses.now();
  if (!wanted_rad_) wanted_rad_ = senses.arm_rad();
  const double error = senses.pitch_rad() - target_pitch_rad;
  if (std::abs(error) < options_.dead_band_rad) return;
  // The time of a pause between two calls is not made up for.
  const double seconds = kTickSeconds * static_cast<double>(std::min(since, 2 * kControlPeriod));
  const double rate = std::clamp(options_.level_gain_per_s * error, -options_.level_rate_rad_s,
                                 options_.level_rate_rad_s);
  // The arm may have gone round: its limits are about the body's front in the turn in which it is.
  const double turn_rad = 2.0 * kPi * std::round(senses.arm_rad() / (2.0 * kPi));
  *wanted_rad_ = turn_rad + std::clamp(*wanted_rad_ + rate * seconds - turn_rad,
                                       -options_.limit_rad, options_.limit_rad);
}

MotorCommand ArmLevel::Hold(const Senses& senses) {
  if (!wanted_rad_) wanted_rad_ = senses.arm_rad();
  const NominalMotor& arm = nominal_.motors[static_cast<std::size_t>(Motor::kArm)];
  return {.mode = MotorMode::kPosition,
          .target = *wanted_rad_ - nominal_.arm_at_zero_rad,
          .speed_limit_rad_s = options_.speed_rad_s,
          .accel_rad_s2 = options_.accel_rad_s2,
          .current_limit_a = arm.max_current_a};
}

LegDriver::LegDriver(const Nominal& nominal, const AxelOptions& options, const Pose2& X_DR_start,
                     std::vector<Arc> arcs, const Speed& speed, Tick now)
    : nominal_(nominal),
      options_(options),
      tether_(TetherGeometryOf(nominal)),
      dig_watch_(tether_, options.dig),
      follower_(X_DR_start, std::move(arcs)),
      speed_(speed) {
  const double slowest = std::min(speed.forward_m_s, speed.reverse_m_s);
  const double seconds = options.drive.patience * follower_.Remaining() / slowest + 5.0;
  deadline_ = now + static_cast<Tick>(seconds / kTickSeconds);
}

void LegDriver::Guard(const Senses& senses, bool forward) {
  if (paused_since_) {
    const bool enough = senses.elevation_rad() < options_.drive.arm_resume_rad;
    const bool too_long = senses.now() - *paused_since_ > options_.drive.guard_limit;
    if (!enough && !too_long) return;
    deadline_ += senses.now() - *paused_since_;
    paused_since_.reset();
    // Reeling does not bring it down: drive for a while before trying again.
    if (too_long) guard_off_until_ = senses.now() + options_.drive.guard_limit;
  } else if (forward && senses.elevation_rad() > options_.drive.arm_guard_rad &&
             senses.now() >= guard_off_until_) {
    paused_since_ = senses.now();
  }
}

Pose2 LegDriver::Beside(const Pose2& X_DR, double drift) const {
  Pose2 beside = Inverse(follower_.Reference()) * X_DR;
  beside.heading += follower_.forward() ? drift : -drift;
  return beside;
}

// Straight ahead the tether helps, from the side it turns the rover and drags it off its path.
double LegDriver::Tension(const Senses& senses, bool forward) const {
  const TetherOptions& tether = options_.tether;
  if (!forward) return tether.reverse_tension_n;
  const Eigen::Vector3d slope = ExposedTetherSlope(tether_, senses.pose(), senses.elevation_rad());
  const double aside_rad = std::asin(std::min(1.0, std::abs(slope.z()) / tether_.arm_m));
  return std::min(TensionAside(tether, aside_rad), TautTension(nominal_, options_, senses));
}

MotorCommand LegDriver::Spool(const Senses& senses, const Twist& twist) const {
  const TetherOptions& tether = options_.tether;
  const double shorten = -ExposedTetherRate(tether_, senses.pose(), senses.elevation_rad(),
                                            twist.speed_m_s, twist.turn_rad_s);
  if (speed_.pays_out && shorten < 0.0) return PayOut(nominal_, -shorten, tether.accel_rad_s2);
  const double reel = std::max(0.0, shorten) + tether.catch_up_m_s;
  const double wanted = Tension(senses, twist.speed_m_s >= 0.0);
  const double friction = shorten < 0.0 ? -nominal_.spool_friction_n : nominal_.spool_friction_n;
  return Winch(nominal_, reel, std::max(0.0, wanted + friction), tether.accel_rad_s2);
}

// A tether aside turns the rover against its wheels, which slip: they turn by that much more.
Twist LegDriver::AgainstSlip(const Senses& senses, const Twist& twist) const {
  const double most = options_.drive.yaw_slip_rad_s;
  return {twist.speed_m_s, twist.turn_rad_s + std::clamp(senses.yaw_slip_rad_s(), -most, most)};
}

// A rover whose body lies on a rock: the wheel beside the rock spins, and what is made up for that
// stops the other one, which alone has ground. Both then turn alike, as with a locked differential.
bool LegDriver::Locked(const Senses& senses) {
  const DriveOptions& drive = options_.drive;
  if (std::abs(senses.yaw_slip_rad_s()) <= drive.yaw_slip_rad_s) {
    spinning_since_.reset();
  } else if (!spinning_since_) {
    spinning_since_ = senses.now();
  } else if (senses.now() - *spinning_since_ >= drive.spin_after) {
    spinning_since_.reset();
    locked_until_ = senses.now() + drive.lock_for;
  }
  return senses.now() < locked_until_;
}

LegDriver::Status LegDriver::Drive(Senses* senses, Commands* commands) {
  const bool forward = follower_.forward();
  Twist twist = follower_.Follow(senses->pose(), forward ? speed_.forward_m_s : speed_.reverse_m_s,
                                 speed_.steering, senses->side_drift());
  if (speed_.by_tip)
    twist.turn_rad_s = TurnForTip(tether_.arm_m, senses->pose(), twist.speed_m_s,
                                  senses->side_drift(), speed_.steering);
  Guard(*senses, forward);
  if (paused_since_) twist = {};
  Twist wheels = twist;
  if (Locked(*senses)) {
    wheels.turn_rad_s = 0.0;
  } else if (!paused_since_) {
    wheels = AgainstSlip(*senses, twist);
  }
  CommandWheels(nominal_, wheels, options_.drive.wheel_accel_rad_s2, commands);
  LimitThrust(nominal_, speed_.thrust_n, commands);
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      paused_since_ ? TautWinch(nominal_, options_.tether, TautTension(nominal_, options_, *senses))
                    : Spool(*senses, twist);
  // A tether that is driven out is slack, and tells no length.
  if (!speed_.pays_out) senses->UseTether(options_.tether.taut_share * Tension(*senses, forward));
  if (follower_.done()) return Status::kArrived;
  if (!speed_.by_tip && !paused_since_ && dig_watch_.Digs(*senses)) return Status::kDigs;
  return senses->now() > deadline_ && !paused_since_ ? Status::kFellShort : Status::kUnderWay;
}

double TensionAside(const TetherOptions& tether, double aside_rad) {
  const double share = (aside_rad - tether.ahead_rad) / (tether.aside_rad - tether.ahead_rad);
  return std::lerp(tether.drive_tension_n, tether.aside_tension_n, std::clamp(share, 0.0, 1.0));
}

MotorCommand TautWinch(const Nominal& nominal, const TetherOptions& options, double tension_n) {
  return Winch(nominal, options.tighten_m_s, tension_n + nominal.spool_friction_n,
               options.accel_rad_s2);
}

// A spool whose gears lose a quarter gives way at 1.7 times the tension that it reels with.
MotorCommand HoldingWinch(const Nominal& nominal, const TetherOptions& options, double tension_n) {
  return Winch(nominal, 0.0, tension_n + nominal.spool_friction_n, options.accel_rad_s2);
}

bool TurnInPlace(const Nominal& nominal, const AxelOptions& options, double amount_rad,
                 double turned_rad, Commands* commands) {
  const double left = WrapPi(amount_rad - turned_rad);
  if (left * amount_rad <= 0.0) return true;
  const double rate = amount_rad < 0.0 ? -options.drive.turn_rad_s : options.drive.turn_rad_s;
  CommandWheels(nominal, {0.0, rate}, options.drive.wheel_accel_rad_s2, commands);
  const TetherOptions& tether = options.tether;
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      Winch(nominal, tether.catch_up_m_s, tether.reverse_tension_n, tether.accel_rad_s2);
  return false;
}

bool ReverseStraight(const Nominal& nominal, const AxelOptions& options, double amount_m,
                     double rolled_m, Commands* commands) {
  if (rolled_m <= -amount_m) return true;
  const DriveOptions& drive = options.drive;
  CommandWheels(nominal, {-drive.reverse_m_s, 0.0}, drive.wheel_accel_rad_s2, commands);
  const TetherOptions& tether = options.tether;
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      Winch(nominal, tether.catch_up_m_s, tether.reverse_tension_n, tether.accel_rad_s2);
  return false;
}

void DriveOut(const Nominal& nominal, const AxelOptions& options, double pull_n,
              Commands* commands) {
  CommandWheels(nominal, {options.drive.approach_m_s, 0.0}, options.drive.wheel_accel_rad_s2,
                commands);
  const TetherOptions& tether = options.tether;
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      Winch(nominal, tether.tighten_m_s, pull_n, tether.accel_rad_s2);
}

void StandStill(const Nominal& nominal, const DriveOptions& options, Tick since_stop,
                Commands* commands) {
  if (since_stop < options.stop_time) {
    CommandWheels(nominal, {}, options.wheel_accel_rad_s2, commands);
  } else {
    SetWheels(MotorMode::kBrake, commands);
  }
}

}  // namespace dockyard::axel
