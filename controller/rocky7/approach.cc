#include "controller/rocky7/approach.h"

#include <algorithm>
#include <cmath>

#include "controller/rocky7/exposure.h"
#include "controller/rocky7/ground_attitude.h"
#include "controller/rocky7/paths_to_point.h"

namespace dockyard::rocky7 {
namespace {

// Assumed, 1-10 s and 2-10.
constexpr ImagePatience kPatience{.wait = 3000, .most_asks = 5};
// Share of a miss that the next arc is aimed off by, and the most. Assumed, 0.5-1 and 2-4 cm.
constexpr double kAimGain = 0.8, kMostAim_m = 0.03;
// Of a long first arc so much is driven before the next image. Assumed, 0.15-0.3 m.
constexpr double kFirstPart_m = 0.2;
// What counts about a stone for the exposure, to either side. Assumed, 8-20 px.
constexpr int kStoneLevel_px = 12;
// Back from where the target is not seen. Assumed, 5-20 cm.
constexpr double kStepBack_m = 0.1;
// An arc that will miss by more than this, or this share of what is left of it, is left for a new
// one. Assumed, 1-2 cm and 0.05-0.2.
constexpr double kOffAtEnd_m = 0.015, kOffShare = 0.1;
// So much of an arc is left for short parts with images between them: the rover that stands sees
// best, and a part misses by less than the whole. Assumed, 10-20 cm.
constexpr double kLast_m = 0.15;
// Of the arm's reach to a side, what paths leave to it. Assumed, 0.5-0.9.
constexpr double kOfArm = 0.7;
// Looks under way in a row without the target, after which the rover stands to look. Assumed, 1-3.
constexpr int kMostMissesUnderWay = 2;
// A rover that drives further than this while its processor works on a pair takes pairs at rest
// alone: the arc would be over, or have missed, before the pair tells. Assumed, 1-4 cm.
constexpr double kWhileAtWork_m = 0.02;

}  // namespace

Approach::Approach(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
                   const ApproachOptions& options)
    : nominal_(nominal),
      options_(options),
      stereo_(nominal, options.front_end),
      memory_{.tracker = std::move(tracker), .compares = options.sees_motion},
      drive_(nominal),
      target_(options.odometry),
      work_(nominal.compute_s),
      escape_(nominal, {.most_stalls = options.most_stalls,
                        .near_m = options.blind_beyond_m,
                        .ground_as_body = options.ground_as_body}) {}

void Approach::Tell(const std::string& phase, const std::string& note) {
  belief_.phase = phase;
  if (!note.empty()) belief_.note = note;
  belief_.values = {{"target_x_m", target_.p_RT().x()},
                    {"target_y_m", target_.p_RT().y()},
                    {"looks", static_cast<double>(pairs_)}};
}

Event Approach::GiveUp(const std::string& why) {
  Tell(Name(Phase::kGivenUp), why);
  return Event::kFailed;
}

void Approach::Keep(const TargetSighting& sighting, const ImuSample& attitude) {
  ++pairs_;
  belief_.last_sighting = ReportOf(sighting, nominal_, attitude);
  ++belief_.sighting_count;
}

Eigen::Vector2d Approach::LeftToTarget() const {
  Eigen::Vector2d left_m = target_.p_RT() - nominal_.plan.p_RP;
  left_m.y() -= std::clamp(left_m.y(), -options_.arm_aside_m, options_.arm_aside_m);
  return left_m;
}

std::vector<Arc> Approach::PathToTarget() const {
  if (options_.backs_up) {
    const Eigen::Vector2d off_m = target_.p_RT() - nominal_.plan.p_RP;
    Eigen::Vector2d p_RG = target_.p_RT() + aim_m_ - target_.DriftOn(off_m.norm());
    // The last bit is driven straight where the arm does the rest.
    if (off_m.norm() < kLast_m) {
      const double aside_m = kOfArm * options_.arm_aside_m;
      p_RG.y() -= std::clamp(p_RG.y() - nominal_.plan.p_RP.y(), -aside_m, aside_m);
    }
    return GentleArcsToPoint(p_RG, nominal_.plan);
  }
  const ArcLimits limits = GentleLimits(nominal_.plan);
  const auto arc = OneArcTo(target_.p_RT(), nominal_.plan.p_RP);
  return arc ? std::vector<Arc>{NoSharper(*arc, limits)} : std::vector<Arc>{};
}

Event Approach::Drive(const Arc& part, double yaw_rad) {
  const Arc arc = options_.odometry.slip > 0.0
                      ? NoSharper(target_.AgainstSlip(part), GentleLimits(nominal_.plan))
                      : part;
  driven_.part = part;
  driven_.imaged_at_m = 0.0;
  driven_.misses = 0;
  drive_.Start(arc);
  target_.BeginArc(arc, yaw_rad);
  belief_.plan = {{.X_DR_start = {}, .length_m = arc.length_m, .turn_rad = arc.turn_rad}};
  ++belief_.plan_count;
  Tell(Name(Phase::kDrive),
       "drives " + std::to_string(static_cast<int>(std::lround(1e3 * arc.length_m))) + " mm");
  return Event::kPlanned;
}

TargetSighting Approach::Detect(const StereoImages& images, const SensorFrame& sensed) {
  ExposurePrior prior = target_.At(ExposureOfFront(sensed));
  prior.attitude = AgainstGround(prior.attitude, options_.ground_as_body);
  const GroundDetection detection =
      DetectTarget(stereo_, images, prior, nominal_.target_px, memory_);
  target_.Take(prior, detection);
  Keep(detection.sighting, prior.attitude);
  return detection.sighting;
}

TargetSighting Approach::Inspect(const StereoImages& images, const SensorFrame& sensed) {
  const Eigen::Vector2d& p_RT = target_.p_RT();
  const ImuSample attitude = AgainstGround(sensed.imu, options_.ground_as_body);
  const GroundMaps maps = stereo_.MapsAbout(stereo_.Look(images, attitude), p_RT);
  const TargetSighting sighting = memory_.tracker->Check(maps, {p_RT.x(), p_RT.y(), 0.0});
  Keep(sighting, attitude);
  Tell(Name(Phase::kInspect), sighting.why);
  return sighting;
}

Event Approach::DecideBy(const TargetSighting& sighting, double yaw_rad) {
  driven_.watched = false;
  misses_ = sighting.found || escape_.backs_off() ? 0 : misses_ + 1;
  if (sighting.found) return Decide(yaw_rad);
  if (misses_ >= options_.most_misses || !memory_.begun) {
    return GiveUp("lost the target: " + sighting.why);
  }
  // Far away it goes on by odometry, to detect it better; near by it takes another pair, and then
  // one from further back.
  const double off_m = (target_.p_RT() - nominal_.plan.p_RP).norm();
  if (off_m > options_.blind_beyond_m) return Decide(yaw_rad);
  const bool backs = options_.backs_up && misses_ % 2 == 0;
  return backs ? Drive({-kStepBack_m, 0.0}, yaw_rad) : Event::kNone;
}

// By how much the point would miss the target at the end of the whole arc.
double Approach::OffAtEnd() const {
  const double gone = drive_.share() * driven_.part.length_m / driven_.whole.length_m;
  const Pose2 X_RE = Advance({}, Part(driven_.whole, 1.0 - gone));
  const double distance_m = (1.0 - gone) * std::abs(driven_.whole.length_m);
  return (X_RE * nominal_.plan.p_RP + target_.DriftOn(distance_m) - target_.p_RT() - aim_m_).norm();
}

Event Approach::Decide(double yaw_rad) {
  const double off_m = LeftToTarget().norm();
  if (off_m <= options_.claim_share * nominal_.reach_m) {
    Tell("there", "the point is on the target");
    return Event::kReached;
  }
  if (pairs_ >= options_.most_looks) return GiveUp("cannot stabilize about the goal");
  // The next arc will miss by what the last one has missed by: slopes and stones under the wheels
  // are still there.
  if (options_.backs_up && driven_.aimed && off_m < kMostAim_m) {
    aim_m_ += kAimGain * (target_.p_RT() - nominal_.plan.p_RP);
    aim_m_ *= std::min(1.0, kMostAim_m / std::max(aim_m_.norm(), 1e-9));
  }
  driven_.aimed = false;
  if (escape_.Decide(off_m)) {
    aim_m_.setZero();
    return escape_.awaits_pair() ? Event::kNone : Drive(escape_.Next(), yaw_rad);
  }
  const std::vector<Arc> path = PathToTarget();
  if (path.empty()) return GiveUp("no arcs lead to the target");
  // A first arc that only makes room is short, and driven whole.
  const Arc& arc = path.front();
  const double left_m = std::abs(arc.length_m);
  const bool single = path.size() == 1;
  driven_.watched = single && MayWatch() && left_m > kLast_m + options_.look_each_m;
  const double part_m =
      single ? std::max(options_.least_step_m, options_.image_share * left_m) : kFirstPart_m;
  const double step_m = driven_.watched ? left_m - kLast_m : part_m;
  driven_.aimed = single && step_m >= left_m;
  driven_.whole = arc;
  return Drive(step_m >= left_m ? arc : Part(arc, step_m / left_m), yaw_rad);
}

// Whether the target's surroundings are worth another pair with another exposure.
bool Approach::TooDark(const GrayImage& left, const ImuSample& attitude) {
  if (!options_.exposes_for_target) return false;
  const auto at =
      memory_.begun
          ? FrontPixel(nominal_, AgainstGround(attitude, options_.ground_as_body), target_.p_RT())
          : std::optional(nominal_.target_px);
  const auto more = at ? MoreStops(left, *at, kStoneLevel_px, stops_) : std::nullopt;
  stops_ += more.value_or(0.0);
  return more.has_value();
}

// Whether image pairs are worth their time while it drives.
bool Approach::MayWatch() const {
  const double meanwhile_m = nominal_.plan.speed_m_s * nominal_.compute_s;
  return options_.look_each_m > 0.0 && meanwhile_m <= kWhileAtWork_m;
}

Event Approach::ObserveBehind(const SensorFrame& sensed, Commands& commands) {
  escape_.Observe(sensed, commands);
  if (escape_.awaits_pair()) return Event::kNone;
  return escape_.backs_off() ? Drive(escape_.Next(), sensed.imu.yaw_rad)
                             : Decide(sensed.imu.yaw_rad);
}

Event Approach::Observe(const SensorFrame& sensed, Commands& commands) {
  if (escape_.awaits_pair()) return ObserveBehind(sensed, commands);
  if (const auto images = FrontPair(sensed); images && !work_.busy()) {
    request_ = {};
    if (!TooDark(images->left, sensed.imu)) work_.Begin(sensed);
  }
  if (const auto taken = work_.Done(sensed.tick)) {
    const TargetSighting sighting = Detect(*FrontPair(*taken), *taken);
    Tell(Name(Phase::kObserve), sighting.why);
    const Event event = DecideBy(sighting, sensed.imu.yaw_rad);
    if (event != Event::kNone || escape_.awaits_pair()) return event;
  }
  if (work_.busy()) return Event::kNone;
  const RequestState state = StateOf(request_, kPatience, sensed.tick);
  if (state == RequestState::kUnanswered) return GiveUp("the cameras do not answer");
  if (state == RequestState::kAwaited) return Event::kNone;
  Ask({kFrontLeft, kFrontRight}, sensed.tick, &request_, &commands);
  commands.exposure_stops = stops_;
  Tell(Name(Phase::kObserve), "");
  return Event::kNone;
}

void Approach::Watch(const SensorFrame& sensed, Commands& commands) {
  if (!driven_.watched) return;
  const double driven_m = std::abs(drive_.driven_m());
  const double part_left_m = (1.0 - drive_.share()) * std::abs(driven_.part.length_m);
  if (FrontPair(sensed) && !work_.busy()) {
    request_ = {};
    driven_.imaged_at_m = driven_m;
    work_.Begin(sensed);
  }
  const auto taken = work_.Done(sensed.tick);
  if (!taken) {
    const bool due = !work_.busy() && driven_m - driven_.imaged_at_m >= options_.look_each_m &&
                     part_left_m >= options_.look_each_m &&
                     StateOf(request_, kPatience, sensed.tick) != RequestState::kAwaited;
    if (!due) return;
    Ask({kFrontLeft, kFrontRight}, sensed.tick, &request_, &commands);
    commands.exposure_stops = stops_;
    request_.asks = 0;  // a pair under way may be missing
    return;
  }
  const TargetSighting sighting = Detect(*FrontPair(*taken), *taken);
  driven_.misses = sighting.found ? 0 : driven_.misses + 1;
  if (sighting.found) misses_ = 0;
  const double left_m =
      std::abs(driven_.whole.length_m) - drive_.share() * std::abs(driven_.part.length_m);
  const bool misses = OffAtEnd() > std::max(kOffAtEnd_m, kOffShare * left_m);
  Tell(Name(Phase::kDrive), sighting.why);
  if (!misses && driven_.misses < kMostMissesUnderWay) return;
  drive_.Stop(sensed);
  belief_.note = misses ? "stops: the arc would miss the target" : "stops: " + sighting.why;
}

Event Approach::Move(Phase phase, const SensorFrame& sensed, std::vector<MotorCommand>& motors) {
  const bool drives = phase == Phase::kDrive;
  if (drives) motors = drive_.Step(sensed);
  target_.Step(drive_, drives, sensed);
  return drives && drive_.done() ? Event::kArrived : Event::kNone;
}

}  // namespace dockyard::rocky7
