// Standing still: the tether comes taut, an image pair is taken and judged.
#include <cmath>
#include <optional>
#include <string>

#include "controller/axel/machine_impl.h"

namespace dockyard::axel {

std::optional<Event> AxelMachine::Tighten(Commands* commands) {
  if (levelling_since_) return Level(0.0, commands);
  const TetherOptions& tether = options_.tether;
  StandStill(nominal_, options_.drive, InPhase(), commands);
  Spool(commands) = TautWinch(nominal_, tether);
  const Tick still = still_.Still(senses_.now(), senses_.reeled_m());
  const bool waited = InPhase() >= options_.drive.stop_time + tether.taut_after;
  const bool taut = waited && still >= tether.taut_after;
  if (!taut && InPhase() < tether.tighten_limit) return std::nullopt;
  taut_ = taut;
  if (taut && senses_.filter().TetherKnown()) senses_.UseTether(0.0);
  if (!taut) belief_.note = "tether does not come taut";
  if (std::abs(senses_.pitch_rad()) <= options_.arm.look_pitch_rad) return Event::kTaut;
  levelling_since_ = senses_.now();
  rolled_before_m_ = senses_.rolled_m();
  return std::nullopt;
}

// The body turns about the axle only while the wheels are free. The spool holds the rover, but not
// from rolling downhill towards the station: then it stops and looks as it is.
std::optional<Event> AxelMachine::Level(double target_pitch_rad, Commands* commands) {
  const Event done = phase_ == Phase::kTighten ? Event::kTaut : Event::kArrived;
  if (std::abs(senses_.rolled_m() - rolled_before_m_) > options_.arm.level_roll_m) return done;
  SetWheels(MotorMode::kFree, commands);
  Spool(commands) = HoldingWinch(nominal_, options_.tether);
  arm_.Level(senses_, target_pitch_rad);
  const bool level =
      std::abs(senses_.pitch_rad() - target_pitch_rad) <= 2.0 * options_.arm.dead_band_rad;
  const Tick since = senses_.now() - levelling_since_.value_or(entered_);
  if (!level && since < options_.arm.level_limit) return std::nullopt;
  return done;
}

std::optional<Event> AxelMachine::Look(const SensorFrame& sensed, Commands* commands) {
  StandStill(nominal_, options_.drive, InPhase(), commands);
  const bool stopped = InPhase() >= options_.drive.stop_time;
  Spool(commands) =
      stopped ? HoldingWinch(nominal_, options_.tether) : TautWinch(nominal_, options_.tether);
  if (bracket_.under_way()) return LookBracketed(sensed, commands);
  if (const std::optional<StereoImages> images = Arrived(sensed)) {
    answer_limit_ = options_.look.image_limit << (asks_ - 1);
    asked_at_.reset();
    asks_ = 0;
    const LocateHints hints = HintsFrom(senses_);
    const LocateOutput seen = Locate(*images);
    if (bracket_.Begins(*images, seen, hints)) return LookBracketed(sensed, commands);
    return Judge(seen);
  }
  if (senses_.now() - look_from_ < options_.look.settle) return std::nullopt;
  if (!asked_at_ || senses_.now() - *asked_at_ >= options_.look.image_limit << (asks_ - 1)) {
    if (asks_ == options_.look.unanswered_asks) {
      return GoBlind("cameras do not answer");
    }
    commands->take_images = {kLeftCamera, kRightCamera};
    asked_at_ = senses_.now();
    ++asks_;
  }
  return std::nullopt;
}

// One exposure does not hold the board: more are taken from the same place. Pictures that do not
// come are waited for as long as the first pair was, and not asked for again.
std::optional<Event> AxelMachine::LookBracketed(const SensorFrame& sensed, Commands* commands) {
  if (asked_at_ && Arrived(sensed)) {
    bracket_.Take(GrayImageOf(sensed, kLeftCamera), GrayImageOf(sensed, kRightCamera));
    asked_at_.reset();
  } else if (asked_at_ && senses_.now() - *asked_at_ >= answer_limit_) {
    bracket_.Stop();
  }
  if (bracket_.under_way()) {
    if (asked_at_) return std::nullopt;
    commands->take_images = {kLeftCamera, kRightCamera};
    commands->exposure_stops = bracket_.stops();
    asked_at_ = senses_.now();
    return std::nullopt;
  }
  asked_at_.reset();
  std::optional<LocateOutput> merged;
  if (bracket_.HasMore()) merged = Locate(bracket_.Merged());
  return Judge(bracket_.Better(merged));
}

std::optional<StereoImages> AxelMachine::Arrived(const SensorFrame& sensed) {
  // A picture from before the question is of a place under way.
  if (!asked_at_ || ExposedAt(sensed) < *asked_at_) return std::nullopt;
  return PairOf(sensed);
}

LocateOutput AxelMachine::Locate(const StereoImages& images) {
  LocateHints hints = HintsFrom(senses_);
  hints.camera_turn = camera_turn_.belief();
  LocateOutput seen = locator_(images, hints);
  Tell(seen);
  return seen;
}

void AxelMachine::Tell(const LocateOutput& seen) {
  ++belief_.sighting_count;
  belief_.last_sighting = seen.report;
}

std::optional<Event> AxelMachine::Judge(const LocateOutput& seen) {
  auto ruling = SightingJudge::Ruling::kRejected;
  if (seen.sighting) {
    ruling = judge_.Judge(*seen.sighting, &senses_);
    belief_.note = judge_.why();
  } else {
    belief_.note = std::string("not located: ") + seen.report.reason;
  }
  if (ruling == SightingJudge::Ruling::kLookAgain) {
    look_from_ = senses_.now();
    return std::nullopt;
  }
  if (ruling == SightingJudge::Ruling::kAccepted) {
    camera_turn_.Take(*seen.sighting);
    attempts_ = 0;
    seeker_ = Seeker(options_.search);
    if (taut_ && !senses_.filter().TetherKnown()) senses_.UseTether(0.0);
    if (phase_ == Phase::kRecheck) return AtTheMouth();
    return TetherAbeam() ? Event::kTetherAbeam : AfterSighting();
  }
  // At the mouth the marks may be too near to be seen (Tsai et al., II): the last estimate decides.
  return phase_ == Phase::kRecheck ? AtTheMouth() : Event::kNotSeen;
}

Event AxelMachine::AfterSighting() {
  // A recovery that did not come out, or a search that ended in the cone: the way is in.
  const double inside_m = -TipOf(driving_.geometry(), senses_.pose()).gap_m;
  if (inside_m > options_.mate.inside_m && recoveries_inside_++ < options_.limit.recoveries) {
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
