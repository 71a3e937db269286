#include "controller/raposa/pilot.h"

#include <cmath>

#include "controller/motion/limits.h"
#include "controller/raposa/drive.h"
#include "controller/raposa/lean.h"
#include "controller/raposa/odometry.h"
#include "controller/raposa/picture_report.h"

namespace dockyard::raposa {
namespace {

// A belief that changes by more, while the robot manoeuvres, is of another pose. Assumed, 0.1-0.3
// m, 8-20 deg.
constexpr double kOther_m = 0.2, kOther_rad = Radians(12.0);
// After so many pictures in which nothing fits the belief, every third is looked at without it.
// Assumed, 3-10 and 2-5.
constexpr int kFitless = 5, kAfresh = 3;

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
  ++belief_.sighting_count;
  belief_.last_sighting = ReportOf(
      *seen, seen->fits.empty() ? Pose2{} : filter_.PlacedBy(seen->fits.front(), age_s), nominal_);
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
  commands.verdict = phase_ == Phase::kDocked    ? Verdict::kDone
                     : phase_ == Phase::kGivenUp ? Verdict::kGivenUp
                                                 : Verdict::kUnderWay;
  Believe();
  KeepLimits(nominal_.motors, &commands);
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
