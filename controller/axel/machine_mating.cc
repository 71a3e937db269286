// The tip at the mouth, in it, and on the socket's floor or not.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "controller/axel/machine_impl.h"
#include "controller/base/number_text.h"

namespace dockyard::axel {

Event AxelMachine::AtTheMouth() {
  if (driving_.PlanEntry(senses_)) return Event::kGoMate;
  return Misaligned("misaligned at the mouth");
}

Event AxelMachine::Misaligned(const std::string& why) {
  driving_.LearnMouthDrift(driving_.BesideMouthLine(senses_));
  return Recover(Event::kGoRecover, why);
}

std::optional<Event> AxelMachine::Reel(Commands* commands) {
  const bool over = reel_in_.Step(senses_, commands);
  return over ? std::optional<Event>(Event::kReeledIn) : std::nullopt;
}

// Where the reel-in stopped the rover draws the tether taut, brakes the spool, under which nothing
// may slip, and takes a picture.
std::optional<Event> AxelMachine::Confirm(const SensorFrame& sensed, Commands* commands) {
  StandStill(nominal_, options_.drive, InPhase(), commands);
  if (!Steadied(commands)) return std::nullopt;
  const bool looked = LookedAtHome(sensed, commands);
  const bool waited = senses_.now() - braked_->since >= options_.mate.confirm_time;
  if (!looked || !waited) return std::nullopt;
  if (braked_->tip) {
    if (!braked_->straighten) braked_->straighten.emplace(braked_->tip->askew_rad);
    if (!braked_->straighten->Step(nominal_, senses_, options_.mate, commands)) return std::nullopt;
    if (!TautAgain(commands)) return std::nullopt;
    braked_->tip->askew_rad = braked_->straighten->LeanLeft(senses_);
  }
  return RuleHome();
}

// The turn that straightens the arm may push the tip in and leave the tether slack.
bool AxelMachine::TautAgain(Commands* commands) {
  if (!braked_->straighten->turned()) return true;
  const Tick now = senses_.now();
  if (!braked_->taut_from) {
    braked_->taut_from = now;
    still_.Reset();
  }
  const Tick still = still_.Still(now, senses_.reeled_m());
  const bool taut = std::min(still, now - *braked_->taut_from) >= options_.tether.taut_after;
  if (!braked_->again && !taut && now - *braked_->taut_from < options_.mate.taut_limit) {
    Spool(commands) = Winch(nominal_, options_.mate.taut_m_s, options_.mate.taut_tension_n,
                            options_.tether.accel_rad_s2);
    return false;
  }
  if (!braked_->again) {
    braked_->again = now;
    braked_->reeled_m = senses_.reeled_m();
  }
  return now - *braked_->again >= options_.mate.confirm_time;
}

bool AxelMachine::Steadied(Commands* commands) {
  if (braked_) return true;
  Spool(commands) = Winch(nominal_, options_.mate.taut_m_s, options_.mate.taut_tension_n,
                          options_.tether.accel_rad_s2);
  const bool waited = InPhase() >= options_.drive.stop_time + options_.tether.taut_after;
  const Tick still = still_.Still(senses_.now(), senses_.reeled_m());
  const bool still_enough = waited && still >= options_.tether.taut_after;
  if (!still_enough && InPhase() < options_.mate.taut_limit) return false;
  braked_ = Braked{.since = senses_.now(), .reeled_m = senses_.reeled_m()};
  Spool(commands) = {};
  return true;
}

bool AxelMachine::LookedAtHome(const SensorFrame& sensed, Commands* commands) {
  if (braked_->looked) return true;
  if (const std::optional<StereoImages> images = Arrived(sensed)) {
    const LocateOutput seen = Locate(*images);
    braked_->looked = true;
    if (!seen.sighting) return true;
    judge_.NewStop();
    judge_.Judge(*seen.sighting, &senses_);
    const Pose3& X_RB = seen.sighting->X_RB;
    const TipSeen tip{DepthBySighting(nominal_, X_RB, senses_.arm_rad()),
                      AskewBySighting(nominal_, X_RB, senses_.arm_rad())};
    // Deeper than the floor is nonsense.
    if (tip.depth_m <= nominal_.seat_depth_m + options_.mate.over_reel_m) braked_->tip = tip;
    return true;
  }
  if (!asked_at_) {
    commands->take_images = {kLeftCamera, kRightCamera};
    asked_at_ = senses_.now();
  }
  braked_->looked = senses_.now() - *asked_at_ >= options_.mate.picture_limit;
  return braked_->looked;
}

Event AxelMachine::RuleHome() {
  SeatKnowledge known{.depth_by_drum_m = reel_in_.DepthByDrum(senses_), .by_picture = braked_->tip};
  if (reel_in_.wiggles() > 0) known.taken_up_by_push_m = reel_in_.taken_up_m(senses_);
  SeatRuling ruling = RuleSeat(known, nominal_.seat_depth_m, options_.mate);
  const double slipped = std::abs(senses_.reeled_m() - braked_->reeled_m);
  if (slipped > options_.mate.confirm_slip_m) ruling = SeatRuling::kShort;
  belief_.note = known.by_picture
                     ? "tip " + Fixed(known.by_picture->depth_m, 3) +
                           " m deep by its picture, arm " +
                           Fixed(Degrees(known.by_picture->askew_rad), 1) + " deg aside"
                     : "tip " + Fixed(known.depth_by_drum_m, 3) + " m deep by the drum";
  if (ruling == SeatRuling::kSeated) return Event::kSteady;
  const bool askew = ruling == SeatRuling::kAskew;
  const int limit = askew ? options_.mate.askew_wiggles : options_.mate.wiggles;
  if (reel_in_.wiggles() < limit) return Event::kStopsShort;
  // An arm that leans to D's +y has its axle on the other side.
  if (askew)
    driving_.LearnMouthDrift(-(nominal_.arm_length_m - nominal_.seat_depth_m) *
                             std::sin(known.by_picture->askew_rad));
  return Recover(Event::kStuck, askew ? "arm stays askew" : "does not go in");
}

}  // namespace dockyard::axel
