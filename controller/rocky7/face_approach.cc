#include "controller/rocky7/face_approach.h"

#include <cmath>
#include <iterator>
#include <utility>

#include "controller/base/number_text.h"
#include "controller/rocky7/exposure.h"
#include "controller/rocky7/paths_to_point.h"
#include "controller/rocky7/touch_place.h"

namespace dockyard::rocky7 {
namespace {

// Assumed, 1-10 s and 2-10.
constexpr ImagePatience kMastPatience{.wait = 3000, .most_asks = 5};
// What counts about the target for the exposure, to either side: a top of 18 cm is 20 px high from
// 7 m, and the ground behind it may be in the sun. Assumed, 4-8 px.
constexpr int kFaceLevel_px = 6;
// Of the mast on its way to an image pair. Assumed, 0.5-1.
constexpr double kAimSpeed = 0.8;
// A body that tips over stones moves the mast by this, which is no drift. Assumed, 5-15 mm.
constexpr double kTips_m = 0.01;
// A step without the target, and the least distance to it. Assumed, 0.2-0.4 and 1.2-2 m.
constexpr double kBlindStep_m = 0.3, kBlindBeyond_m = 1.5;

// An image pair from the same place shows the same target, and near by perhaps the mast's own
// shadow on it. So after each miss there the mast leans by another of these. Assumed, 10-45 deg.
constexpr double kLeans_rad[] = {0.0, Radians(-20.0), Radians(20.0), Radians(-40.0)};

double LeanAfter(int misses) {
  return kLeans_rad[static_cast<std::size_t>(misses) % std::size(kLeans_rad)];
}

}  // namespace

FaceApproach::FaceApproach(const Nominal& nominal, std::unique_ptr<FaceTracker> tracker,
                           const FaceApproachOptions& options)
    : nominal_(nominal),
      options_(options),
      stereo_(nominal, options.front_end),
      tracker_(std::move(tracker)),
      drive_(nominal),
      mast_(nominal),
      odometry_(options.odometry),
      work_(nominal.compute_s) {}

void FaceApproach::Tell(const std::string& phase, const std::string& note) {
  belief_.phase = phase;
  if (!note.empty()) belief_.note = note;
  belief_.values = ValuesOf(target_, pairs_, tool_off_rad_);
}

Eigen::Vector2d FaceApproach::GroundRise(const ImuSample& attitude) const {
  return options_.learns_slope ? ground_.Rise(attitude) : Eigen::Vector2d(0.0, 0.0);
}

// The face as a body parallel to the ground would have it: so the rover will be at the goal.
FaceAt FaceApproach::FaceOverGround(const ImuSample& attitude) const {
  return FaceNow(nominal_, options_.learns_slope ? ground_.Parallel(attitude) : attitude, target_);
}

// Where the instrument would go from here.
void FaceApproach::TakeFace(const ImuSample& attitude) {
  face_ = FaceNow(nominal_, attitude, target_);
  tool_off_rad_ = ToolOff(nominal_.mast, face_);
  if (!options_.corrects) return;
  const TouchPlace touch = PlaceToTouch(nominal_.mast, face_);
  face_ = touch.face;
  tool_off_rad_ = touch.off_rad;
}

Event FaceApproach::GiveUp(const std::string& why) {
  Tell(Name(Phase::kGivenUp), why);
  return Event::kFailed;
}

// The first pair is the one that the user clicked in: nothing has moved since.
Event FaceApproach::Aim(const SensorFrame& sensed) {
  if (target_.begun && !aims_) {
    const Eigen::Vector3d p_RT = Inverse(LevelFrame(nominal_, sensed.imu)) * target_.p_ET;
    const double lean_rad = progress_.near ? LeanAfter(misses_) : 0.0;
    mast_.Begin(AnglesToWatch(nominal_.mast, p_RT, lean_rad), kAimSpeed, sensed);
    aims_ = true;
    Tell(Name(Phase::kAim), "");
  }
  if (target_.begun && !mast_.Rests(sensed)) return Event::kNone;
  aims_ = false;
  rests_since_ = sensed.tick;
  request_ = {};
  return Event::kArrived;
}

bool FaceApproach::TooDark(const GrayImage& left, const SensorFrame& sensed) {
  if (!options_.exposes_for_target) return false;
  FaceView view;
  view.X_EK = LevelFrame(nominal_, sensed.imu) * SecondLink(nominal_.mast, mast_.Angles(sensed));
  const auto at =
      target_.begun ? stereo_.Pixel(view, target_.p_ET, false) : std::optional(nominal_.target_px);
  const auto more = at ? MoreStops(left, *at, kFaceLevel_px, stops_) : std::nullopt;
  stops_ += more.value_or(0.0);
  return more.has_value();
}

void FaceApproach::Take(const FaceDetection& detection) {
  const FaceSighting& sighting = detection.sighting;
  if (sighting.ranged && target_.signed_m != 0.0) {
    odometry_.Learn(sighting.p_E.x() - target_.p_ET.x(),
                    RangeSigma(detection.view.pair, sighting.range_m), target_.signed_m);
  }
  odometry_.LearnDrift(FurtherLeft(target_, sighting.p_E),
                       std::hypot(kPoints_rad * sighting.range_m, kTips_m), target_.rolled_m);
  rocky7::Take(nominal_, stereo_, detection.view, sighting, target_);
  misses_ = 0;
  detected_ = "target at " + Fixed(sighting.range_m, 2) + " m, score " + Fixed(sighting.score, 2);
}

// A further image pair from the same place shows the same: the rover goes on by odometry where the
// target is still far.
Event FaceApproach::GoOnBlind(const SensorFrame& sensed) {
  const bool far = !progress_.near && target_.p_ET.head<2>().norm() > kBlindBeyond_m;
  if (misses_ < options_.blind_after || !far) return Event::kMissed;
  const FaceAt face = FaceOverGround(sensed.imu);
  FaceProgress progress = progress_;
  const FaceDecision next = DecideNext(nominal_, options_, target_, face, kPi, progress);
  if (next.arcs.empty() || progress.near) return Event::kMissed;
  return Begin(Truncate(next.arcs, kBlindStep_m), sensed.imu.yaw_rad);
}

Event FaceApproach::DecideBy(const FaceDetection& detection, const SensorFrame& sensed) {
  ++pairs_;
  belief_.last_sighting = ReportOf(detection, stereo_, target_);
  ++belief_.sighting_count;
  const FaceSighting& sighting = detection.sighting;
  if (!sighting.found) {
    ++misses_;
    Tell(Name(Phase::kObserve), sighting.why);
    const bool lost = misses_ >= options_.most_misses || !target_.begun;
    return lost ? GiveUp("lost the target: " + sighting.why) : GoOnBlind(sensed);
  }
  Take(detection);
  Tell(Name(Phase::kObserve), detected_);
  TakeFace(sensed.imu);
  if (pairs_ >= options_.most_looks) return GiveUp("cannot stabilize about the goal");
  const FaceDecision next =
      DecideNext(nominal_, options_, target_, FaceOverGround(sensed.imu), tool_off_rad_, progress_);
  if (!next.why_not.empty()) return GiveUp(next.why_not);
  if (!next.arcs.empty()) return Begin(next.arcs, sensed.imu.yaw_rad);
  return Reached();
}

Event FaceApproach::Begin(std::vector<Arc> arcs, double yaw_rad) {
  arcs_ = std::move(arcs);
  std::erase_if(arcs_, [](const Arc& arc) { return std::abs(arc.length_m) < 1e-4; });
  belief_.plan.clear();
  Pose2 at;
  for (const Arc& arc : arcs_) {
    belief_.plan.push_back({.X_DR_start = at, .length_m = arc.length_m, .turn_rad = arc.turn_rad});
    at = Advance(at, arc);
  }
  ++belief_.plan_count;
  return BeginArc(yaw_rad);
}

// kMissed: there is none.
Event FaceApproach::BeginArc(double yaw_rad) {
  if (arcs_.empty()) return Event::kMissed;
  // A rover that slips comes as far as was planned only where its wheels turn further.
  const Arc arc = options_.odometry.slip > 0.0
                      ? NoSharper(odometry_.AgainstSlip(arcs_.front()), GentleLimits(nominal_.plan))
                      : arcs_.front();
  arcs_.erase(arcs_.begin());
  drive_.Start(arc);
  odometry_.Begin(yaw_rad);
  Tell(Name(Phase::kDrive), detected_ + ", drives " + Fixed(1e3 * arc.length_m, 0) + " mm");
  return Event::kPlanned;
}

Event FaceApproach::Drive(const SensorFrame& sensed, std::vector<MotorCommand>& motors) {
  const double before_m = drive_.driven_m();
  motors = drive_.Step(sensed);
  const Pose2 since = odometry_.Step(drive_.driven_m(), drive_.moved(), sensed.imu);
  MoveOn(since, drive_.driven_m() - before_m, GroundRise(sensed.imu), target_);
  target_.rolled_m += std::abs(drive_.driven_m() - before_m) * std::sin(sensed.imu.roll_rad);
  target_.drift_m = odometry_.DriftSigma(target_.rolled_m);
  ground_.Add(sensed.imu, drive_.driven_m() - before_m);
  if (!drive_.done() || BeginArc(sensed.imu.yaw_rad) == Event::kPlanned) return Event::kNone;
  if (!progress_.driven_all) return Event::kArrived;
  TakeFace(sensed.imu);
  return Reached();
}

Event FaceApproach::Reached() {
  if (tool_off_rad_ >= kPi) return GiveUp("the mast does not reach the target from here");
  Tell("there", "the tool is " + Fixed(Degrees(tool_off_rad_), 1) + " deg off the normal");
  return Event::kReached;
}

Event FaceApproach::Observe(const SensorFrame& sensed, Commands& commands) {
  if (const auto images = MastPair(sensed, rests_since_); images && request_.asked) {
    request_ = {};
    if (!TooDark(images->left, sensed)) work_.Begin(sensed);
  }
  if (const auto taken = work_.Done(sensed.tick)) {
    ground_.Add(taken->imu, 0.0);
    FaceDetection detection =
        DetectFace(stereo_, *MastPair(*taken, rests_since_), mast_.Angles(*taken), taken->imu,
                   target_, nominal_.target_px, *tracker_);
    detection.view.ground_rise = GroundRise(taken->imu);
    return DecideBy(detection, sensed);
  }
  if (work_.busy()) return Event::kNone;
  const RequestState state = StateOf(request_, kMastPatience, sensed.tick);
  if (state == RequestState::kUnanswered) return GiveUp("the mast's cameras do not answer");
  if (state == RequestState::kAwaited) return Event::kNone;
  Ask({kMastLeft, kMastRight}, sensed.tick, &request_, &commands);
  commands.exposure_stops = stops_;
  Tell(Name(Phase::kObserve), "");
  return Event::kNone;
}

}  // namespace dockyard::rocky7
