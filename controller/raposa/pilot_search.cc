// The phases in which the pilot looks for the guide and its marks.
#include "controller/raposa/pilot.h"

#include <algorithm>
#include <cmath>

#include "controller/raposa/drive.h"

namespace dockyard::raposa {
namespace {

// A standing robot turns to a guide that is cut by the view's edge and so far aside; assumed, 4-8
// deg.
constexpr double kAside_rad = Radians(6.0);
// Moves to another place, after it found nothing all round; assumed, 1-3. So far, a thing 0.3 m
// behind a guide at 1.3 m moves by 3 deg against it; assumed, 0.3-0.6 m.
constexpr int kElsewheres = 1;
constexpr double kElsewhere_m = 0.45;
// The guide was in view at the start: across that direction, within this, a thing behind it moves
// away from it in the image. Assumed, 10-30 deg.
constexpr double kAcross_rad = Radians(20.0);
// Of the range at which it stops to creep; a guide beyond is another one. Assumed, 1.3-2.
constexpr double kAnother = 1.5;
// Towards a guide: its bearing dies out in a second. Assumed, 0.5-2 /s and 0.1-0.3 rad/s.
constexpr double kCreepGain_per_s = 1.0, kCreepTurn_rad_s = 0.2;

/// Of a search's five swings, each twice as far as the one before.
double AllRound(const DockyardOptions& options) { return 31.0 * options.first_search_rad; }

}  // namespace

/// Towards a guide at the view's edge, which shows no marks there. Zero if there is none.
Twist Pilot::TurnToAside() {
  const bool aside = guide_.now && guide_.now->clipped && here_.fits == 0 &&
                     std::abs(guide_.now->bearing_rad) > kAside_rad &&
                     here_.turned_aside_rad < nominal_.half_view_rad;
  if (!aside) return {};
  here_.turned_aside_rad += std::abs(turned_rad_);
  here_.entered = now_;  // what it looks for comes into view now
  return {0.0, std::copysign(options_.seen_turn_rad_s, guide_.now->bearing_rad)};
}

Twist Pilot::Look() {
  kept_.lamps = tries_.low || (filter_.located() && filter_.range_m() < options_.lamps_m);
  if (HasNoSquare(guide_, options_.agreeing_images) && !tries_.all_refuted) {
    Refute("no square by this guide");
    return {};
  }
  if (filter_.located() && here_.agreed >= options_.agreeing_images) {
    if (SureOfAngle(filter_, options_) || !filter_.one_angle() ||
        here_.For(now_) >= options_.patience_s) {
      Decide();
      return {};
    }
  }
  const Twist aside = TurnToAside();
  if (aside.turn_rad_s != 0.0) return aside;
  // One image of a search showed a thing that the next ones do not.
  if (search_.begun() && !guide_.now && here_.fits == 0 && here_.For(now_) > options_.glance_s) {
    round_.skip_rad = nominal_.half_view_rad;
    Enter(Phase::kSearch, "nothing is there");
    return {};
  }
  // A guide this low is cut by the view's edge, or lies below it: only a near one.
  const bool near = !guide_.last || guide_.last->range_m < options_.low_within_m;
  const bool low = near && (!guide_.now || guide_.now->clipped);
  if (here_.For(now_) > options_.glance_s && here_.fits == 0 && low && kept_.arm_rad == 0.0 &&
      !tries_.low) {
    kept_.arm_rad = options_.look_low_rad;
    kept_.lamps = tries_.low = true;
    Enter(Phase::kLook, "looks lower");
    return {};
  }
  // At the start the guide is in view, by the mission: far off it shows in some images alone.
  const bool first = guide_.detected == 0;
  if (here_.For(now_) < (first ? options_.first_patience_s : options_.patience_s)) return {};
  tries_.low = false;
  const bool believed_here = filter_.located() && !round_.hypothetical && !guide_.now &&
                             std::abs(filter_.bearing_rad()) < options_.glance_rad &&
                             filter_.range_m() > options_.believed_from_m &&
                             filter_.range_m() < options_.far_m;
  if (believed_here) filter_.Forget();
  if (first || !guide_.last || UnseenFor(guide_, now_) > options_.lost_s) {
    kept_.arm_rad = 0.0;
    if (MayBeAhead(guide_, options_)) {
      Enter(Phase::kCreep, "on towards a far guide");
    } else {
      Enter(Phase::kSearch, "no guide in view");
    }
  } else if (guide_.last->range_m > options_.creep_to_m) {
    Enter(Phase::kCreep, "the guide is too far for its marks");
  } else if (tries_.backs < options_.backs) {
    ++tries_.backs;
    round_.glance_side = guide_.last->bearing_rad < 0.0 ? -1.0 : 1.0;
    Enter(Phase::kGlance, "the guide shows no marks");
  } else {
    tries_.backs = 0;
    round_.side = 0.0;
    filter_.Forget();
    ++tries_.attempts;
    Refute("this guide never shows marks");
  }
  return {};
}

/// The guide in view is none: it is not searched again until all else has been.
void Pilot::Refute(const std::string& why) {
  const GuideSighting& guide = *guide_.last;
  refuted_.Add({guide.bearing_rad, guide.range_m,
                options_.refuted_m + options_.refuted_share * guide.range_m});
  guide_ = AfterRefuting(guide_, options_);
  filter_.Forget();
  kept_.arm_rad = 0.0;
  Enter(Phase::kLook, why);
}

Twist Pilot::Search() {
  round_.skip_rad = std::max(0.0, round_.skip_rad - std::abs(turned_rad_));
  // A thing that the view's edge cuts comes into view, or has been there.
  const bool whole =
      guide_.now && (!guide_.now->clipped || guide_.now->range_m < options_.low_within_m);
  if (whole && round_.skip_rad == 0.0) {
    Enter(Phase::kLook, "guide in view");
    return {};
  }
  if (!search_.begun()) {
    search_.Begin(filter_.located() ? -filter_.bearing_rad() : -1.0);
  }
  tries_.searched_rad += std::abs(turned_rad_);
  if (filter_.located() && !round_.other_side && tries_.searched_rad > AllRound(options_)) {
    // It stands where the pyramid hides its guide: it went round it by the wrong side, or by a
    // wrong pose.
    round_.other_side = true;
    round_.side = -round_.side;
    guide_.last->range_m = filter_.range_m();
    guide_.last->bearing_rad = filter_.bearing_rad();
    GoRound();
    return {};
  }
  if (tries_.searched_rad > AllRound(options_) && !refuted_.empty() && !tries_.all_refuted) {
    // One of them is the pyramid after all, seen from behind.
    tries_.all_refuted = true;
    refuted_.Clear();
  }
  // From here, the guide and a thing behind it may be one orange region.
  const bool again = tries_.elsewheres < kElsewheres;
  const bool across = std::abs(std::cos(tries_.from_start_rad)) < std::sin(kAcross_rad);
  if (tries_.searched_rad > (tries_.all_refuted ? options_.most_search_rad : AllRound(options_)) &&
      across && again) {
    ++tries_.elsewheres;
    tries_.searched_rad = 0.0;
    tries_.all_refuted = false;
    search_.Begin(std::sin(tries_.from_start_rad));  // back to where the guide was
    Enter(Phase::kBack, "searches from elsewhere");
    here_.back_m = kElsewhere_m;
    return {};
  }
  if ((tries_.searched_rad > options_.most_search_rad && !again) ||
      tries_.attempts >= options_.attempts) {
    Enter(Phase::kGivenUp, "no pyramid from two places");
    return {};
  }
  return {0.0, search_.Step(turned_rad_)};
}

Twist Pilot::Creep() {
  if (UnseenFor(guide_, now_) > options_.lost_s && !MayBeAhead(guide_, options_)) {
    Enter(Phase::kLook, "lost the guide");
    return {};
  }
  kept_.arm_rad = 0.0;
  const double turn_rad_s =
      std::clamp(kCreepGain_per_s * guide_.bearing_rad, -kCreepTurn_rad_s, kCreepTurn_rad_s);
  if (!guide_.now) return {options_.creep_m_s, turn_rad_s};
  const bool sure = here_.agreed >= options_.agreeing_images && !round_.hypothetical &&
                    SureOfAngle(filter_, options_);
  const bool bare = HasNoSquare(guide_, options_.agreeing_images) && !tries_.all_refuted;
  if (sure || bare || guide_.now->range_m < options_.creep_to_m) {
    Enter(Phase::kLook, "near enough");
    return {};
  }
  return {options_.creep_m_s, turn_rad_s};
}

Twist Pilot::Glance() {
  const bool bare = HasNoSquare(guide_, options_.agreeing_images) && !tries_.all_refuted;
  // It glances at near guides alone. To go round a far thing would lead away from the near one.
  const bool another = guide_.last->range_m > kAnother * options_.creep_to_m;
  if (here_.fits > 0 || bare || another || UnseenFor(guide_, now_) > options_.lost_s) {
    Enter(Phase::kLook, here_.fits > 0 ? "marks next to the guide"
                        : another      ? "another thing is in view"
                                       : "no square by this guide");
    return {};
  }
  const double left = guide_.last->bearing_rad - round_.glance_side * options_.glance_rad;
  const bool there =
      std::abs(left) < options_.turn_tolerance_rad || here_.For(now_) > options_.glance_most_s;
  if (!there) return TurnAt(left, options_.seen_turn_rad_s, options_);
  if (!here_.glanced) {
    here_.glanced = true;
    round_.glance_side = -round_.glance_side;
    here_.entered = now_;
    return {};
  }
  if (tries_.backs > options_.straight_backs) {
    GoRound();
  } else {
    Enter(Phase::kBack, "no marks on either side");
    here_.back_m = options_.back_m;
  }
  return {};
}

/// Goes round a guide that shows no marks: it takes the axis to lie round_rad further on, and
/// drives there. The first side is the one that the pictures make likely. It stays, so that the
/// robot comes to the front in the end.
void Pilot::GoRound() {
  if (round_.side == 0.0) round_.side = guide_.sides < 0.0 ? -1.0 : 1.0;
  search_.End();
  filter_.Hypothesise(*guide_.last, round_.side * options_.round_rad);
  round_.hypothetical = true;
  legs_ = PlanToGate(filter_.X_DN(), nominal_, options_).legs;
  BeginLeg();
  belief_.note = "goes round a guide without marks";
}

Twist Pilot::Back() {
  if (here_.driven_m < -here_.back_m) {
    Enter(Phase::kLook, "backed off");
    return {};
  }
  return {-options_.back_share * options_.creep_m_s, 0.0};
}

}  // namespace dockyard::raposa
