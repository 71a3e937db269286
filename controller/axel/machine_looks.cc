// Standing still: the tether comes taut, an image pair is taken and judged.
#include <cmath>
#include <optional>
#include <string>

#include "controller/axel/machine_impl.h"

namespace dockyard::axel {
namespace {

/// In place of the picture of a camera that gave none beside the other's.
GrayImage Dark(const GrayImage& other) {
  GrayImage dark{.width = other.width, .height = other.height, .pixels = {}};
  dark.pixels.resize(other.pixels.size());
  return dark;
}

}  // namespace

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

// The body turns about the axle only while the wheels are free. The braked spool holds the rover,
// but not from rolling downhill towards the station: then it stops and looks as it is.
std::optional<Event> AxelMachine::Level(double target_pitch_rad, Commands* commands) {
  const Event done = phase_ == Phase::kTighten ? Event::kTaut : Event::kArrived;
  if (std::abs(senses_.rolled_m() - rolled_before_m_) > options_.arm.level_roll_m) return done;
  SetWheels(MotorMode::kFree, commands);
  arm_.Level(senses_, target_pitch_rad);
  const bool level =
      std::abs(senses_.pitch_rad() - target_pitch_rad) <= 2.0 * options_.arm.dead_band_rad;
  const Tick since = senses_.now() - levelling_since_.value_or(entered_);
  if (!level && since < options_.arm.level_limit) return std::nullopt;
  return done;
}

std::optional<Event> AxelMachine::Look(const SensorFrame& sensed, Commands* commands) {
  StandStill(nominal_, options_.drive, InPhase(), commands);
  if (InPhase() < options_.drive.stop_time) Spool(commands) = TautWinch(nominal_, options_.tether);
  if (const std::optional<StereoImages> images = Arrived(sensed)) {
    asked_at_.reset();
    asks_ = 0;
    return Judge(*images);
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

std::optional<StereoImages> AxelMachine::Arrived(const SensorFrame& sensed) {
  const GrayImage* left = GrayImageOf(sensed, kLeftCamera);
  const GrayImage* right = GrayImageOf(sensed, kRightCamera);
  if (!asked_at_ || (!left && !right)) return std::nullopt;
  return StereoImages{left ? *left : Dark(*right), right ? *right : Dark(*left)};
}

LocateOutput AxelMachine::Locate(const StereoImages& images) {
  LocateHints hints = HintsFrom(senses_);
  hints.camera_turn = camera_turn_.belief();
  LocateOutput seen = locator_(images, hints);
  ++belief_.sighting_count;
  belief_.last_sighting = seen.report;
  return seen;
}

std::optional<Event> AxelMachine::Judge(const StereoImages& images) {
  const LocateOutput seen = Locate(images);
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
  const Event event = driving_.PlanNext(senses_);
  if (event == Event::kGoRecover) return Recover(event, "misaligned");
  if (driving_.over_rock()) belief_.note = "every plan crosses a rock";
  return driving_.legs() > options_.limit.plans ? Event::kLimitReached : event;
}

}  // namespace dockyard::axel
