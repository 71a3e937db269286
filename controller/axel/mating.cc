#include "controller/axel/mating.h"

#include <algorithm>
#include <cmath>

#include "controller/axel/drive.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {

namespace {

/// From the axle's middle to the tip, as a unit vector in the body's frame.
Eigen::Vector3d ArmInBody(double arm_rad) { return {std::cos(arm_rad), 0.0, -std::sin(arm_rad)}; }

}  // namespace

double DepthBySighting(const Nominal& nominal, const Pose3& X_RB, double arm_rad) {
  const Eigen::Vector3d p_RT = nominal.arm_length_m * ArmInBody(arm_rad);
  // Along the ground, not along the cone's axis: 1 mm less at 5 deg of tilt and 0.23 m.
  return -(nominal.X_DB * Inverse(X_RB) * p_RT).x();
}

double AskewBySighting(const Nominal& nominal, const Pose3& X_RB, double arm_rad) {
  const Eigen::Vector3d arm_D = (nominal.X_DB * Inverse(X_RB)).R * ArmInBody(arm_rad);
  return std::atan2(arm_D.y(), -arm_D.x());
}

SeatRuling RuleSeat(const SeatKnowledge& known, double seat_depth_m, const MateOptions& options) {
  if (known.by_image) {
    const bool deep = known.by_image->depth_m >= seat_depth_m - options.seat_margin_m;
    const bool straight = std::abs(known.by_image->askew_rad) <= options.lean_limit_rad;
    if (!deep) return SeatRuling::kShort;
    return straight ? SeatRuling::kSeated : SeatRuling::kAskew;
  }
  if (known.depth_by_drum_m < seat_depth_m - options.seat_margin_m) return SeatRuling::kShort;
  if (!known.taken_up_by_push_m) return SeatRuling::kUnproven;
  const bool firm = *known.taken_up_by_push_m < options.wiggle_gain_m;
  return firm ? SeatRuling::kSeated : SeatRuling::kShort;
}

bool Straighten::Step(const Nominal& nominal, const Senses& senses, const MateOptions& options,
                      Commands* commands) {
  if (std::abs(lean_rad_) <= options.straighten_rad) return true;
  if (!since_) {
    since_ = senses.now();
    yaw_rad_ = senses.yaw_rad();
  }
  if (stopped_) return senses.now() - *stopped_ >= options.straighten_rest;
  const bool straight = LeanLeft(senses) * lean_rad_ <= options.straight_rad * std::abs(lean_rad_);
  if (straight || senses.now() - *since_ >= options.straighten_limit) {
    stopped_ = senses.now();
    return false;
  }
  // Left is positive for the turn; a lean to D's +y is one to the right of a rover that faces it.
  const double rate = std::copysign(options.straighten_rad_s, lean_rad_);
  CommandWheels(nominal, {0.0, rate}, options.straighten_accel_rad_s2, commands);
  return false;
}

double Straighten::LeanLeft(const Senses& senses) const {
  return since_ ? lean_rad_ - WrapPi(senses.yaw_rad() - yaw_rad_) : lean_rad_;
}

bool Entry::Over(const Senses& senses, double tip_gap_m) {
  const bool pushes =
      senses.wheel_thrust_n() >= options_.mate.contact_share * options_.mate.enter_thrust_n;
  const Tick still = still_.Still(senses.now(), senses.rolled_m());
  felt_ = pushes && still >= options_.mate.contact_after;
  const bool level = std::abs(senses.attitude().roll_rad) <= options_.mate.level_rad;
  return felt_ || (tip_gap_m <= options_.mate.enter_gap_m && level);
}

void ReelIn::Begin(const Senses& senses, double tip_gap_m) {
  reeled_at_mouth_m_ = senses.reeled_m() + tip_gap_m;
  wiggles_ = 0;
  gentle_ = true;
  wiggle_since_.reset();
  at_wiggle_m_ = senses.reeled_m();
  still_.Reset();
}

void ReelIn::Wiggle(const Senses& senses) {
  ++wiggles_;
  wiggle_since_ = senses.now();
  at_wiggle_m_ = senses.reeled_m();
  still_.Reset();
}

double ReelIn::DepthByDrum(const Senses& senses) const {
  return senses.reeled_m() - reeled_at_mouth_m_;
}

// To one side, twice as long to the other, and back.
void ReelIn::TurnToAndFro(Tick since, Commands* commands) const {
  const Tick quarter = options_.mate.wiggle_quarter;
  const double side = since < quarter || since >= 3 * quarter ? 1.0 : -1.0;
  const double rate = side * wiggles_ * options_.mate.wiggle_rad_s;
  CommandWheels(nominal_, {0.0, rate}, options_.mate.wiggle_accel_rad_s2, commands);
}

// Over half a pitch and back, the spool giving way meanwhile.
void ReelIn::RollToAndFro(Tick since, Commands* commands) const {
  const Tick half = 2 * options_.mate.wiggle_quarter;
  const double speed_m_s =
      0.5 * nominal_.paddle_pitch_m / (kTickSeconds * static_cast<double>(half));
  CommandWheels(nominal_, {since < half ? -speed_m_s : speed_m_s, 0.0},
                options_.drive.wheel_accel_rad_s2, commands);
  const TetherOptions& tether = options_.tether;
  if (since < half)
    commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
        Winch(nominal_, tether.reel_m_s, tether.reverse_tension_n, tether.accel_rad_s2);
}

// Gently, wheels and spool together roll the rover over its paddles. What that does not bring in,
// the spool's whole pull does. An arm in the cone bears that pull, so the wheels alone push the
// station.
void ReelIn::Pull(const Senses& senses, Tick still, Commands* commands) const {
  const TetherOptions& tether = options_.tether;
  const double gentle_n =
      std::min(options_.mate.gentle_tension_n, SurePull(nominal_, options_.hold, senses));
  const double tension_n = gentle_ ? gentle_n : tether.reel_tension_n;
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      Winch(nominal_, tether.reel_m_s, tension_n + nominal_.spool_friction_n, tether.accel_rad_s2);
  if (!gentle_ && still >= options_.mate.free_after) {
    SetWheels(MotorMode::kFree, commands);
  } else {
    CommandWheels(nominal_, {tether.reel_m_s, 0.0}, options_.drive.wheel_accel_rad_s2, commands);
    const bool moves = still < options_.mate.moving_after;
    LimitThrust(nominal_, moves ? options_.mate.thrust_n : options_.mate.still_thrust_n, commands);
  }
}

bool ReelIn::Step(const Senses& senses, Commands* commands) {
  const Tick still = still_.Still(senses.now(), senses.reeled_m());
  Pull(senses, still, commands);
  if (wiggle_since_) {
    const Tick since = senses.now() - *wiggle_since_;
    if (since < 4 * options_.mate.wiggle_quarter) {
      const bool rolls = wiggles_ == 2 && nominal_.paddle_pitch_m > 0.0;
      rolls ? RollToAndFro(since, commands) : TurnToAndFro(since, commands);
      return false;
    }
    wiggle_since_.reset();
    still_.Reset();
    return false;
  }
  const double past_floor = DepthByDrum(senses) - nominal_.seat_depth_m;
  if (past_floor >= options_.mate.over_reel_m) return true;
  if (gentle_ && still >= options_.mate.gentle_after) {
    gentle_ = false;
    still_.Reset();
  } else if (!gentle_ && still >= options_.mate.stuck_after) {
    return true;
  }
  return false;
}

}  // namespace dockyard::axel
