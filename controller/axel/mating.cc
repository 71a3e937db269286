#include "controller/axel/mating.h"

#include <cmath>

#include "controller/axel/drive.h"

namespace dockyard::axel {

double DepthBySighting(const Nominal& nominal, const Pose3& X_RB, double arm_rad) {
  const double reach = nominal.arm_length_m;
  const Eigen::Vector3d p_RT(reach * std::cos(arm_rad), 0.0, -reach * std::sin(arm_rad));
  // Along the ground, not along the cone's axis: 1 mm less at 5 deg of tilt and 0.23 m.
  return -(nominal.X_DB * Inverse(X_RB) * p_RT).x();
}

SeatRuling RuleSeat(const SeatKnowledge& known, double seat_depth_m, const MateOptions& options) {
  if (known.depth_by_picture_m) {
    const bool deep = *known.depth_by_picture_m >= seat_depth_m - options.seat_margin_m;
    return deep ? SeatRuling::kSeated : SeatRuling::kShort;
  }
  if (known.depth_by_drum_m < seat_depth_m - options.seat_margin_m) return SeatRuling::kShort;
  if (!known.taken_up_by_push_m) return SeatRuling::kUnproven;
  const bool firm = *known.taken_up_by_push_m < options.wiggle_gain_m;
  return firm ? SeatRuling::kSeated : SeatRuling::kShort;
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

// Gently, wheels and spool together roll the rover over its paddles. What that does not bring in,
// the spool's whole pull does. An arm in the cone bears that pull, so the wheels alone push the
// station.
void ReelIn::Pull(Tick still, Commands* commands) const {
  const TetherOptions& tether = options_.tether;
  const double tension_n = gentle_ ? options_.mate.gentle_tension_n : tether.reel_tension_n;
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
  Pull(still, commands);
  if (wiggle_since_) {
    const Tick since = senses.now() - *wiggle_since_;
    if (since < 4 * options_.mate.wiggle_quarter) {
      TurnToAndFro(since, commands);
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
