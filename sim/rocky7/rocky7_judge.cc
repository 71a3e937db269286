#include "sim/rocky7/rocky7_judge.h"

#include <algorithm>
#include <cmath>

#include "sim/rocky7/target_view.h"

namespace dockyard::rocky7 {
namespace {

// After a claim the rover comes to rest. Assumed, 0.2-2 s.
constexpr Tick kSettle = 500;
// The trial: held so long, then over so far, backwards, out of the rover's own ruts.
constexpr Tick kHold = 10000;
constexpr double kDrive_m = 0.5;

// A sighting further off than this is of another thing: of a stone its width, of a boulder's point
// the instrument's.
double WidthOfTarget(const BuiltRun& built) {
  return built.world.boulder ? 2.0 * built.world.robot.rover.mast->instrument.radius_m
                             : built.keys.diameter_m;
}

}  // namespace

Rocky7Judge::Rocky7Judge(Rocky7Plant& plant) : plant_(plant), X_GR_last_(plant.truth().X_GR) {
  limits_.reach_m = plant.built().keys.reach_m;
  limits_.tilt_rad = plant.built().keys.tilt_rad;
  limits_.most_n = plant.built().keys.most_n;
  // A detection in space has the error of its height, too.
  if (plant.built().world.boulder) limits_.lost_m = WidthOfTarget(plant.built());
}

void Rocky7Judge::Observe() {
  if (plant_.truth().target_rise_m > limits_.lifted_m) lifted_ = true;
  const Truth& truth = plant_.truth();
  Add(truth.time_s, truth.face_n, truth.p_GF, truth.axis_G, contact_);
  const Pose2& now = plant_.truth().X_GR;
  measures_.driven_m += std::hypot(now.x - X_GR_last_.x, now.y - X_GR_last_.y);
  X_GR_last_ = now;
}

void Rocky7Judge::ObserveSighting(const SightingReport& report) {
  if (!report.accepted) return JudgeLock(report, false);
  // The report is in the body's frame. A stone's middle counts in plan, a boulder's point in space.
  const Truth& truth = plant_.truth();
  const Eigen::Vector3d p_G =
      Inverse(SiteInWorld(plant_.built().world.X_WG, plant_.built().world.slope)) *
      (truth.X_WR * report.X_RB.p);
  measures_.estimate_off_m =
      plant_.built().world.boulder ? (p_G - plant_.target_G()).norm() : p_G.head<2>().norm();
  measures_.worst_estimate_m = std::fmax(measures_.worst_estimate_m, measures_.estimate_off_m);
  const bool wrong = measures_.estimate_off_m > WidthOfTarget(plant_.built());
  measures_.wrong_sightings += wrong;
  JudgeLock(report, !wrong);
  sighted_ = true;
}

void Rocky7Judge::JudgeLock(const SightingReport& report, bool right) {
  if (!approaches_) return;
  if (right) {
    losses_.Found();
  } else if (losses_.has_target()) {
    losses_.Lost(
        CauseOf(TruthAt(plant_, report, sighted_ ? std::optional(believed_G_) : std::nullopt)));
  }
}

void Rocky7Judge::ObserveBelief(const Belief& belief) {
  approaches_ = ValueOf(belief, "grasps", 0.0) == 0.0 && ValueOf(belief, "placements", 0.0) == 0.0;
  const Eigen::Vector2d now_R(ValueOf(belief, "target_x_m", 0.0),
                              ValueOf(belief, "target_y_m", 0.0));
  if (now_R == believed_R_) return;
  believed_R_ = now_R;
  believed_G_ = plant_.truth().X_GR * now_R;
}

bool Rocky7Judge::fatal() const { return plant_.truth().on_stone; }

void Rocky7Judge::Play(const Commands& commands, Tick time, const char* phase,
                       const TrialWatch& watch) {
  for (Tick t = 0; t < time; t += kControlPeriod) {
    plant_.RefreshTruth();
    Observe();
    watch(phase);
    plant_.Advance(commands);
  }
  plant_.RefreshTruth();
}

double Rocky7Judge::TryToHold(const Commands& last, const TrialWatch& watch) {
  double least_m = plant_.truth().target_rise_m;
  const auto falls = [&] {
    least_m = std::min(least_m, plant_.truth().target_rise_m);
    return least_m < limits_.lifted_m;
  };
  if (falls()) return least_m;
  Play(last, kHold, "hold", watch);
  if (falls()) return least_m;
  const RoverModel& rover = plant_.built().world.robot.rover;
  Commands back = last;
  for (std::size_t i = 0; i < rover.plan.wheels.size(); ++i) {
    back.motors[i] = {.mode = MotorMode::kVelocity,
                      .target = -rover.plan.speed_m_s / RollingRadius(rover.tyre),
                      .speed_limit_rad_s = 0.0,
                      .accel_rad_s2 = rover.drive.max_accel_rad_s2,
                      .current_limit_a = rover.drive.max_current_a};
  }
  Play(back, static_cast<Tick>(kDrive_m / rover.plan.speed_m_s / kTickSeconds), "drive_away",
       watch);
  Play(last, kSettle, "rest", watch);
  falls();
  return least_m;
}

void Rocky7Judge::JudgeContact(EndOfRun& found) {
  found.places = true;
  found.touched = contact_.force_n > 0.0;
  measures_.touched = found.touched ? 1.0 : 0.0;
  if (!found.touched) {
    measures_.point_off_m = (plant_.truth().p_GF - plant_.target_G()).norm();
    return;
  }
  const BuiltRun& built = plant_.built();
  measures_.point_off_m = (contact_.p_GF - plant_.target_G()).norm();
  found.point_off_m = measures_.point_off_m;
  // What the can stands on; off the surface it stands askew by any measure.
  const double radius_m = built.world.robot.rover.mast->instrument.radius_m;
  const auto normal =
      NormalUnderDisc(*built.world.boulder, contact_.p_GF, -contact_.axis_G, radius_m);
  found.tilt_rad =
      normal ? std::acos(std::clamp(-normal->dot(contact_.axis_G), -1.0, 1.0)) : 0.5 * kPi;
  found.most_n = plant_.truth().most_face_n;
  measures_.tilt_deg = Degrees(found.tilt_rad);
  measures_.face_force_n = found.most_n;
}

Conclusion Rocky7Judge::Conclude(const Commands& last, const Belief& belief,
                                 const TrialWatch& watch) {
  if (last.verdict == Verdict::kDone) Play(last, kSettle, "rest", watch);
  plant_.RefreshTruth();
  Observe();
  const Truth end = plant_.truth();
  measures_.point_off_m = end.p_GP.head<2>().norm();
  measures_.looks = ValueOf(belief, "looks", 0.0);
  if (losses_.loss()) measures_.loss = static_cast<double>(*losses_.loss());
  measures_.grasps = ValueOf(belief, "grasps", 0.0);
  EndOfRun found{.claimed = last.verdict,
                 .grasps = plant_.built().nominal.task == Task::kGrasp,
                 .tried = static_cast<int>(measures_.grasps),
                 .lifted = false,
                 .rise_m = end.target_rise_m,
                 .point_off_m = measures_.point_off_m,
                 .sighted = sighted_,
                 .estimate_off_m = measures_.estimate_off_m,
                 .on_stone = end.on_stone};
  if (plant_.built().world.boulder) JudgeContact(found);
  if (last.verdict == Verdict::kDone && found.grasps) found.rise_m = TryToHold(last, watch);
  found.lifted = lifted_;
  measures_.rise_m = plant_.truth().target_rise_m;
  const Judged judged = JudgeEnd(found, limits_);
  return {Name(judged.outcome), judged.note, Values(measures_), LimitsOf(found, limits_)};
}

}  // namespace dockyard::rocky7
