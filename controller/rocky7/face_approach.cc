#include "controller/rocky7/face_approach.h"

#include <algorithm>
#include <cmath>

#include "controller/base/number_text.h"
#include "controller/motion/steering.h"
#include "controller/rocky7/exposure.h"
#include "controller/rocky7/paths_to_point.h"

namespace dockyard::rocky7 {
namespace {

// "Within one meter of goal" the rover stops and plans the two arcs (N, IV-B); it is there within
// this. Assumed, 10-40 cm.
constexpr double kBefore_m = 1.0, kBeforeWithin_m = 0.25;
// A normal that is less sure does not say where to go. Assumed, 5-15 deg.
constexpr double kNormalSure_rad = Radians(10.0);
// Before it is known: a face that leans back by so much, along the line of sight. Assumed, 0-45.
constexpr double kLeansBack_rad = Radians(20.0);
// How far the tool may be off the normal for the placement to begin: as good as the looks are, and
// less asked for with each look near by, as every correction stirs the soil. Assumed, 1-2, 0.2-0.5
// and 3.5-4.5 deg; 5 are the aim, of which the normal's own error takes 1.
constexpr double kGoodOff_rad = Radians(1.2), kEachLook_rad = Radians(0.25),
                 kMostOff_rad = Radians(3.5);
// A normal moves by its noise from look to look. The newer one counts by this share near by.
// Assumed, 0.3-1.
constexpr double kNewNormal = 0.6;
// What is left of the way to the goal's pose before single corrections. Assumed, 8-20 cm.
constexpr double kCorrectsWithin_m = 0.12;
// Of a boulder's foot over the ground, where it would be seen. Assumed, 5-15 cm.
constexpr double kFoot_m = 0.1;
// Cameras that do not answer are asked again after so long, so often. Assumed, 1-10 s and 2-10.
constexpr Tick kAskMastAgain = 3000;
constexpr int kMostMastAsks = 5;
// What counts about the target for the exposure, to either side: a top of 18 cm is 20 px high from
// 7 m, and the ground behind it may be in the sun. Assumed, 4-8 px.
constexpr int kFaceLevel_px = 6;
// Of the mast on its way to a look. Assumed, 0.5-1.
constexpr double kAimSpeed = 0.8;

double UpOf(const Eigen::Vector3d& normal) {
  return std::atan2(normal.z(), normal.head<2>().norm());
}

}  // namespace

FaceApproach::FaceApproach(const Nominal& nominal, std::unique_ptr<FaceTracker> tracker,
                           const FaceApproachOptions& options)
    : nominal_(nominal),
      options_(options),
      eye_(nominal),
      drive_(nominal),
      mast_(nominal),
      odometry_(options.odometry),
      tracker_(std::move(tracker)) {}

void FaceApproach::Tell(const std::string& phase, const std::string& note) {
  belief_.phase = phase;
  if (!note.empty()) belief_.note = note;
  const Eigen::Vector3d normal = normal_E_.value_or(Eigen::Vector3d::Zero());
  belief_.values = {{"target_x_m", p_ET_.x()},
                    {"target_y_m", p_ET_.y()},
                    {"target_z_m", p_ET_.z()},
                    {"looks", static_cast<double>(looks_)},
                    {"normal_up_deg", Degrees(normal_E_ ? UpOf(normal) : 0.0)},
                    {"normal_azimuth_deg", Degrees(std::atan2(normal.y(), normal.x()))},
                    {"normal_sigma_deg", Degrees(normal_sigma_rad_)},
                    {"tool_off_deg", Degrees(tool_off_rad_)}};
}

void FaceApproach::GiveUp(const std::string& why) {
  verdict_ = Verdict::kGivenUp;
  Tell("given_up", why);
}

void FaceApproach::LookAgain() {
  ready_ = false;
  aimed_ = false;
  phase_ = Phase::kAim;
}

FaceAt FaceApproach::FaceNow(const ImuSample& attitude) const {
  const Pose3 X_RE = Inverse(LevelFrame(nominal_, attitude));
  FaceAt face{.p_RT = X_RE * p_ET_};
  if (normal_E_) {
    face.normal_R = X_RE.R * *normal_E_;
  } else {
    const Eigen::Vector2d back = -face.p_RT.head<2>().normalized();
    face.normal_R << std::cos(kLeansBack_rad) * back, std::sin(kLeansBack_rad);
  }
  return face;
}

void FaceApproach::Report(const FaceView& view, const FaceSeen& seen) {
  SightingReport report;
  report.accepted = seen.found;
  report.reason = seen.found ? "" : seen.why;
  report.method = "face";
  const Eigen::Vector3d p_E = seen.found ? seen.p_E : p_ET_;
  const Pose3 X_RE = Inverse(view.X_ER);
  report.X_RB = {X_RE.R, X_RE * p_E};
  if (seen.found) {
    report.detected = {0, 0, 1, 1};
    for (const bool right : {false, true}) {
      const auto pixel = eye_.Pixel(view, p_E, right);
      if (pixel)
        report.marks.push_back({0, right ? kMastRight : kMastLeft, pixel->x(), pixel->y()});
    }
  }
  belief_.last_sighting = report;
  ++belief_.sighting_count;
}

// The first picture is the one that the user clicked in: nothing has moved since.
void FaceApproach::Aim(const SensorFrame& sensed) {
  if (begun_ && !aimed_) {
    const Eigen::Vector3d p_RT = Inverse(LevelFrame(nominal_, sensed.imu)) * p_ET_;
    mast_.Begin(AnglesToWatch(nominal_.mast, p_RT), kAimSpeed, sensed);
    aimed_ = true;
    Tell("aim", "");
  }
  if (begun_ && !mast_.Rests(sensed)) return;
  phase_ = Phase::kAsk;
  rests_since_ = sensed.tick;
  asked_.reset();
  asks_ = 0;
}

bool FaceApproach::TooDark(const GrayImage& left, const SensorFrame& sensed) {
  if (!options_.exposes_for_target) return false;
  Eigen::Vector2d at = nominal_.target_px;
  if (begun_) {
    FaceView view;
    view.X_EK = LevelFrame(nominal_, sensed.imu) * SecondLink(nominal_.mast, mast_.Angles(sensed));
    const auto pixel = eye_.Pixel(view, p_ET_, false);
    if (!pixel) return false;
    at = *pixel;
  }
  const auto more = MoreStops(left, at, kFaceLevel_px, stops_);
  if (!more) return false;
  stops_ += *more;
  return true;
}

void FaceApproach::Take(const FaceView& view, const FaceSeen& seen) {
  if (begun_ && seen.ranged && signed_way_m_ != 0.0) {
    odometry_.Learn(seen.p_E.x() - p_ET_.x(), RangeSigma(view.pair, seen.range_m), signed_way_m_);
  }
  if (seen.normal_E) {
    const bool fuse = normal_E_ && normal_sigma_rad_ < kNormalSure_rad;
    const double share =
        fuse ? std::max(kNewNormal, normal_sigma_rad_ / (normal_sigma_rad_ + seen.normal_sigma_rad))
             : 1.0;
    const Eigen::Vector3d before = fuse ? *normal_E_ : *seen.normal_E;
    normal_E_ = ((1.0 - share) * before + share * *seen.normal_E).normalized();
    normal_sigma_rad_ = seen.normal_sigma_rad;
  }
  // What the view does not hold any more, the foot under the face, is kept with the target.
  std::vector<Eigen::Vector2d> stands_out = StandsOut(view, seen.p_E.head<2>());
  for (const Eigen::Vector2d& p_E : stands_out_E_) {
    const Eigen::Vector2d moved = p_E + (seen.p_E - p_ET_).head<2>();
    if (!eye_.Pixel(view, {moved.x(), moved.y(), kFoot_m}, false)) stands_out.push_back(moved);
  }
  stands_out_E_ = NotOurselves(nominal_, stands_out);
  p_ET_ = seen.p_E;
  turned_rad_ = way_m_ = signed_way_m_ = 0.0;
  misses_ = 0;
}

void FaceApproach::TakeLook(const StereoImages& images, const SensorFrame& sensed) {
  ++looks_;
  const MastAngles angles = mast_.Angles(sensed);
  FaceSeen seen;
  FaceView view;
  if (begun_) {
    view = eye_.Look(images, angles, sensed.imu, p_ET_);
    seen = tracker_->Follow(eye_, view, {p_ET_, turned_rad_, way_m_});
  } else {
    view = eye_.Look(images, angles, sensed.imu, {});
    seen = tracker_->Begin(eye_, view, eye_.Rectified(nominal_.target_px));
  }
  Report(view, seen);
  if (seen.found) {
    Take(view, seen);
    begun_ = true;
    sees_ = "target at " + Fixed(seen.range_m, 2) + " m, score " + Fixed(seen.score, 2);
    Tell("look", sees_);
    return Decide(sensed);
  }
  ++misses_;
  Tell("look", seen.why);
  if (misses_ >= options_.most_misses || !begun_) return GiveUp("lost the target: " + seen.why);
  aimed_ = false;
  phase_ = Phase::kAim;
}

void FaceApproach::Decide(const SensorFrame& sensed) {
  face_ = FaceNow(sensed.imu);
  tool_off_rad_ = ToolOff(nominal_.mast, face_);
  if (looks_ >= options_.most_looks) return GiveUp("cannot stabilize about the goal");
  const bool sure = normal_E_ && normal_sigma_rad_ < kNormalSure_rad;
  FaceAt toward = face_;
  if (!sure) {
    const Eigen::Vector2d back = -face_.p_RT.head<2>().normalized();
    toward.normal_R << std::cos(kLeansBack_rad) * back, std::sin(kLeansBack_rad);
  }
  const double least_m = LeastStandOff(nominal_, toward, stands_out_E_);
  const auto goal = GoalFor(nominal_, toward, least_m, near_ ? 0.0 : kBefore_m);
  if (!goal) return GiveUp("the mast does not reach the target from anywhere");
  if (!near_ && (goal->p_RM_goal - nominal_.mast.p_RM.head<2>()).norm() > kBeforeWithin_m &&
      goal->p_RM_goal.x() > nominal_.mast.p_RM.x()) {
    return DecideFar(*goal, sensed);
  }
  near_ = true;
  if (!normal_E_) return GiveUp("the face's normal is not seen");
  const auto place = GoalFor(nominal_, face_, LeastStandOff(nominal_, face_, stands_out_E_));
  if (!place) return GiveUp("the mast does not reach the target from anywhere");
  DecideNear(*place, sensed);
}

// One arc brings the mast's axis to a place before the face.
void FaceApproach::DecideFar(const PlaceGoal& goal, const SensorFrame& sensed) {
  const auto arc = OneArcTo(goal.p_RM_goal, nominal_.mast.p_RM.head<2>());
  if (!arc) return GiveUp("no arc leads to the target");
  const Arc way = NoSharper(*arc, GentleLimits(nominal_.plan));
  const double left_m = std::abs(way.length_m);
  const double step_m =
      std::clamp(options_.image_share * left_m, options_.least_step_m, options_.most_step_m);
  Drive({step_m >= left_m ? way : Part(way, step_m / left_m)}, sensed);
}

void FaceApproach::DecideNear(const PlaceGoal& goal, const SensorFrame& sensed) {
  const double left_m = (goal.p_RM_goal - nominal_.mast.p_RM.head<2>()).norm();
  near_looks_ += left_m < kCorrectsWithin_m;
  const double enough_rad =
      std::min(kMostOff_rad, kGoodOff_rad + kEachLook_rad * std::max(0, near_looks_ - 1));
  // Where the mast cannot follow the normal, as much is left out as it cannot.
  const double unreachable_rad = std::abs(goal.stance.off_rad);
  if (driven_all_ || tool_off_rad_ < enough_rad + unreachable_rad) {
    if (tool_off_rad_ >= kPi) return GiveUp("the mast does not reach the target from here");
    ready_ = true;
    return Tell("there", "the tool is " + Fixed(Degrees(tool_off_rad_), 1) + " deg off the normal");
  }
  const Obstacles obstacles = DiscsOf(stands_out_E_);
  std::vector<Arc> path;
  if (options_.corrects && left_m < kCorrectsWithin_m) {
    path = ArcsToCorrect(nominal_, face_, goal, obstacles);
  }
  if (path.empty()) path = ArcsToGoal(nominal_, goal, obstacles);
  if (path.empty()) return GiveUp("no arcs lead before the face");
  if (!options_.corrects) {
    driven_all_ = true;
    return Drive(path, sensed);
  }
  // Parts of arcs forwards; those back are driven whole, as they only make room.
  const double whole_m = Length(path);
  const double step_m =
      std::clamp(options_.image_share * whole_m, options_.least_step_m, options_.most_step_m);
  std::vector<Arc> part =
      Truncate(path, path.front().length_m < 0.0 ? std::abs(path.front().length_m)
                                                 : std::min(whole_m, step_m));
  Drive(whole_m - step_m < options_.least_step_m ? path : part, sensed);
}

void FaceApproach::Drive(std::vector<Arc> arcs, const SensorFrame& sensed) {
  arcs_ = std::move(arcs);
  std::erase_if(arcs_, [](const Arc& arc) { return std::abs(arc.length_m) < 1e-4; });
  belief_.plan.clear();
  Pose2 at;
  for (const Arc& arc : arcs_) {
    belief_.plan.push_back({.X_DR_start = at, .length_m = arc.length_m, .turn_rad = arc.turn_rad});
    at = Advance(at, arc);
  }
  ++belief_.plan_count;
  phase_ = Phase::kDrive;
  BeginArc(sensed);
}

void FaceApproach::BeginArc(const SensorFrame& sensed) {
  if (arcs_.empty()) {
    aimed_ = false;
    phase_ = Phase::kAim;
    return;
  }
  const Arc arc = arcs_.front();
  arcs_.erase(arcs_.begin());
  drive_.Start(arc);
  odometry_.Begin(sensed.imu.yaw_rad);
  Tell("drive", sees_ + ", drives " + Fixed(1e3 * arc.length_m, 0) + " mm");
}

void FaceApproach::StepDrive(const SensorFrame& sensed, Commands& commands) {
  const double before_m = drive_.driven_m();
  commands.motors = drive_.Step(sensed);
  const Pose2 since = odometry_.Step(drive_.driven_m(), drive_.moved(), sensed.imu.yaw_rad);
  const Pose2 back = Inverse(since);
  p_ET_.head<2>() = back * Eigen::Vector2d(p_ET_.head<2>());
  if (normal_E_) normal_E_ = RotZ(-since.heading) * *normal_E_;
  for (Eigen::Vector2d& p_E : stands_out_E_) p_E = back * p_E;
  turned_rad_ += since.heading;
  way_m_ += std::abs(drive_.driven_m() - before_m);
  signed_way_m_ += drive_.driven_m() - before_m;
  if (drive_.done()) BeginArc(sensed);
}

void FaceApproach::StepAsk(const SensorFrame& sensed, Commands& commands) {
  if (const auto images = MastPair(sensed, rests_since_); images && asked_) {
    asked_.reset();
    asks_ = 0;
    if (!TooDark(images->left, sensed)) TakeLook(*images, sensed);
  }
  if (phase_ != Phase::kAsk || ready_ || verdict_ != Verdict::kUnderWay) return;
  if (asked_ && sensed.tick - *asked_ < kAskMastAgain) return;
  if (++asks_ > kMostMastAsks) return GiveUp("the mast's cameras do not answer");
  commands.take_images = {kMastLeft, kMastRight};
  commands.exposure_stops = stops_;
  asked_ = sensed.tick;
  Tell("look", "");
}

Commands FaceApproach::Step(const SensorFrame& sensed) {
  Commands commands;
  commands.motors.resize(nominal_.motors.size());
  if (verdict_ == Verdict::kUnderWay && !ready_) {
    if (phase_ == Phase::kDrive) StepDrive(sensed, commands);
    if (phase_ == Phase::kAim) Aim(sensed);
    if (phase_ == Phase::kAsk) StepAsk(sensed, commands);
  }
  std::copy(mast_.commands().begin(), mast_.commands().end(),
            commands.motors.begin() + static_cast<long>(FirstMastMotor(nominal_)));
  commands.verdict = verdict_;
  return commands;
}

}  // namespace dockyard::rocky7
