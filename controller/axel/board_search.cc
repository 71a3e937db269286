#include "controller/axel/board_search.h"

#include <cmath>

#include "controller/axel/leg.h"

namespace dockyard::axel {

void BoardSearch::Begin(const Senses& senses, const SearchKnowledge& known) {
  seeking_ = true;
  action_.reset();
  pull_.Begin(senses);
  if (senses.filter().located()) action_ = NextSearchAction(attempts_++, known, options_.search);
  if (!action_)
    action_ = seeker_.Next(
        {senses.yaw_rad(), senses.reeled_m(), senses.rolled_m(), senses.elevation_rad()});
}

void BoardSearch::Found() {
  attempts_ = 0;
  seeker_ = Seeker(options_.search);
}

bool BoardSearch::PullsFirst(const SearchKnowledge& known) {
  return seeking_ && std::abs(known.tether_rad) > options_.search.abeam_rad &&
         PullFirst(known, options_.search) && turning_pulls_++ < options_.search.turning_pulls;
}

bool BoardSearch::StopsAbeam(const SearchKnowledge& known) const {
  return turning_pulls_ < options_.search.turning_pulls &&
         std::abs(known.tether_rad) > options_.search.abeam_rad &&
         PullFirst(known, options_.search);
}

bool BoardSearch::Move(const Senses& senses, const Moment& since, Commands* commands) {
  const double amount = action_->amount, rolled_m = senses.rolled_m() - since.rolled_m;
  const double turned_rad = WrapPi(senses.yaw_rad() - since.yaw_rad);
  if (action_->move == SearchMove::kTurn)
    return TurnInPlace(nominal_, options_, amount, turned_rad, commands);
  if (action_->move == SearchMove::kReverse)
    return ReverseStraight(nominal_, options_, amount, rolled_m, commands);
  return pull_.Step(senses, commands) != TetherPull::Status::kPulls ||
         senses.reeled_m() - since.reeled_m >= amount || rolled_m >= amount ||
         rolled_m <= -options_.search.backwards_m ||
         std::abs(turned_rad) >= options_.search.pull_turn_rad;
}

}  // namespace dockyard::axel
