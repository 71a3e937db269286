#include "controller/axel/planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "controller/axel/rock_check.h"
#include "controller/motion/two_arcs.h"

namespace dockyard::axel {
namespace {

// From a little to either side of here, too.
bool CanGoOn(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& course,
             const Drift& drift) {
  const Pose2 X_DR{course.x, course.y, WrapPi(course.heading - std::atan(drift.here))};
  for (const double aside_m : {-options.plan.leg_error_m, options.plan.leg_error_m}) {
    const Pose2 at = X_DR * Pose2{0.0, aside_m, 0.0};
    if (PlanOn(geometry, options, at, drift).arcs.empty()) return false;
  }
  return true;
}

/// The pair of least cost with that of the rocks that it crosses.
std::optional<ArcPair> ClearestPair(const RockCheck& rocks, const Pose2& out, const Pose2& to_goal,
                                    const ArcLimits& limits, int splits, double* least) {
  std::optional<ArcPair> best;
  ForEachPair(to_goal, limits, splits, [&](const ArcPair& pair) {
    const double cost = PairCost(pair);
    if (cost >= *least) return;
    const double with_rocks = cost + rocks.Cost(out, {pair.begin(), pair.end()});
    if (with_rocks >= *least) return;
    *least = with_rocks;
    best = pair;
  });
  return best;
}

/// As PlanRecovery among rocks: behind what it has so far, a pair to the recovery goal or to the
/// next one farther out that no rock bars. Nothing if no pair fits.
std::optional<ArcPair> RecoverAmongRocks(const PlanGeometry& geometry, const AxelOptions& options,
                                         const RockCheck& rocks, const Pose2& out, double x_m,
                                         const ArcLimits& limits, const Drift& drift,
                                         double* least) {
  std::optional<ArcPair> best;
  for (; x_m <= options.plan.max_range_m && *least >= kRockCost_m;
       x_m += options.plan.recover_step_m) {
    const Pose2 on_line = MouthLineAt(geometry, options.mate, x_m, drift.at_dock);
    const Pose2 goal = CourseOf({on_line.x, on_line.y, kPi}, drift.at_dock, false);
    const auto pair =
        ClearestPair(rocks, out, Inverse(out) * goal, limits, options.plan.splits, least);
    if (pair) best = pair;
  }
  return best;
}

}  // namespace

std::vector<Arc> WayBack(const std::vector<Arc>& arcs) {
  const auto on =
      std::find_if(arcs.begin(), arcs.end(), [](const Arc& arc) { return arc.length_m >= 0.0; });
  return {arcs.begin(), on};
}

AxisPlan PlanRecovery(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                      const PlanHistory& history, const Drift& drift) {
  const PlanOptions& plan = options.plan;
  AxisPlan back{CourseOf(X_DR, drift.here, false), {}};
  const double gap = TipOf(geometry, X_DR).gap_m;
  if (gap < plan.min_tip_gap_m) back.arcs.push_back({gap - plan.min_tip_gap_m, 0.0});
  const Pose2 out = Advance(back.start, back.arcs);
  const double nearest_m = std::max(geometry.arm_m + plan.recover_gap_m, out.x + plan.back_step_m);
  const double x_m =
      std::min(nearest_m + history.recoveries * plan.recover_step_m, plan.max_range_m);
  // There it faces the station squarely, for the way to the mouth.
  const Pose2 on_line = MouthLineAt(geometry, options.mate, x_m, drift.at_dock);
  const Pose2 goal = CourseOf({on_line.x, on_line.y, kPi}, drift.at_dock, false);
  const ArcLimits limits{1.0 / plan.max_recover_curvature, Travel::kBackward};
  const Pose2 to_goal = Inverse(out) * goal;
  const RockCheck rocks(geometry, X_DR);
  if (!rocks.empty()) {
    double least = std::numeric_limits<double>::infinity();
    const auto pair = RecoverAmongRocks(geometry, options, rocks, out, x_m, limits, drift, &least);
    back.over_rock = least >= kRockCost_m;
    if (pair) {
      back.arcs.insert(back.arcs.end(), pair->begin(), pair->end());
      return back;
    }
  }
  if (const auto pair = CheapestPair(to_goal, limits)) {
    back.arcs.insert(back.arcs.end(), pair->begin(), pair->end());
  } else {
    back.arcs.push_back({-std::max(plan.back_step_m, -to_goal.x), 0.0});
  }
  return back;
}

std::vector<Arc> FirstLeg(const PlanGeometry& geometry, const AxelOptions& options,
                          const AxisPlan& plan, const Drift& drift) {
  if (plan.arcs.front().length_m < 0.0) return WayBack(plan.arcs);
  constexpr double kStep = 0.05;
  const PlanOptions& limits = options.plan;
  const double whole = Length(plan.arcs);
  std::optional<double> last_good_m;
  double turned = 0.0;
  for (double gone = kStep; whole - gone >= 0.5 * limits.leg_min_m; gone += kStep) {
    const std::vector<Arc> leg = Truncate(plan.arcs, gone);
    turned = Turning(leg);
    const bool enough =
        gone >= limits.leg_max_m || (gone >= limits.leg_min_m && turned >= limits.leg_turn_rad);
    if (gone < limits.leg_min_m) continue;
    const Pose2 end = Advance(plan.start, leg);
    if (!SeesBoard(geometry, options.look, end) || BodyNearRock(geometry, end)) continue;
    if (CanGoOn(geometry, options, end, drift)) last_good_m = gone;
    const bool too_long = gone >= limits.leg_stretch * limits.leg_max_m;
    if (enough && (last_good_m || too_long)) return Truncate(plan.arcs, last_good_m.value_or(gone));
  }
  return plan.arcs;
}

Decision Decide(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                const PlanHistory& history, const Drift& drift) {
  const auto [gap, offset] = TipOf(geometry, X_DR);
  const bool at_goal = gap <= options.plan.align_gap_m + options.plan.align_tolerance_m &&
                       std::abs(offset) <= options.plan.near_axis_m;
  if (at_goal) {
    if (CanMate(geometry, options, X_DR, drift.here)) {
      const Pose2 start = MouthLineAt(geometry, options.mate, X_DR.x, drift.here);
      const std::vector<Arc> on{{std::max(0.0, gap - options.mate.look_gap_m), 0.0}};
      return {Event::kGoMate, {start, on}, on};
    }
    AxisPlan back = PlanRecovery(geometry, options, X_DR, history, drift);
    const std::vector<Arc> leg = back.arcs;
    return {Event::kGoRecover, std::move(back), leg};
  }
  const AxisPlan plan = PlanToAxis(geometry, options, X_DR, history, drift);
  const std::vector<Arc> leg = FirstLeg(geometry, options, plan, drift);
  if (plan.arcs.front().length_m < 0.0) return {Event::kGoBackOff, plan, leg};
  const bool near = std::hypot(X_DR.x, X_DR.y) <= options.plan.align_range_m;
  return {near ? Event::kGoAlign : Event::kGoApproach, plan, leg};
}

std::vector<PlannedArc> Planned(const AxisPlan& plan) {
  if (plan.arcs.empty() || plan.arcs.front().length_m >= 0.0) return Planned(plan.arcs, plan.start);
  const std::vector<Arc> back = WayBack(plan.arcs);
  std::vector<PlannedArc> planned = Planned(back, plan.start);
  const Pose2 cusp = Advance(plan.start, back) * Pose2{0.0, 0.0, plan.cusp_turn_rad};
  const auto first_on = plan.arcs.begin() + static_cast<std::ptrdiff_t>(back.size());
  const auto on = Planned({first_on, plan.arcs.end()}, cusp);
  planned.insert(planned.end(), on.begin(), on.end());
  return planned;
}

std::vector<PlannedArc> Planned(const std::vector<Arc>& arcs, const Pose2& X_DR_start) {
  std::vector<PlannedArc> planned;
  Pose2 at = X_DR_start;
  for (const Arc& arc : arcs) {
    planned.push_back({at, arc.length_m, arc.turn_rad});
    at = Advance(at, arc);
  }
  return planned;
}

}  // namespace dockyard::axel
