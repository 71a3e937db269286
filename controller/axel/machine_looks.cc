// Standing still: the tether comes taut, an image pair is taken and judged.
#include <cmath>
#include <optional>
#include <string>

#include "controller/axel/machine_impl.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {

std::optional<Event> AxelMachine::Tighten(Commands* commands) {
  if (levelling_) return Level(0.0, commands);
  const TetherOptions& tether = options_.tether;
  StandStill(nominal_, options_.drive, InPhase(), commands);
  CommandOf(commands, Motor::kSpool) =
      TautWinch(nominal_, tether, TautTension(nominal_, options_, senses_));
  const Tick still = still_.Still(senses_.now(), senses_.reeled_m());
  const bool waited = InPhase() >= options_.drive.stop_time + tether.taut_after;
  const bool taut = waited && still >= tether.taut_after;
  if (!taut && InPhase() < tether.tighten_limit) return std::nullopt;
  taut_ = taut;
  if (taut && senses_.filter().TetherKnown()) senses_.UseTether(0.0);
  if (!taut) belief_.note = "tether does not come taut";
  if (std::abs(senses_.pitch_rad()) <= options_.arm.look_pitch_rad) return Event::kTaut;
  levelling_ = MomentOf(senses_);
  return std::nullopt;
}

// The body turns about the axle only while the wheels are free. The spool holds the rover, but not
// from rolling downhill towards the station: then it stops and looks as it is.
std::optional<Event> AxelMachine::Level(double target_pitch_rad, Commands* commands) {
  const Event done = phase_ == Phase::kTighten ? Event::kTaut : Event::kArrived;
  const Moment& freed = levelling_ ? *levelling_ : *entered_;
  if (std::abs(senses_.rolled_m() - freed.rolled_m) > options_.arm.level_roll_m) return done;
  SetWheels(MotorMode::kFree, commands);
  CommandOf(commands, Motor::kSpool) =
      HoldingWinch(nominal_, options_.tether, TautTension(nominal_, options_, senses_));
  arm_.Level(senses_, target_pitch_rad);
  const bool level =
      std::abs(senses_.pitch_rad() - target_pitch_rad) <= 2.0 * options_.arm.dead_band_rad;
  if (!level && senses_.now() - freed.tick < options_.arm.level_limit) return std::nullopt;
  return done;
}

std::optional<Event> AxelMachine::Look(const SensorFrame& sensed, Commands* commands) {
  StandStill(nominal_, options_.drive, InPhase(), commands);
  const bool stopped = InPhase() >= options_.drive.stop_time;
  const double taut_n = TautTension(nominal_, options_, senses_);
  CommandOf(commands, Motor::kSpool) = stopped ? HoldingWinch(nominal_, options_.tether, taut_n)
                                               : TautWinch(nominal_, options_.tether, taut_n);
  const std::optional<LocateOutput> seen = stop_.Step(sensed, senses_, Located(), commands);
  if (stop_.unanswered()) return GoBlind("cameras do not answer");
  return seen ? Judge(*seen) : std::nullopt;
}

// Locates, and notes each sighting in the belief.
Locator AxelMachine::Located() {
  return [this](const StereoImages& images, const LocateHints& hints) {
    LocateOutput seen = perception_.Locate(images, hints);
    Tell(seen.report);
    return seen;
  };
}

void AxelMachine::Tell(const SightingReport& sighting) {
  ++belief_.sighting_count;
  belief_.last_sighting = sighting;
}

std::optional<Event> AxelMachine::Judge(const LocateOutput& seen) {
  auto ruling = SightingJudge::Ruling::kRejected;
  if (seen.sighting) {
    ruling = judge_.Judge(*seen.sighting, &senses_);
    belief_.note = judge_.why();
    if (ruling != SightingJudge::Ruling::kAccepted) RuleOut(judge_.why(), &belief_);
  } else {
    belief_.note = std::string("not located: ") + seen.report.reason;
  }
  if (ruling == SightingJudge::Ruling::kLookAgain) {
    stop_.Again(senses_.now());
    return std::nullopt;
  }
  if (ruling == SightingJudge::Ruling::kAccepted) {
    perception_.camera_turn.Take(*seen.sighting);
    search_.Found();
    if (taut_ && !senses_.filter().TetherKnown()) senses_.UseTether(0.0);
    if (phase_ == Phase::kRecheck) return AtTheMouth();
    return search_.PullsFirst(Known()) ? Event::kTetherAbeam : AfterSighting();
  }
  // At the mouth the marks may be too near to be seen (Tsai et al., II): the last estimate decides.
  return phase_ == Phase::kRecheck ? AtTheMouth() : Event::kNotSeen;
}

Event AxelMachine::AfterSighting() {
  // A recovery that did not come out, or a search that ended in the cone: the way is in.
  const double inside_m = -TipOf(driving_.geometry(), senses_.pose()).gap_m;
  if (inside_m > options_.mate.inside_m && tries_.recoveries_inside++ < options_.limit.recoveries) {
    belief_.note = "tip is in the cone";
    return Event::kInside;
  }
  held_ = driving_.Held(senses_);
  if (held_) return Recover(Event::kGoRecover, "leg made no way");
  const Event event = driving_.PlanNext(senses_);
  if (event == Event::kGoRecover) return Misaligned("misaligned");
  if (driving_.over_rock()) belief_.note = "every plan crosses a rock";
  return driving_.legs() > options_.limit.plans ? Event::kLimitReached : event;
}

}  // namespace dockyard::axel
