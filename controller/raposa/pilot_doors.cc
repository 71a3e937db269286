// The phases in which the pilot closes the doors, feels what they hold, and backs off to try again.
#include "controller/raposa/pilot.h"

#include <cmath>

namespace dockyard::raposa {
namespace {

// Doors stand where they are told to within this, or have had their time: they take 5 s for 30 mm.
constexpr double kDoorAt_m = 0.004, kDoorAjar_s = 4.0, kDoorOpen_s = 6.0;
// Nudging at a share of the slowest forward speed. Assumed, 0.4-0.8.
constexpr double kNudgeShare = 0.5;

}  // namespace

/// Each try after the first has another: a guide that is built higher or lower than told meets the
/// seat at another lean.
double Pilot::PressAngle() const {
  const int tries = attempts_ + nudges_;
  if (tries == 0) return options_.press_rad;
  return options_.press_rad + (tries % 2 == 1 ? -1.0 : 1.0) * options_.press_other_rad;
}

/// Of each door, for the guide to pass.
double Pilot::AjarOpening() const {
  return 0.5 * nominal_.marks.guide_diameter_m + options_.ajar_past_m;
}

Twist Pilot::Close() {
  if (doors_.state() == DoorState::kHeld) {
    Enter(Phase::kProve, "doors hold something");
    doors_.Begin();
    return {};
  }
  if (doors_.state() == DoorState::kMoving && For() < options_.close_s) return {};
  if (doors_.state() != DoorState::kMoving && nudges_ < options_.nudges) {
    ++nudges_;
    const bool pinched = doors_.state() == DoorState::kPinched;
    nudge_m_ = pinched ? options_.nudge_m : options_.blind_nudge_m;
    door_open_m_ = AjarOpening();
    arm_told_rad_ = PressAngle();
    Enter(Phase::kAjar, pinched ? "the guide is not in yet" : "doors closed on nothing");
    return {};
  }
  TryAgain(doors_.state() == DoorState::kEmpty ? "doors closed on nothing" : "doors do not close");
  return {};
}

Twist Pilot::Ajar() {
  if (std::abs(doors_.opening_m() - AjarOpening()) > kDoorAt_m && For() < kDoorAjar_s) return {};
  if (driven_m_ < nudge_m_) return {kNudgeShare * options_.least_approach_m_s, 0.0};
  Enter(Phase::kBrake, "nudged on");
  return {};
}

Twist Pilot::Prove() {
  if (driven_m_ > -options_.prove_m) return {-options_.prove_m_s, 0.0};
  if (doors_.state() == DoorState::kHeld) {
    Enter(Phase::kDocked, "doors hold the guide against a pull");
  } else if (doors_.state() != DoorState::kMoving || For() > options_.close_s) {
    TryAgain("the guide slipped out of the doors");
  }
  return {};
}

void Pilot::TryAgain(const std::string& why) {
  ++attempts_;
  if (attempts_ >= options_.attempts) {
    Enter(Phase::kGivenUp, why);
    return;
  }
  door_open_m_ = nominal_.door_travel_m;
  Enter(Phase::kRetreat, why);
}

Twist Pilot::Retreat() {
  // Doors first: they may hold something.
  if (nominal_.door_travel_m - doors_.opening_m() > kDoorAt_m && For() < kDoorOpen_s) return {};
  const bool far = filter_.located() && filter_.X_DN().x > options_.retreat_m;
  const bool there = far || driven_m_ < -options_.most_retreat_m;
  if (!there) return {-options_.back_share * options_.approach_m_s, 0.0};
  arm_told_rad_ = 0.0;
  filter_.Forget();
  Enter(Phase::kLook, "backed off");
  return {};
}

}  // namespace dockyard::raposa
