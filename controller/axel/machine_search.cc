// Without the board in view: the search, and the way in by the tether alone.
#include <cmath>
#include <optional>
#include <string>

#include "controller/axel/machine_impl.h"

namespace dockyard::axel {
namespace {

std::optional<Event> ArrivedIf(bool arrived) {
  return arrived ? std::optional<Event>(Event::kArrived) : std::nullopt;
}

}  // namespace

// On sand a rover that drives with the tether abeam tips its arm over.
bool AxelMachine::StopsAbeam() const {
  const bool on_leg = phase_ == Phase::kApproach || phase_ == Phase::kAlign;
  if (!on_leg || turning_pulls_ >= options_.search.turning_pulls) return false;
  const SearchKnowledge known = Known();
  return std::abs(known.tether_rad) > options_.search.abeam_rad &&
         PullFirst(known, options_.search);
}

SearchKnowledge AxelMachine::Known() const {
  const Pose2 X_DR = senses_.pose();
  const PlanGeometry& geometry = driving_.geometry();
  const TipPlace tip = TipOf(geometry, X_DR);
  return {SeesBoard(geometry, options_.look, X_DR), BoardBearing(geometry, X_DR),
          std::hypot(tip.gap_m, tip.offset_m), TetherAngle(geometry, X_DR)};
}

// In the middle of its arcs the rover has the tether aside, too. So this counts only where it finds
// the board, and a tether that does not turn it is not pulled for ever.
bool AxelMachine::TetherAbeam() {
  return seeking_ && PullFirst(Known(), options_.search) &&
         turning_pulls_++ < options_.search.turning_pulls;
}

void AxelMachine::BeginSearch() {
  seeking_ = true;
  search_.reset();
  pull_.Begin(senses_);
  if (senses_.filter().located()) search_ = NextSearchAction(attempts_++, Known(), options_.search);
  if (!search_)
    search_ = seeker_.Next(
        {senses_.yaw_rad(), senses_.reeled_m(), senses_.rolled_m(), senses_.elevation_rad()});
  if (!search_ || search_->move != SearchMove::kAdvance) return;
  driving_.PlanAhead(senses_, search_->amount);
  const DriveOptions& drive = options_.drive;
  driving_.Start({drive.approach_m_s, drive.reverse_m_s, drive.steering}, senses_.now());
}

std::optional<Event> AxelMachine::Search(Commands* commands) {
  if (!search_) return GoBlind("board not found");
  if (InPhase() > options_.search.move_limit) return Event::kArrived;
  switch (search_->move) {
    case SearchMove::kAgain:
      return Event::kArrived;
    case SearchMove::kTilt:
      return Level(search_->amount, commands);
    case SearchMove::kTurn:
      return ArrivedIf(TurnInPlace(nominal_, options_, search_->amount, TurnedHere(), commands));
    case SearchMove::kReel:
      return ArrivedIf(pull_.Step(senses_, commands) || ReeledHere() >= search_->amount ||
                       RolledHere() >= search_->amount ||
                       RolledHere() <= -options_.search.backwards_m ||
                       std::abs(TurnedHere()) >= options_.search.pull_turn_rad);
    case SearchMove::kReverse:
      return ArrivedIf(
          ReverseStraight(nominal_, options_, search_->amount, RolledHere(), commands));
    case SearchMove::kAdvance:
      return Drive(commands);
    case SearchMove::kBackUp:
      return Recover(Event::kGoRecover, "board lost near the station");
  }
  return std::nullopt;
}

// A rover that knows from before that it stands aside of the cone would jam there.
Event AxelMachine::GoBlind(const std::string& why) {
  belief_.note = why;
  const Pose2 X_DR = senses_.pose();
  const bool aside =
      senses_.filter().located() && std::abs(std::atan2(X_DR.y, X_DR.x)) > options_.haul.aside_rad;
  if (aside || hauls_++ >= options_.haul.tries) return Event::kLimitReached;
  return Event::kGoBlind;
}

// The cone that holds the arm tells the rover where it is. The reel-in then checks that it is
// seated.
std::optional<Event> AxelMachine::HaulIn(Commands* commands) {
  const Haul::Status status = haul_.Step(senses_, commands);
  if (status == Haul::Status::kUnderWay) return std::nullopt;
  if (status == Haul::Status::kLoose) {
    belief_.note += ", and the tether does not lead into the cone";
    return Event::kLimitReached;
  }
  senses_.filter().Restart(SeatedFix(nominal_));
  return Event::kArrived;
}

}  // namespace dockyard::axel
