#include "controller/rocky7/approach.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/steering.h"
#include "controller/rocky7/exposure.h"

namespace dockyard::rocky7 {
namespace {

// Cameras that do not answer are asked again after so long, so often. Assumed, 1-10 s and 2-10.
constexpr Tick kAskAgain = 3000;
constexpr int kMostAsks = 5;
// Share of a miss that the next arc is aimed off by, and the most. Assumed, 0.5-1 and 2-4 cm.
constexpr double kAimGain = 0.8, kMostAim_m = 0.03;
// Of a long first arc so much is driven before the next look. Assumed, 0.15-0.3 m.
constexpr double kFirstPart_m = 0.2;
// What counts about a stone for the exposure, to either side. Assumed, 8-20 px.
constexpr int kStoneLevel_px = 12;
// Back from where the target is not seen. Assumed, 5-20 cm.
constexpr double kStepBack_m = 0.1;
// An arc that will miss by more than this, or this share of what is left of it, is left for a new
// one. Assumed, 1-2 cm and 0.05-0.2.
constexpr double kOffAtEnd_m = 0.015, kOffShare = 0.1;
// So much of an arc is left for short parts with looks between them: the rover that stands sees
// best, and a part misses by less than the whole. Assumed, 10-20 cm.
constexpr double kLast_m = 0.15;
// Looks under way in a row without the target, after which the rover stands to look. Assumed, 1-3.
constexpr int kMostMissesUnderWay = 2;

}  // namespace

Approach::Approach(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
                   const ApproachOptions& options)
    : nominal_(nominal),
      options_(options),
      eye_(nominal),
      drive_(nominal),
      tracker_(std::move(tracker)),
      target_(options.odometry) {}

void Approach::Tell(const std::string& phase, const std::string& note) {
  belief_.phase = phase;
  if (!note.empty()) belief_.note = note;
  belief_.values = {{"target_x_m", target_.p_RT().x()},
                    {"target_y_m", target_.p_RT().y()},
                    {"looks", static_cast<double>(looks_)}};
}

void Approach::GiveUp(const std::string& why) {
  verdict_ = Verdict::kGivenUp;
  Tell("given_up", why);
}

void Approach::Report(const TargetSeen& seen, const ImuSample& attitude) {
  SightingReport report;
  report.accepted = seen.found;
  report.reason = seen.found ? "" : seen.why;
  report.method = "stereo";
  const Eigen::Matrix3d R_ER = RotY(attitude.pitch_rad) * RotX(attitude.roll_rad);
  const Eigen::Vector3d p_E(seen.p_E.x(), seen.p_E.y(), seen.height_m - nominal_.rolling_radius_m);
  report.X_RB = {R_ER.transpose(), R_ER.transpose() * p_E};
  if (seen.found) {
    const auto pixel = nominal_.front.left.Project(Inverse(nominal_.front.X_RL) * report.X_RB.p);
    if (pixel) report.marks.push_back({0, kFrontLeft, pixel->x(), pixel->y()});
    report.detected = {1, 1};
  }
  belief_.last_sighting = report;
  ++belief_.sighting_count;
}

std::vector<Arc> Approach::PathToTarget() const {
  if (options_.backs_up) return GentleArcsToPoint(target_.p_RT() + aim_m_, nominal_.plan);
  const ArcLimits limits = GentleLimits(nominal_.plan);
  const auto arc = OneArcTo(target_.p_RT(), nominal_.plan.p_RP);
  return arc ? std::vector<Arc>{NoSharper(*arc, limits)} : std::vector<Arc>{};
}

void Approach::Drive(const Arc& way) {
  const Arc arc = options_.odometry.slip > 0.0
                      ? NoSharper(target_.AgainstSlip(way), GentleLimits(nominal_.plan))
                      : way;
  way_ = way;
  looked_at_m_ = 0.0;
  misses_under_way_ = 0;
  drive_.Start(arc);
  driving_ = true;
  target_.BeginArc(arc, yaw_rad_);
  belief_.plan = {{.X_DR_start = {}, .length_m = arc.length_m, .turn_rad = arc.turn_rad}};
  ++belief_.plan_count;
  Tell("drive",
       "drives " + std::to_string(static_cast<int>(std::lround(1e3 * arc.length_m))) + " mm");
}

TargetSeen Approach::Look(const StereoImages& images, const SensorFrame& sensed) {
  ++looks_;
  const ImuSample attitude = target_.BeginLook(ExposureOfFront(sensed));
  const GroundSeen ground = eye_.Look(images, attitude);
  const bool saw_motion =
      options_.sees_motion && target_.SeeGround(eye_.PictureAhead(ground, images));
  TargetSeen seen;
  if (begun_) {
    seen = tracker_->Follow(eye_.MapsAbout(ground, target_.p_RT()), target_.predicted());
  } else if (const auto clicked = eye_.ClickOf(ground, nominal_.target_px)) {
    seen = tracker_->Begin(eye_.MapsAbout(ground, clicked->p_E), *clicked);
    begun_ = seen.found;
  } else {
    seen.why = "no range data where the user clicked";
  }
  Report(seen, attitude);
  if (seen.found || seen.guess) target_.TakeOver(seen.p_E, saw_motion ? 0.0 : seen.further_m);
  target_.EndLook();
  Tell("look", seen.why);
  return seen;
}

void Approach::LookStanding(const StereoImages& images, const SensorFrame& sensed) {
  const TargetSeen seen = Look(images, sensed);
  watched_ = false;
  if (seen.found) {
    misses_ = 0;
    return Decide();
  }
  ++misses_;
  if (misses_ >= options_.most_misses || !begun_) return GiveUp("lost the target: " + seen.why);
  // From afar it goes on by odometry, to see better; near by it looks again, and then from further
  // back.
  if ((target_.p_RT() - nominal_.plan.p_RP).norm() <= options_.blind_beyond_m) {
    if (options_.backs_up && misses_ % 2 == 0) Drive({-kStepBack_m, 0.0});
    return;
  }
  Decide();
}

// By how much the point would miss the target at the end of the whole arc.
double Approach::OffAtEnd() const {
  const double gone = drive_.share() * way_.length_m / to_target_.length_m;
  const Pose2 X_RE = Advance({}, Part(to_target_, 1.0 - gone));
  return (X_RE * nominal_.plan.p_RP - target_.p_RT() - aim_m_).norm();
}

void Approach::LookUnderWay(const StereoImages& images, const SensorFrame& sensed) {
  looked_at_m_ = std::abs(drive_.driven_m());
  const TargetSeen seen = Look(images, sensed);
  misses_under_way_ = seen.found ? 0 : misses_under_way_ + 1;
  const double left_m = std::abs(to_target_.length_m) - drive_.share() * std::abs(way_.length_m);
  const bool misses = OffAtEnd() > std::max(kOffAtEnd_m, kOffShare * left_m);
  if (!misses && misses_under_way_ < kMostMissesUnderWay) return Tell("drive", "");
  drive_.Stop(sensed);
  Tell("drive", misses ? "stops: the arc would miss the target" : "stops: " + seen.why);
}

TargetSeen Approach::Peek(const StereoImages& images, const SensorFrame& sensed) {
  ++looks_;
  const GroundSeen ground = eye_.Look(images, sensed.imu);
  const Eigen::Vector2d& p_RT = target_.p_RT();
  const TargetSeen seen = tracker_->Check(eye_.MapsAbout(ground, p_RT), {p_RT.x(), p_RT.y(), 0.0});
  Report(seen, sensed.imu);
  Tell("peek", seen.why);
  return seen;
}

void Approach::Decide() {
  const double off_m = (target_.p_RT() - nominal_.plan.p_RP).norm();
  if (off_m <= options_.claim_share * nominal_.reach_m) {
    verdict_ = Verdict::kDone;
    return Tell("there", "the point is on the target");
  }
  if (looks_ >= options_.most_looks) return GiveUp("cannot stabilize about the goal");
  // What the last arc to the target has missed by, the next one will miss by again: slopes and
  // stones under the wheels are still there.
  if (options_.backs_up && aimed_ && off_m < kMostAim_m) {
    aim_m_ += kAimGain * (target_.p_RT() - nominal_.plan.p_RP);
    aim_m_ *= std::min(1.0, kMostAim_m / std::max(aim_m_.norm(), 1e-9));
  }
  aimed_ = false;
  if (options_.most_stalls > 0 &&
      retreat_.Look(off_m, options_.blind_beyond_m, options_.most_stalls)) {
    aim_m_.setZero();
    return Drive(retreat_.Next());
  }
  const std::vector<Arc> path = PathToTarget();
  if (path.empty()) return GiveUp("no arcs lead to the target");
  // A first arc that only makes room is short, and driven whole.
  const Arc& arc = path.front();
  const double left_m = std::abs(arc.length_m);
  const bool single = path.size() == 1;
  watched_ = single && options_.look_each_m > 0.0 && left_m > kLast_m + options_.look_each_m;
  const double part_m =
      single ? std::max(options_.least_step_m, options_.image_share * left_m) : kFirstPart_m;
  const double step_m = watched_ ? left_m - kLast_m : part_m;
  aimed_ = single && step_m >= left_m;
  to_target_ = arc;
  Drive(step_m >= left_m ? arc : Part(arc, step_m / left_m));
}

// Whether the target's surroundings are worth another picture with another exposure.
bool Approach::TooDark(const GrayImage& left, const ImuSample& attitude) {
  if (!options_.exposes_for_target) return false;
  Eigen::Vector2d at = nominal_.target_px;
  if (begun_) {
    const Eigen::Matrix3d R_ER = RotY(attitude.pitch_rad) * RotX(attitude.roll_rad);
    const Eigen::Vector3d p_E(target_.p_RT().x(), target_.p_RT().y(), -nominal_.rolling_radius_m);
    const auto pixel = nominal_.front.left.Project(Inverse(nominal_.front.X_RL) *
                                                   Eigen::Vector3d(R_ER.transpose() * p_E));
    if (!pixel) return false;
    at = *pixel;
  }
  const auto more = MoreStops(left, at, kStoneLevel_px, stops_);
  if (!more) return false;
  stops_ += *more;
  return true;
}

bool Approach::Waits(const SensorFrame& sensed) const {
  return asked_ && sensed.tick - *asked_ < kAskAgain;
}

void Approach::Ask(const SensorFrame& sensed, Commands& commands) {
  commands.take_images = {kFrontLeft, kFrontRight};
  commands.exposure_stops = stops_;
  asked_ = sensed.tick;
}

void Approach::StepStanding(const SensorFrame& sensed, Commands& commands) {
  if (const auto images = FrontPair(sensed)) {
    asked_.reset();
    asks_ = 0;
    if (!TooDark(images->left, sensed.imu)) LookStanding(*images, sensed);
  }
  if (verdict_ != Verdict::kUnderWay || driving_ || Waits(sensed)) return;
  if (++asks_ > kMostAsks) return GiveUp("the cameras do not answer");
  Ask(sensed, commands);
  Tell("look", "");
}

// Cameras that do not answer cost nothing here.
void Approach::StepUnderWay(const SensorFrame& sensed, Commands& commands) {
  if (!watched_) return;
  if (const auto images = FrontPair(sensed)) {
    asked_.reset();
    return LookUnderWay(*images, sensed);
  }
  const double since_m = std::abs(drive_.driven_m()) - looked_at_m_;
  const double left_m = (1.0 - drive_.share()) * std::abs(way_.length_m);
  if (since_m >= options_.look_each_m && left_m >= options_.look_each_m && !Waits(sensed)) {
    Ask(sensed, commands);
  }
}

Commands Approach::Step(const SensorFrame& sensed) {
  Commands commands;
  commands.motors.resize(nominal_.motors.size());
  yaw_rad_ = sensed.imu.yaw_rad;
  const bool drove = driving_;
  if (drove) commands.motors = drive_.Step(sensed);
  target_.Step(drive_, drove, sensed);
  driving_ = drove && !drive_.done();
  if (verdict_ == Verdict::kUnderWay && driving_) StepUnderWay(sensed, commands);
  if (verdict_ == Verdict::kUnderWay && !driving_) StepStanding(sensed, commands);
  commands.verdict = verdict_;
  return commands;
}

}  // namespace dockyard::rocky7
