#include "sim/paths/planned_path.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr int kShownSplits = 36;

// The rest of the circle, driven the other way.
Arc OtherWayRound(const Arc& arc) {
  const double turn_rad = arc.turn_rad - std::copysign(2.0 * kPi, arc.turn_rad);
  return {arc.length_m * turn_rad / arc.turn_rad, turn_rad};
}

Candidate CandidateOf(const PathTask& task, std::vector<Arc> arcs, double cost_m) {
  Candidate candidate{std::move(arcs), cost_m};
  candidate.keeps = std::all_of(candidate.arcs.begin(), candidate.arcs.end(),
                                [&](const Arc& arc) { return Keeps(arc, task.limits); });
  candidate.missing_m = MissingOf(task.rover, task.demands, candidate.arcs);
  return candidate;
}

PlannedPath OneArc(const PathTask& task) {
  PlannedPath plan;
  const auto Offer = [&](const Arc& arc) {
    plan.candidates.push_back(CandidateOf(task, {arc}, std::abs(arc.length_m)));
  };
  if (task.p_AG == task.p_RP) {
    plan.best = CandidateOf(task, {}, 0.0);
    return plan;
  }
  Arc arc{-2.0 * task.p_RP.x(), 0.0};  // every circle and a line lead to the point's mirror image
  if (const auto found = OneArcTo(task.p_AG, task.p_RP)) arc = *found;
  Offer(arc);
  if (arc.turn_rad != 0.0) Offer(OtherWayRound(arc));
  for (const Candidate& candidate : plan.candidates) {
    if (plan.best || !candidate.IsUsable()) continue;
    plan.best = candidate;
  }
  return plan;
}

PlannedPath TwoArcs(const PathTask& task) {
  PlannedPath plan;
  const Pose2 X_AR = GoalPose(task);
  for (int i = 0; i < kShownSplits; ++i) {
    const auto pair = PairOfSplit(X_AR, kPi * i / kShownSplits);
    if (!pair) continue;
    plan.candidates.push_back(CandidateOf(task, {pair->begin(), pair->end()}, PairCost(*pair)));
  }
  const auto best = CheapestFreePair(task.rover, X_AR, task.limits, task.demands);
  if (best) plan.best = CandidateOf(task, {best->begin(), best->end()}, PairCost(*best));
  return plan;
}

PlannedPath ThreeArcs(const PathTask& task) {
  PlannedPath plan;
  const auto best = ShortestFreeTriple(task.rover, GoalPose(task), task.limits, task.demands);
  if (!best) return plan;
  const std::vector<Arc> arcs(best->begin(), best->end());
  plan.best = CandidateOf(task, arcs, Length(arcs));
  return plan;
}

}  // namespace

PlannedPath PlanPath(const PathTask& task) {
  if (!task.heading) return OneArc(task);
  return task.arcs == 2 ? TwoArcs(task) : ThreeArcs(task);
}

std::string Words(const PlannedPath& plan) {
  if (!plan.best) return "There are no such arcs.";
  std::string words;
  char text[96];
  for (const Arc& arc : plan.best->arcs) {
    std::snprintf(text, sizeof text, "%.3f m, %+.1f deg; ", arc.length_m, Degrees(arc.turn_rad));
    words += text;
  }
  std::snprintf(text, sizeof text, "cost %.3f m", plan.best->cost_m);
  return words + text;
}

Pose2 GoalPose(const PathTask& task) {
  DOCKYARD_CHECK(task.heading);
  const double heading = WrapPi(*task.heading);
  const Eigen::Vector2d at = task.p_AG - Pose2{0.0, 0.0, heading} * task.p_RP;
  return {at.x(), at.y(), heading};
}

std::vector<Pose2> PosesAlong(const std::vector<Arc>& path, double step_m, double step_rad) {
  std::vector<Pose2> poses{{}};
  for (const Arc& arc : path) {
    const double steps =
        std::max(std::abs(arc.length_m) / step_m, std::abs(arc.turn_rad) / step_rad);
    const int count = std::max(1, static_cast<int>(std::ceil(steps)));
    const Pose2 from = poses.back();
    for (int i = 1; i <= count; ++i) {
      poses.push_back(Advance(from, Part(arc, static_cast<double>(i) / count)));
    }
  }
  return poses;
}

}  // namespace dockyard
