#include "sim/rocky7/rocky7_judge.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// After a claim the rover comes to rest. Assumed, 0.2-2 s.
constexpr Tick kSettle = 500;

}  // namespace

Rocky7Judge::Rocky7Judge(Rocky7Plant& plant) : plant_(plant), X_GR_last_(plant.truth().X_GR) {
  limits_.reach_m = plant.built().keys.reach_m;
}

void Rocky7Judge::Observe() {
  const Pose2& now = plant_.truth().X_GR;
  measures_.driven_m += std::hypot(now.x - X_GR_last_.x, now.y - X_GR_last_.y);
  X_GR_last_ = now;
}

void Rocky7Judge::ObserveSighting(const SightingReport& report) {
  if (!report.accepted) return;
  // The report is in the body's frame, the target at G's origin.
  const Truth& truth = plant_.truth();
  const Eigen::Vector3d p_G =
      Inverse(SiteInWorld(plant_.built().world.X_WG, plant_.built().world.slope)) *
      (truth.X_WR * report.X_RB.p);
  measures_.estimate_off_m = p_G.head<2>().norm();
  measures_.worst_estimate_m = std::max(measures_.worst_estimate_m, measures_.estimate_off_m);
}

bool Rocky7Judge::fatal() const { return plant_.truth().on_stone; }

Conclusion Rocky7Judge::Conclude(const Commands& last, const Belief& belief,
                                 const TrialWatch& watch) {
  if (last.verdict == Verdict::kDocked) {
    for (Tick t = 0; t < kSettle; t += kControlPeriod) {
      watch("rest");
      plant_.Advance(last);
    }
  }
  plant_.RefreshTruth();
  Observe();
  const Truth& end = plant_.truth();
  measures_.point_off_m = end.p_GP.head<2>().norm();
  measures_.looks = ValueOf(belief, "looks", 0.0);
  const Judged judged = JudgeEnd(
      {last.verdict, measures_.point_off_m, measures_.estimate_off_m, end.on_stone}, limits_);
  return {Name(judged.outcome), judged.note, Values(measures_)};
}

}  // namespace dockyard::rocky7
