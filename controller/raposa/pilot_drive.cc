// The phases in which the pilot manoeuvres to the axis and drives in along it.
#include "controller/raposa/pilot.h"

#include <algorithm>
#include <cmath>

#include "controller/raposa/drive.h"
#include "controller/raposa/lean.h"

namespace dockyard::raposa {
namespace {

// On straight legs: an offset dies out over it, and the speed falls before their ends. Assumed,
// 0.2-0.5 m, 0.3-0.7 rad/s, 1-2 /s, 0.02-0.05 m/s.
constexpr double kLegSettle_m = 0.3, kLegTurn_rad_s = 0.5, kLegGain_per_s = 1.5,
                 kLegLast_m_s = 0.03;
// The way in is broken off outside of a wider cone, and not any more in its last part. Assumed,
// 0.016-0.03 m, 0.08-0.2, 1.2-2, 0.02-0.05 m, 0.2-0.5 rad/s.
constexpr double kOff_m = 0.02, kOffSlope = 0.1, kOffHeading = 1.5, kCommitted_m = 0.03;
// A guide farther aside of the robot's own axis would meet the funnel's rim: the last images of
// docked runs have it within 7 mm. Assumed, 0.01-0.02 m and 0.2-0.4.
constexpr double kAside_m = 0.012, kAsideSlope = 0.3;
constexpr double kApproachTurn_rad_s = 0.35;
// On the way in the guide keeps so far from the view's edge, as foretold for this time after the
// command. Assumed, 1-4 deg and 0.2-0.5 s.
constexpr double kEdge_rad = Radians(2.0), kEdgeLead_s = 0.4;

/// Left to turn to a heading; 0: it is there.
double LeftTo(double heading_rad, const PyramidFilter& filter, const DockyardOptions& options) {
  const double left = WrapPi(heading_rad - filter.X_DN().heading);
  return std::abs(left) < options.turn_tolerance_rad ? 0.0 : left;
}

/// As fast as the images allow where they should show the guide.
Twist TurnTo(double left_rad, const PyramidFilter& filter, const Nominal& nominal,
             const DockyardOptions& options) {
  const bool in_view = std::abs(filter.bearing_rad()) < nominal.half_view_rad;
  return TurnAt(left_rad, in_view ? options.seen_turn_rad_s : options.turn_rad_s, options);
}

/// No turn out of the view: without images the way in would be blind.
void KeepInView(const PyramidFilter& filter, const Nominal& nominal, Twist* twist) {
  const double radius_rad = std::atan2(0.5 * nominal.marks.guide_diameter_m, filter.range_m());
  const double most = std::max(0.0, nominal.half_view_rad - kEdge_rad - radius_rad);
  const double bearing = filter.bearing_rad();
  twist->turn_rad_s =
      std::clamp(twist->turn_rad_s, (bearing - most) / kEdgeLead_s, (bearing + most) / kEdgeLead_s);
}

}  // namespace

void Pilot::Decide() {
  const double sigma = std::sqrt(filter_.covariance()(2, 2));
  if (sigma > options_.sure_heading_rad && filter_.range_m() > options_.creep_to_m) {
    Enter(Phase::kCreep, "the angle is not sure");
    return;
  }
  if (!filter_.one_angle() && tries_.acrosses < options_.acrosses &&
      filter_.range_m() > options_.turn_room_m) {
    ++tries_.acrosses;
    tries_.crossing = true;
    legs_ = {AcrossSight(filter_.X_DN(), options_.across_m, options_)};
    BeginLeg();
    belief_.note = "across the line of sight: two poses are likely";
    return;
  }
  search_.End();
  tries_.acrosses = 0;
  tries_.all_refuted = false;
  tries_.backs = 0;
  round_.side = 0.0;
  round_.other_side = false;
  tries_.searched_rad = 0.0;
  tries_.low = false;
  const Pose2 X_DN = filter_.X_DN();
  if (InCone(X_DN, options_)) {
    tries_.nudges = 0;
    const double end_m =
        SeatBehind(nominal_,
                   LeanOf(nominal_, PressAngle(options_, tries_.attempts + tries_.nudges))) +
        options_.short_m;
    follower_.emplace(Pose2{X_DN.x, 0.0, kPi}, std::vector<Arc>{{X_DN.x - end_m, 0.0}});
    belief_.plan = {{Pose2{X_DN.x, 0.0, 0.0}, end_m - X_DN.x, 0.0}};
    ++belief_.plan_count;
    Enter(Phase::kApproach, "on the axis");
    return;
  }
  const GatePlan plan = PlanToGate(X_DN, nominal_, options_);
  if (plan.legs.empty()) {
    TryAgain("no way to the axis");
    return;
  }
  if (tries_.passes >= options_.passes) {
    Enter(Phase::kGivenUp, "too many ways to the axis");
    return;
  }
  legs_ = plan.legs;
  ++tries_.passes;
  belief_.plan.clear();
  Pose2 at = X_DN;
  for (const Leg& leg : legs_) {
    belief_.plan.push_back({{at.x, at.y, WrapPi(leg.heading_rad + kPi)}, -leg.length_m, 0.0});
    at = {leg.p_D_end.x(), leg.p_D_end.y(), leg.heading_rad};
  }
  ++belief_.plan_count;
  BeginLeg();
}

void Pilot::BeginLeg() {
  kept_.arm_rad = 0.0;
  if (legs_.empty()) {
    Enter(Phase::kFace, "at the gate");
    return;
  }
  Enter(Phase::kTurn, "to the gate");
}

Twist Pilot::Turn() {
  const double left = LeftTo(legs_.front().heading_rad, filter_, options_);
  if (left != 0.0) return TurnTo(left, filter_, nominal_, options_);
  const Leg& leg = legs_.front();
  const Eigen::Vector2d along(std::cos(leg.heading_rad), std::sin(leg.heading_rad));
  const Eigen::Vector2d start = leg.p_D_end - leg.length_m * along;
  const Pose2 X_DN = filter_.X_DN();
  // From where the robot is after its turn; the turning centre moves a little.
  const Eigen::Vector2d at(X_DN.x, X_DN.y);
  const double length_m = (leg.p_D_end - at).dot(along);
  follower_.emplace(Pose2{start.x(), start.y(), leg.heading_rad},
                    std::vector<Arc>{{leg.length_m, 0.0}});
  if (std::abs(length_m) < options_.way_tolerance_m) {
    legs_.erase(legs_.begin());
    BeginLeg();
    return {};
  }
  Enter(Phase::kLeg, "to the gate");
  return {};
}

Twist Pilot::DriveLeg() {
  const Steering steering{.settle_m = kLegSettle_m, .max_turn_rad_s = kLegTurn_rad_s};
  const double left_m = follower_->Remaining();
  const double speed = std::clamp(kLegGain_per_s * left_m + kLegLast_m_s,
                                  options_.least_approach_m_s, options_.travel_m_s);
  const Twist twist = follower_->Follow(filter_.X_DN(), speed, steering);
  if (!follower_->done() && follower_->Remaining() > options_.way_tolerance_m) return twist;
  legs_.erase(legs_.begin());
  BeginLeg();
  return {};
}

Twist Pilot::Face() {
  const Pose2 X_DN = filter_.X_DN();
  // To the guide: off the axis by a little it is to be in the middle of the view.
  const double left = LeftTo(std::atan2(-X_DN.y, -X_DN.x), filter_, options_);
  if (left != 0.0) return TurnTo(left, filter_, nominal_, options_);
  Enter(Phase::kLook, "at the gate");
  return {};
}

Twist Pilot::Approach() {
  const Pose2 X_DN = filter_.X_DN();
  if (X_DN.x < options_.press_m) {
    kept_.arm_rad = PressAngle(options_, tries_.attempts + tries_.nudges);
    kept_.lamps = true;
  } else {
    kept_.arm_rad = 0.0;
  }
  const double ahead_m = X_DN.x - options_.cone_from_m;
  if (ahead_m > kCommitted_m) {
    if (UnseenFor(guide_, now_) > options_.lost_s) {
      Enter(Phase::kLook, "lost the guide");
      return {};
    }
    if (std::abs(X_DN.y) > kOff_m + kOffSlope * ahead_m ||
        std::abs(Inverse(X_DN).y) > kAside_m + kAsideSlope * ahead_m ||
        std::abs(WrapPi(X_DN.heading - kPi)) > kOffHeading * options_.cone_heading_rad) {
      TryAgain("too far off the axis");
      return {};
    }
  }
  const double left_m = follower_->Remaining();
  const double speed = left_m < options_.end_m
                           ? options_.end_m_s
                           : std::clamp(options_.approach_gain_per_s * left_m,
                                        options_.least_approach_m_s, options_.approach_m_s);
  const double settle_m = Looks() ? options_.settle_m : options_.blind_settle_m;
  Twist twist =
      follower_->Follow(X_DN, speed, {.settle_m = settle_m, .max_turn_rad_s = kApproachTurn_rad_s});
  if (!follower_->done() && Looks()) KeepInView(filter_, nominal_, &twist);
  // Half a period's way before or after the end, whichever is nearer.
  const double stop_m = 0.5 * kTickSeconds * kControlPeriod * speed;
  if (!follower_->done() && follower_->Remaining() > stop_m) return twist;
  Enter(Phase::kBrake, "at the seat, as believed");
  return {};
}

}  // namespace dockyard::raposa
