#include "controller/axel/seeker.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard::axel {

PullResult JudgePull(const SeekerPlace& before, const SeekerPlace& after,
                     const SearchOptions& options) {
  const double taken_m = after.reeled_m - before.reeled_m;
  const double rolled_m = after.rolled_m - before.rolled_m;
  if (std::abs(WrapPi(after.yaw_rad - before.yaw_rad)) >= options.still_turn_rad) {
    return PullResult::kTurned;
  }
  if (rolled_m < -options.whole_pull * options.backwards_m) return PullResult::kBackwards;
  return taken_m < options.whole_pull * options.reel_m ? PullResult::kStuck : PullResult::kAligned;
}

void Seeker::TakePull(const SeekerPlace& here) {
  const SeekerPlace& before = looked_.back();
  pulled_m_ += std::max(0.0, here.reeled_m - before.reeled_m);
  side_ = WrapPi(here.yaw_rad - before.yaw_rad) < 0.0 ? -1.0 : 1.0;
  switch (JudgePull(before, here, options_)) {
    case PullResult::kTurned:  // on, and look
      break;
    case PullResult::kBackwards:  // out of the balance; the next pull turns it on
      planned_ = {{SearchMove::kTurn, WrapPi(here.yaw_rad + side_ * options_.sweep_rad)}};
      break;
    case PullResult::kAligned:
      planned_.clear();
      if (here.elevation_rad > options_.raised_rad)
        planned_ = {{SearchMove::kReverse, options_.reverse_m}};
      PlanSweep(here);
      break;
    case PullResult::kStuck:  // too near, at the station, or in a hole
      ++stuck_;
      planned_ = {{SearchMove::kReverse, options_.reverse_m}};
      PlanSweep(here);
      break;
  }
}

void Seeker::PlanSweep(const SeekerPlace& here) {
  if (!tilted_) {
    planned_.push_back({SearchMove::kTilt, options_.tilt_rad});
    planned_.push_back({SearchMove::kTilt, -options_.tilt_rad});
  }
  tilted_ = true;
  for (const double side : {side_, -side_}) {
    planned_.push_back({SearchMove::kTurn, WrapPi(here.yaw_rad + side * options_.sweep_rad)});
  }
}

bool Seeker::LookedAt(const SeekerPlace& here, double yaw_rad) const {
  return std::any_of(looked_.begin(), looked_.end(), [&](const SeekerPlace& looked) {
    return std::abs(WrapPi(looked.yaw_rad - yaw_rad)) < options_.same_yaw_rad &&
           std::abs(looked.reeled_m - here.reeled_m) < options_.same_place_m;
  });
}

std::optional<SearchAction> Seeker::Planned(const SeekerPlace& here) {
  while (!planned_.empty()) {
    SearchAction action = planned_.front();
    planned_.erase(planned_.begin());
    if (action.move != SearchMove::kTurn) return action;
    if (LookedAt(here, action.amount)) continue;
    action.amount = WrapPi(action.amount - here.yaw_rad);
    return action;
  }
  return std::nullopt;
}

std::optional<SearchAction> Seeker::Next(const SeekerPlace& here) {
  if (last_ && last_->move == SearchMove::kReel) TakePull(here);
  looked_.push_back(here);
  if (!last_) {
    last_ = SearchAction{SearchMove::kAgain, 0.0};
    return last_;
  }
  last_ = Planned(here);
  if (last_) return last_;
  if (stuck_ >= options_.stuck_pulls || pulled_m_ >= options_.reel_limit_m) return std::nullopt;
  last_ = SearchAction{SearchMove::kReel, options_.reel_m};
  return last_;
}

}  // namespace dockyard::axel
