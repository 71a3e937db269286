#include "controller/raposa/pilot.h"

#include <algorithm>
#include <cmath>

#include "controller/raposa/drive.h"
#include "controller/raposa/lean.h"
#include "controller/raposa/odometry.h"

namespace dockyard::raposa {
namespace {

// A belief that changes by more, while the robot manoeuvres, is of another pose. Assumed, 0.1-0.3
// m, 8-20 deg.
constexpr double kOther_m = 0.2, kOther_rad = Radians(12.0);
// After so many pictures in which nothing fits the belief, every third is looked at without it.
// Assumed, 3-10 and 2-5.
constexpr int kFitless = 5, kAfresh = 3;
// On straight legs: an offset dies out over it, and the speed falls before their ends. Assumed,
// 0.2-0.5 m, 0.3-0.7 rad/s, 1-2 /s, 0.02-0.05 m/s.
constexpr double kLegSettle_m = 0.3, kLegTurn_rad_s = 0.5, kLegGain_per_s = 1.5,
                 kLegLast_m_s = 0.03;
// The way in is broken off outside of a wider cone, and not any more in its last part. Assumed,
// 0.016-0.03 m, 0.08-0.2, 1.2-2, 0.02-0.05 m, 0.2-0.5 rad/s.
constexpr double kOff_m = 0.02, kOffSlope = 0.1, kOffHeading = 1.5, kCommitted_m = 0.03;
constexpr double kApproachTurn_rad_s = 0.35;
// On the way in the guide keeps so far from the view's edge, as foretold for this time after the
// command. Assumed, 1-4 deg and 0.2-0.5 s.
constexpr double kEdge_rad = Radians(2.0), kEdgeLead_s = 0.4;
// A standing robot turns to a guide that is cut by the view's edge and so far aside; assumed, 4-8
// deg.
constexpr double kAside_rad = Radians(6.0);
// Doors stand where they are told to within this, or have had their time: they take 5 s for 30 mm.
constexpr double kDoorAt_m = 0.004, kDoorAjar_s = 4.0, kDoorOpen_s = 6.0;
// Backwards, and nudging, at shares of the forward speeds. Assumed, 0.4-0.8.
constexpr double kBackShare = 0.6, kNudgeShare = 0.5;
// A search to and fro by 20, 40, 80, 160 and 320 deg has then seen all round.
constexpr double kAllRound_rad = Radians(620.0);
// Towards a guide: its bearing dies out in a second. Assumed, 0.5-2 /s and 0.1-0.3 rad/s.
constexpr double kCreepGain_per_s = 1.0, kCreepTurn_rad_s = 0.2;

FerreiraMotion SearchOptions(const DockyardOptions& options) {
  FerreiraMotion search;
  search.search_turn_rad_s = options.search_rad_s;
  search.first_search_rad = options.first_search_rad;
  return search;
}

}  // namespace

const char* Name(Pilot::Phase phase) {
  static const char* const names[] = {"look",  "search",  "creep",    "glance",  "back",  "turn",
                                      "leg",   "face",    "approach", "brake",   "close", "ajar",
                                      "prove", "retreat", "docked",   "given_up"};
  return names[static_cast<std::size_t>(phase)];
}

Pilot::Pilot(const Nominal& nominal, const DockyardOptions& options)
    : nominal_(nominal),
      options_(options),
      filter_(nominal, options),
      doors_(nominal, options),
      search_(SearchOptions(options)),
      door_open_m_(nominal.door_travel_m) {
  belief_.phase = Name(phase_);
  belief_.values = {
      {"state", 0.0}, {"alpha_deg", 0.0}, {"r_m", 0.0}, {"passes", 0.0}, {"gauge_share", 1.0}};
}

double Pilot::Gauge() const {
  return nominal_.effective_gauge_m * (ArmPressed() ? options_.pressed_gauge_share : 1.0);
}

double Pilot::pitch_rad() const { return CameraPitch(nominal_) + LeanOf(nominal_, arm_rad_); }

std::optional<PyramidPrior> Pilot::Prior() const {
  // Where nothing is seen that fits what is believed, it looks afresh now and then.
  const bool afresh = supposed_ || (fitless_ > kFitless && fitless_ % kAfresh == 0);
  if (!filter_.located() || afresh) return std::nullopt;
  PyramidPrior prior = filter_.Prior();
  prior.covariance *= options_.prior_share * options_.prior_share;
  prior.covariance.diagonal() +=
      Eigen::Vector3d(options_.prior_m, options_.prior_m, options_.prior_rad).cwiseAbs2();
  return prior;
}

void Pilot::Enter(Phase phase, const std::string& note) {
  phase_ = phase;
  entered_ = now_;
  driven_m_ = 0.0;
  fits_ = 0;
  turned_aside_rad_ = 0.0;
  glanced_ = false;
  belief_.note = note;
  if (phase != Phase::kSearch) search_.End();
  if (phase == Phase::kClose) doors_.Begin();
}

void Pilot::Sense(const SensorFrame& sensed, const PyramidSeen* seen, double age_s) {
  now_ = sensed.tick;
  const auto angle = [&](Motor motor) {
    const auto i = static_cast<std::size_t>(motor);
    return static_cast<double>(sensed.motors[i].encoder_counts) * nominal_.motors[i].rad_per_count;
  };
  const double arm_before = arm_rad_;
  arm_rad_ = angle(Motor::kArm);
  const std::array<double, 2> belts_m{nominal_.sprocket_radius_m * angle(Motor::kLeftBelt),
                                      nominal_.sprocket_radius_m * angle(Motor::kRightBelt)};
  if (belts_m_) {
    const BeltSteps steps{.left_m = belts_m[0] - (*belts_m_)[0],
                          .right_m = belts_m[1] - (*belts_m_)[1],
                          .driven = last_.speed_m_s != 0.0 || last_.turn_rad_s != 0.0,
                          .gauge_m = Gauge(),
                          .arm_m = nominal_.sprocket_radius_m * std::abs(arm_rad_ - arm_before),
                          .dt_s = kTickSeconds * kControlPeriod};
    turned_rad_ = (steps.right_m - steps.left_m) / steps.gauge_m;
    const double way_m = -0.5 * (steps.left_m + steps.right_m);
    driven_m_ += way_m;
    unseen_m_ += std::abs(way_m);
    guide_bearing_rad_ -= filter_.gauge_share() * turned_rad_;
    filter_.Drive(steps);
  }
  belts_m_ = belts_m;
  doors_.Read(sensed);
  if (seen == nullptr || !Looks()) return;
  guide_ = seen->guide;
  if (guide_) {
    guide_seen_ = now_;
    last_guide_ = guide_;
    unseen_m_ = 0.0;
    guide_bearing_rad_ = guide_->bearing_rad;
  }
  if (!seen->fits.empty()) {
    ++fits_;
    fitless_ = 0;
    sides_seen_ = 0.0;
    ++belief_.sighting_count;
  }
  if (seen->fits.empty()) ++fitless_;
  if (guide_ && seen->fits.empty()) sides_seen_ += guide_->likely_side;
  if (supposed_ && !seen->fits.empty()) {
    supposed_ = false;
    filter_.Forget();
    filter_.See(*seen, age_s);
    Enter(Phase::kLook, "marks in view");
    return;
  }
  const bool was = filter_.located();
  const Pose2 before = was ? filter_.X_DN() : Pose2{};
  filter_.See(*seen, age_s);
  if (!was || (phase_ != Phase::kTurn && phase_ != Phase::kLeg && phase_ != Phase::kFace)) return;
  const Pose2 change = Inverse(before) * filter_.X_DN();
  if (std::hypot(change.x, change.y) > kOther_m || std::abs(change.heading) > kOther_rad) {
    Enter(Phase::kLook, "the pyramid stands otherwise than thought");
  }
}

Commands Pilot::Step(const SensorFrame& sensed, const PyramidSeen* seen, double age_s) {
  Sense(sensed, seen, age_s);
  last_ = Act();
  Commands commands = BrakedCommands();
  if (last_.speed_m_s != 0.0 || last_.turn_rad_s != 0.0) {
    // drive.h reckons with the gauge of a level arm.
    const double share = Gauge() / nominal_.effective_gauge_m;
    SetBelts(nominal_, {last_.speed_m_s, share * last_.turn_rad_s}, &commands);
  }
  SetArm(nominal_, arm_told_rad_, &commands);
  SetDoors(nominal_, door_open_m_, &commands);
  if (Looks()) commands.take_images = {kBackCamera};
  commands.switches[kLamps] = lamps_ ? 1 : 0;
  commands.verdict = phase_ == Phase::kDocked    ? Verdict::kDocked
                     : phase_ == Phase::kGivenUp ? Verdict::kGivenUp
                                                 : Verdict::kUnderWay;
  Believe();
  return commands;
}

Twist Pilot::Act() {
  const bool over = phase_ == Phase::kDocked || phase_ == Phase::kGivenUp;
  if (!over && For() > options_.phase_s) {
    TryAgain(std::string("no end of ") + Name(phase_));
    return {};
  }
  switch (phase_) {
    case Phase::kLook:
      return Look();
    case Phase::kSearch:
      return Search();
    case Phase::kCreep:
      return Creep();
    case Phase::kGlance:
      return Glance();
    case Phase::kBack:
      return Back();
    case Phase::kTurn:
      return Turn();
    case Phase::kLeg:
      return DriveLeg();
    case Phase::kFace:
      return Face();
    case Phase::kApproach:
      return Approach();
    case Phase::kBrake:
      if (For() >= options_.brake_s) {
        door_open_m_ = 0.0;
        Enter(Phase::kClose, "");
      }
      return {};
    case Phase::kClose:
      return Close();
    case Phase::kAjar:
      return Ajar();
    case Phase::kProve:
      return Prove();
    case Phase::kRetreat:
      return Retreat();
    case Phase::kDocked:
    case Phase::kGivenUp:
      break;
  }
  return {};
}

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

void Pilot::Decide() {
  const double sigma = std::sqrt(filter_.covariance()(2, 2));
  if (sigma > options_.sure_heading_rad && filter_.range_m() > options_.creep_to_m) {
    Enter(Phase::kCreep, "the angle is not sure");
    return;
  }
  backs_ = 0;
  round_side_ = 0.0;
  other_side_ = false;
  searched_rad_ = 0.0;
  pressed_once_ = false;
  const Pose2 X_DN = filter_.X_DN();
  if (InCone(X_DN, options_)) {
    nudges_ = 0;
    const double end_m = SeatBehind(nominal_, LeanOf(nominal_, PressAngle())) + options_.short_m;
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
  if (passes_ >= options_.passes) {
    Enter(Phase::kGivenUp, "too many ways to the axis");
    return;
  }
  legs_ = plan.legs;
  ++passes_;
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
  arm_told_rad_ = 0.0;
  if (legs_.empty()) {
    Enter(Phase::kFace, "at the gate");
    return;
  }
  Enter(Phase::kTurn, "to the gate");
}

Twist Pilot::TurnTo(double heading_rad, bool* done) const {
  const double left = WrapPi(heading_rad - filter_.X_DN().heading);
  *done = std::abs(left) < options_.turn_tolerance_rad;
  if (*done) return {};
  const double most = GuideExpected() ? options_.seen_turn_rad_s : options_.turn_rad_s;
  const double rate = std::clamp(options_.turn_gain_per_s * left, -most, most);
  return {0.0, std::copysign(std::max(std::abs(rate), options_.least_turn_rad_s), rate)};
}

/// Whether pictures say anything: not from the last part of the way in until it drives off again.
bool Pilot::Looks() const {
  switch (phase_) {
    case Phase::kBrake:
    case Phase::kClose:
    case Phase::kAjar:
    case Phase::kProve:
    case Phase::kDocked:
    case Phase::kGivenUp:
      return false;
    case Phase::kApproach:
      return !filter_.located() || filter_.range_m() > options_.blind_m;
    default:
      return true;
  }
}

/// Whether the guide should be in view.
bool Pilot::GuideExpected() const {
  return filter_.located() && std::abs(filter_.bearing_rad()) < nominal_.half_view_rad;
}

Twist Pilot::Turn() {
  bool done = false;
  const Twist twist = TurnTo(legs_.front().heading_rad, &done);
  if (!done) return twist;
  const Leg& leg = legs_.front();
  const Eigen::Vector2d along(std::cos(leg.heading_rad), std::sin(leg.heading_rad));
  const Eigen::Vector2d start = leg.p_D_end - leg.length_m * along;
  const Pose2 X_DN = filter_.X_DN();
  // The way from where the robot stands after its turn; the turning centre moves a little.
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
  bool done = false;
  // To the guide: off the axis by a little it is to be in the middle of the view.
  const Twist twist = TurnTo(std::atan2(-X_DN.y, -X_DN.x), &done);
  if (done) Enter(Phase::kLook, "at the gate");
  return twist;
}

/// No turn out of the view: without pictures the way in would be blind.
void Pilot::KeepInView(Twist* twist) const {
  if (!Looks()) return;
  const double radius_rad = std::atan2(0.5 * nominal_.marks.guide_diameter_m, filter_.range_m());
  const double most = std::max(0.0, nominal_.half_view_rad - kEdge_rad - radius_rad);
  const double bearing = filter_.bearing_rad();
  twist->turn_rad_s =
      std::clamp(twist->turn_rad_s, (bearing - most) / kEdgeLead_s, (bearing + most) / kEdgeLead_s);
}

Twist Pilot::Approach() {
  const Pose2 X_DN = filter_.X_DN();
  if (X_DN.x < options_.press_m) {
    arm_told_rad_ = PressAngle();
    lamps_ = true;
  } else {
    arm_told_rad_ = 0.0;
  }
  const double ahead_m = X_DN.x - options_.cone_from_m;
  if (ahead_m > kCommitted_m) {
    if (UnseenFor() > options_.lost_s) {
      Enter(Phase::kLook, "lost the guide");
      return {};
    }
    if (std::abs(X_DN.y) > kOff_m + kOffSlope * ahead_m ||
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
  if (!follower_->done()) KeepInView(&twist);
  // Half a period's way before or after the end, whichever is nearer.
  const double stop_m = 0.5 * kTickSeconds * kControlPeriod * speed;
  if (!follower_->done() && follower_->Remaining() > stop_m) return twist;
  Enter(Phase::kBrake, "at the seat, as believed");
  return {};
}

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
  if (!there) return {-kBackShare * options_.approach_m_s, 0.0};
  arm_told_rad_ = 0.0;
  filter_.Forget();
  Enter(Phase::kLook, "backed off");
  return {};
}

/// A far guide shows in some pictures alone: it is gone on to for a while. At the start it is told
/// to be in view.
bool Pilot::MayBeAhead() const {
  const bool far = !last_guide_ || last_guide_->range_m > options_.far_m;
  return far && unseen_m_ < options_.unseen_way_m;
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
  return {-kBackShare * options_.creep_m_s, 0.0};
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

void Pilot::Believe() {
  belief_.phase = Name(phase_);
  belief_.located = filter_.located();
  belief_.values[0].value = static_cast<double>(phase_);
  belief_.values[3].value = passes_;
  belief_.values[4].value = filter_.gauge_share();
  if (!filter_.located()) return;
  const Pose2 X_DN = filter_.X_DN();
  belief_.X_DR = {X_DN.x, X_DN.y, WrapPi(X_DN.heading + kPi)};
  belief_.values[1].value = Degrees(filter_.alpha_rad());
  belief_.values[2].value = filter_.range_m();
}

}  // namespace dockyard::raposa
