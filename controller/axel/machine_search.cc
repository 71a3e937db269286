// Without the board in view: the search, and the way in by the tether alone.
#include <cmath>
#include <optional>
#include <string>

#include "controller/axel/machine_impl.h"

namespace dockyard::axel {
SearchKnowledge AxelMachine::Known() const {
  const Pose2 X_DR = senses_.pose();
  const PlanGeometry& geometry = driving_.geometry();
  const TipPlace tip = TipOf(geometry, X_DR);
  return {SeesBoard(geometry, options_.look, X_DR), BoardBearing(geometry, X_DR),
          std::hypot(tip.gap_m, tip.offset_m), TetherAngle(geometry, X_DR),
          search_.station_slides()};
}

std::optional<Event> AxelMachine::Search(Commands* commands) {
  const std::optional<SearchAction>& action = search_.action();
  if (!action) return GoBlind("board not found");
  if (InPhase() > options_.search.move_limit) return Event::kArrived;
  switch (action->move) {
    case SearchMove::kAgain:
      return Event::kArrived;
    case SearchMove::kTilt:
      return Level(action->amount, commands);
    case SearchMove::kTurn:
    case SearchMove::kReel:
    case SearchMove::kReverse:
      return search_.Move(senses_, *entered_, commands) ? std::optional(Event::kArrived)
                                                        : std::nullopt;
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
  if (aside || tries_.blind++ >= options_.haul.tries) return Event::kLimitReached;
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
