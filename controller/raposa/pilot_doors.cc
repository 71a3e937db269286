// The phases in which the pilot closes the doors, feels what they hold, and backs off to try again.
#include "controller/raposa/pilot.h"

#include <cmath>

#include "controller/raposa/drive.h"

namespace dockyard::raposa {
namespace {

// Doors stand where they are told to within this, or have had their time: they take 5 s for 30 mm.
constexpr double kDoorAt_m = 0.004, kDoorAjar_s = 4.0, kDoorOpen_s = 6.0;
// Nudging at a share of the slowest forward speed. Assumed, 0.4-0.8.
constexpr double kNudgeShare = 0.5;

/// Of each door, for the guide to pass.
double AjarOpening(const Nominal& nominal, const DockyardOptions& options) {
  return 0.5 * nominal.marks.guide_diameter_m + options.ajar_past_m;
}

}  // namespace

Twist Pilot::Brake() {
  if (here_.For(now_) < options_.brake_s) return {};
  kept_.door_open_m = 0.0;
  Enter(Phase::kClose, "");
  return {};
}

Twist Pilot::Close() {
  if (doors_.state() == DoorState::kHeld) {
    Enter(Phase::kProve, "doors hold something");
    doors_.Begin();
    return {};
  }
  if (doors_.state() == DoorState::kMoving && here_.For(now_) < options_.close_s) return {};
  if (doors_.state() != DoorState::kMoving && tries_.nudges < options_.nudges) {
    ++tries_.nudges;
    const bool pinched = doors_.state() == DoorState::kPinched;
    nudge_m_ = pinched ? options_.nudge_m : options_.blind_nudge_m;
    kept_.door_open_m = AjarOpening(nominal_, options_);
    kept_.arm_rad = PressAngle(options_, tries_.attempts + tries_.nudges);
    Enter(Phase::kAjar, pinched ? "the guide is not in yet" : "doors closed on nothing");
    return {};
  }
  TryAgain(doors_.state() == DoorState::kEmpty ? "doors closed on nothing" : "doors do not close");
  return {};
}

Twist Pilot::Ajar() {
  const double off_m = std::abs(doors_.opening_m() - AjarOpening(nominal_, options_));
  if (off_m > kDoorAt_m && here_.For(now_) < kDoorAjar_s) return {};
  if (here_.driven_m < nudge_m_) return {kNudgeShare * options_.least_approach_m_s, 0.0};
  Enter(Phase::kBrake, "nudged on");
  return {};
}

Twist Pilot::Prove() {
  if (here_.driven_m > -options_.prove_m) return {-options_.prove_m_s, 0.0};
  if (doors_.state() == DoorState::kHeld) {
    Enter(Phase::kDocked, "doors hold the guide against a pull");
  } else if (doors_.state() != DoorState::kMoving || here_.For(now_) > options_.close_s) {
    TryAgain("the guide slipped out of the doors");
  }
  return {};
}

void Pilot::TryAgain(const std::string& why) {
  ++tries_.attempts;
  if (tries_.attempts >= options_.attempts) {
    Enter(Phase::kGivenUp, why);
    return;
  }
  kept_.door_open_m = nominal_.door_travel_m;
  Enter(Phase::kRetreat, why);
}

Twist Pilot::Retreat() {
  // Doors first: they may hold something.
  if (nominal_.door_travel_m - doors_.opening_m() > kDoorAt_m && here_.For(now_) < kDoorOpen_s)
    return {};
  const bool far = filter_.located() && filter_.X_DN().x > options_.retreat_m;
  const bool there = far || here_.driven_m < -options_.most_retreat_m;
  if (!there) return {-options_.back_share * options_.approach_m_s, 0.0};
  kept_.arm_rad = 0.0;
  filter_.Forget();
  Enter(Phase::kLook, "backed off");
  return {};
}

}  // namespace dockyard::raposa
