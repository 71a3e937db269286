// The phases in which the pilot looks for the guide and its marks.
#include "controller/raposa/pilot.h"

#include <algorithm>
#include <cmath>

namespace dockyard::raposa {
namespace {

// A standing robot turns to a guide that is cut by the view's edge and so far aside; assumed, 4-8
// deg.
constexpr double kAside_rad = Radians(6.0);
// A search to and fro by 20, 40, 80, 160 and 320 deg has then seen all round.
constexpr double kAllRound_rad = Radians(620.0);
// Towards a guide: its bearing dies out in a second. Assumed, 0.5-2 /s and 0.1-0.3 rad/s.
constexpr double kCreepGain_per_s = 1.0, kCreepTurn_rad_s = 0.2;

}  // namespace

/// Towards a guide at the view's edge, which shows no marks there. Zero if there is none.
Twist Pilot::TurnToAside() {
  const bool aside = guide_ && guide_->clipped && fits_ == 0 &&
                     std::abs(guide_->bearing_rad) > kAside_rad &&
                     turned_aside_rad_ < nominal_.half_view_rad;
  if (!aside) return {};
  turned_aside_rad_ += std::abs(turned_rad_);
  entered_ = now_;  // what it looks for comes into view now
  return {0.0, std::copysign(options_.seen_turn_rad_s, guide_->bearing_rad)};
}

Twist Pilot::Look() {
  lamps_ = pressed_once_ || (filter_.located() && filter_.range_m() < options_.lamps_m);
  if (filter_.located() && fits_ >= options_.looks) {
    const double sigma = std::sqrt(filter_.covariance()(2, 2));
    if (sigma < options_.sure_heading_rad || For() > options_.patience_s) {
      Decide();
      return {};
    }
  }
  const Twist aside = TurnToAside();
  if (aside.turn_rad_s != 0.0) return aside;
  // A guide this low is cut by the view's edge, or lies below it.
  const bool low = !guide_ || guide_->clipped;
  if (For() > options_.glance_s && fits_ == 0 && low && arm_told_rad_ == 0.0 && !pressed_once_) {
    arm_told_rad_ = options_.look_low_rad;
    lamps_ = pressed_once_ = true;
    Enter(Phase::kLook, "looks lower");
    return {};
  }
  // At the start it is told that the guide is in view: far off it shows in some pictures alone.
  const bool first = guide_seen_ == 0;
  if (For() < (first ? options_.first_patience_s : options_.patience_s)) return {};
  pressed_once_ = false;
  if (first || UnseenFor() > options_.lost_s) {
    arm_told_rad_ = 0.0;
    if (MayBeAhead()) {
      Enter(Phase::kCreep, "on towards a far guide");
    } else {
      Enter(Phase::kSearch, "no guide in view");
    }
  } else if (last_guide_->range_m > options_.creep_to_m) {
    Enter(Phase::kCreep, "the guide is too far for its marks");
  } else if (backs_ < options_.backs) {
    ++backs_;
    glance_side_ = last_guide_->bearing_rad < 0.0 ? -1.0 : 1.0;
    Enter(Phase::kGlance, "the guide shows no marks");
  } else {
    backs_ = 0;
    round_side_ = 0.0;
    filter_.Forget();
    attempts_ += options_.attempts / 2;  // seen from all round: of two such guides it gives up
    away_from_rad_ = 2.0 * nominal_.half_view_rad;
    Enter(Phase::kSearch, "this guide never shows marks");
  }
  return {};
}

/// A far guide shows in some pictures alone: it is gone on to for a while. At the start it is told
/// to be in view.
bool Pilot::MayBeAhead() const {
  const bool far = !last_guide_ || last_guide_->range_m > options_.far_m;
  return far && unseen_m_ < options_.unseen_way_m;
}

Twist Pilot::Search() {
  away_from_rad_ = std::max(0.0, away_from_rad_ - std::abs(turned_rad_));
  if (guide_ && away_from_rad_ == 0.0) {
    Enter(Phase::kLook, "guide in view");
    return {};
  }
  if (!search_.begun()) {
    search_.Begin(filter_.located() ? -filter_.bearing_rad() : -1.0);
  }
  searched_rad_ += std::abs(turned_rad_);
  if (filter_.located() && !other_side_ && searched_rad_ > kAllRound_rad) {
    // It stands where the pyramid hides its guide: it went round it by the wrong side, or by a
    // wrong pose.
    other_side_ = true;
    round_side_ = -round_side_;
    last_guide_->range_m = filter_.range_m();
    last_guide_->bearing_rad = filter_.bearing_rad();
    GoRound();
    return {};
  }
  if (searched_rad_ > options_.most_search_rad || attempts_ >= options_.attempts) {
    Enter(Phase::kGivenUp, "no pyramid in three turns");
    return {};
  }
  return {0.0, search_.Step(turned_rad_)};
}

Twist Pilot::Creep() {
  if (UnseenFor() > options_.lost_s && !MayBeAhead()) {
    Enter(Phase::kLook, "lost the guide");
    return {};
  }
  arm_told_rad_ = 0.0;
  const double turn_rad_s =
      std::clamp(kCreepGain_per_s * guide_bearing_rad_, -kCreepTurn_rad_s, kCreepTurn_rad_s);
  if (!guide_) return {options_.creep_m_s, turn_rad_s};
  const bool sure = filter_.located() && fits_ >= options_.looks &&
                    std::sqrt(filter_.covariance()(2, 2)) < options_.sure_heading_rad;
  if (sure || guide_->range_m < options_.creep_to_m) {
    Enter(Phase::kLook, "near enough");
    return {};
  }
  return {options_.creep_m_s, turn_rad_s};
}

Twist Pilot::Glance() {
  if (fits_ > 0 || UnseenFor() > options_.lost_s) {
    Enter(Phase::kLook, fits_ > 0 ? "marks beside the guide" : "lost the guide");
    return {};
  }
  const double left = last_guide_->bearing_rad - glance_side_ * options_.glance_rad;
  const bool there = std::abs(left) < options_.turn_tolerance_rad || For() > options_.glance_most_s;
  if (!there) {
    const double rate = std::clamp(options_.turn_gain_per_s * left, -options_.seen_turn_rad_s,
                                   options_.seen_turn_rad_s);
    return {0.0, std::copysign(std::max(std::abs(rate), options_.least_turn_rad_s), rate)};
  }
  if (!glanced_) {
    glanced_ = true;
    glance_side_ = -glance_side_;
    entered_ = now_;
    return {};
  }
  if (backs_ > options_.straight_backs) {
    GoRound();
  } else {
    Enter(Phase::kBack, "no marks on either side");
  }
  return {};
}

/// Goes round a guide that shows no marks: it takes the axis to lie round_rad further on, and
/// drives there. The first side is the one that the pictures make likely. It stays, so that the
/// robot comes to the front in the end.
void Pilot::GoRound() {
  if (round_side_ == 0.0) round_side_ = sides_seen_ < 0.0 ? -1.0 : 1.0;
  filter_.Suppose(*last_guide_, round_side_ * options_.round_rad);
  supposed_ = true;
  legs_ = PlanToGate(filter_.X_DN(), nominal_, options_).legs;
  BeginLeg();
  belief_.note = "goes round a guide without marks";
}

Twist Pilot::Back() {
  if (driven_m_ < -options_.back_m) {
    Enter(Phase::kLook, "backed off");
    return {};
  }
  return {-options_.back_share * options_.creep_m_s, 0.0};
}

}  // namespace dockyard::raposa
