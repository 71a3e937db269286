#include "controller/rocky7/approach.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/steering.h"
#include "controller/rocky7/exposure.h"
#include "controller/rocky7/odometry.h"

namespace dockyard::rocky7 {
namespace {

// Of odometry, of the way, 1 sigma: how far slip is off what is taken. Assumed, 0.05-0.15.
constexpr double kSlip = 0.1;
// The same aside, the heading being known: tandem wheels slip aside on arcs. Assumed, 0.02-0.08.
constexpr double kSideSlip = 0.05;
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

}  // namespace

Approach::Approach(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
                   const ApproachOptions& options)
    : nominal_(nominal),
      options_(options),
      eye_(nominal),
      drive_(nominal),
      tracker_(std::move(tracker)),
      slip_{options.slip, options.slip} {}

void Approach::Tell(const std::string& phase, const std::string& note) {
  belief_.phase = phase;
  if (!note.empty()) belief_.note = note;
  belief_.values = {
      {"target_x_m", p_RT_.x()}, {"target_y_m", p_RT_.y()}, {"looks", static_cast<double>(looks_)}};
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
  if (options_.backs_up) return GentleArcsToPoint(p_RT_ + aim_m_, nominal_.plan);
  const ArcLimits limits = GentleLimits(nominal_.plan);
  const auto arc = OneArcTo(p_RT_, nominal_.plan.p_RP);
  return arc ? std::vector<Arc>{NoSharper(*arc, limits)} : std::vector<Arc>{};
}

void Approach::Drive(const Arc& way) {
  // So that the rover itself, which slips, goes the way.
  const double more = 1.0 / (1.0 - SlipOf(way.length_m));
  const Arc arc{more * way.length_m, more * way.turn_rad};
  drive_.Start(arc);
  driving_ = true;
  const double along_m = kSlip * arc.length_m, aside_m = kSideSlip * arc.length_m;
  spread_m2_ += Eigen::Vector2d(along_m * along_m, aside_m * aside_m).asDiagonal();
  moved_before_ = {};
  yaw_at_start_rad_ = yaw_rad_;
  belief_.plan = {{.X_DR_start = {}, .length_m = arc.length_m, .turn_rad = arc.turn_rad}};
  ++belief_.plan_count;
  Tell("drive",
       "drives " + std::to_string(static_cast<int>(std::lround(1e3 * arc.length_m))) + " mm");
}

void Approach::TakeLook(const StereoImages& images, const SensorFrame& sensed) {
  ++looks_;
  const GroundSeen ground = eye_.Look(images, sensed.imu);
  TargetSeen seen;
  if (begun_) {
    seen = tracker_->Follow(eye_.MapsAbout(ground, p_RT_),
                            {{p_RT_.x(), p_RT_.y(), WrapPi(-turned_rad_)}, spread_m2_, way_m_});
  } else if (const auto clicked = eye_.ClickOf(ground, nominal_.target_px)) {
    seen = tracker_->Begin(eye_.MapsAbout(ground, clicked->p_E), *clicked);
    begun_ = seen.found;
  } else {
    seen.why = "no range data where the user clicked";
  }
  Report(seen, sensed.imu);
  if (seen.found) {
    LearnSlip(seen);
    TakeOver(seen);
    misses_ = 0;
    Tell("look", seen.why);
    return Decide();
  }
  ++misses_;
  Tell("look", seen.why);
  if (seen.guess) TakeOver(seen);
  if (misses_ >= options_.most_misses || !begun_) return GiveUp("lost the target: " + seen.why);
  // From afar it goes on by odometry, to see better; near by it looks again, and then from further
  // back.
  if ((p_RT_ - nominal_.plan.p_RP).norm() <= options_.blind_beyond_m) {
    if (options_.backs_up && misses_ % 2 == 0) Drive({-kStepBack_m, 0.0});
    return;
  }
  Decide();
}

void Approach::TakeOver(const TargetSeen& seen) {
  p_RT_ = seen.p_E;
  spread_m2_.setZero();
  turned_rad_ = 0.0;
  way_m_ = 0.0;
}

TargetSeen Approach::Peek(const StereoImages& images, const SensorFrame& sensed) {
  ++looks_;
  const GroundSeen ground = eye_.Look(images, sensed.imu);
  const TargetSeen seen =
      tracker_->Check(eye_.MapsAbout(ground, p_RT_), {p_RT_.x(), p_RT_.y(), 0.0});
  Report(seen, sensed.imu);
  Tell("peek", seen.why);
  return seen;
}

void Approach::Decide() {
  const double off_m = (p_RT_ - nominal_.plan.p_RP).norm();
  if (off_m <= options_.claim_share * nominal_.reach_m) {
    verdict_ = Verdict::kDocked;
    return Tell("there", "the point is on the target");
  }
  if (looks_ >= options_.most_looks) return GiveUp("cannot stabilize about the goal");
  // What the last arc to the target has missed by, the next one will miss by again: slopes and
  // stones under the wheels are still there.
  if (options_.backs_up && aimed_ && off_m < kMostAim_m) {
    aim_m_ += kAimGain * (p_RT_ - nominal_.plan.p_RP);
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
  const double step_m = path.size() > 1
                            ? kFirstPart_m
                            : std::max(options_.least_step_m, options_.image_share * left_m);
  aimed_ = path.size() == 1 && step_m >= left_m;
  Drive(step_m >= left_m ? arc : Part(arc, step_m / left_m));
}

// Whether the target's surroundings are worth another picture with another exposure.
bool Approach::TooDark(const GrayImage& left, const ImuSample& attitude) {
  if (!options_.exposes_for_target) return false;
  Eigen::Vector2d at = nominal_.target_px;
  if (begun_) {
    const Eigen::Matrix3d R_ER = RotY(attitude.pitch_rad) * RotX(attitude.roll_rad);
    const Eigen::Vector3d p_E(p_RT_.x(), p_RT_.y(), -nominal_.rolling_radius_m);
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

// Stones lie further ahead than predicted by what the rover slipped more.
void Approach::LearnSlip(const TargetSeen& seen) {
  const double way_m = drive_.driven_m();
  if (options_.slip <= 0.0 || way_m == 0.0 || way_m != way_m_) return;
  double& slip = SlipOf(way_m);
  slip = std::clamp(slip + seen.further_m / way_m, 0.0, kMostSlip);
}

Pose2 Approach::Moved() {
  if (!options_.turn_by_unit) return drive_.moved();
  const double way_m = drive_.driven_m();
  return Advance({}, Arc{(1.0 - SlipOf(way_m)) * way_m, WrapPi(yaw_rad_ - yaw_at_start_rad_)});
}

Commands Approach::Step(const SensorFrame& sensed) {
  Commands commands;
  commands.motors.resize(nominal_.motors.size());
  yaw_rad_ = sensed.imu.yaw_rad;
  if (driving_) {
    commands.motors = drive_.Step(sensed);
    const Pose2 moved = Moved();
    const Pose2 since = Inverse(moved_before_) * moved;
    p_RT_ = Inverse(since) * p_RT_;
    turned_rad_ += since.heading;
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-since.heading).toRotationMatrix();
    spread_m2_ = (turn * spread_m2_ * turn.transpose()).eval();
    moved_before_ = moved;
    driving_ = !drive_.done();
    if (!driving_) way_m_ += drive_.driven_m();
  }
  if (verdict_ == Verdict::kUnderWay && !driving_) {
    if (const auto images = FrontPair(sensed)) {
      asked_.reset();
      asks_ = 0;
      if (!TooDark(images->left, sensed.imu)) TakeLook(*images, sensed);
    }
    const bool waits = asked_ && sensed.tick - *asked_ < kAskAgain;
    if (verdict_ == Verdict::kUnderWay && !driving_ && !waits) {
      if (++asks_ > kMostAsks) {
        GiveUp("the cameras do not answer");
      } else {
        commands.take_images = {kFrontLeft, kFrontRight};
        commands.exposure_stops = stops_;
        asked_ = sensed.tick;
        Tell("look", "");
      }
    }
  }
  commands.verdict = verdict_;
  return commands;
}

}  // namespace dockyard::rocky7
