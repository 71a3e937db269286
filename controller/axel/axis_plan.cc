#include "controller/axel/axis_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/axel/mouth_way.h"
#include "controller/axel/rock_check.h"
#include "controller/motion/three_arcs.h"

namespace dockyard::axel {
namespace {

constexpr int kSamplesPerArc = 8;
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kStraightOn = Radians(3.0);  // less than the steering's own error
constexpr double kRoundLimit_m = 2.0;         // first arc round a rock; assumed, 1-3 m
constexpr double kLevelDrift = 0.03;          // 2 deg of slope; less comes with uneven ground
// Two places this near each other are the same to a rover that knows its own to 2-10 cm.
constexpr double kSamePlace_m = 0.25, kSameHeading = Radians(8.0);

struct Candidate {
  std::vector<Arc> arcs;
  double cost = kNever;
};

class AxisSearch {
 public:
  AxisSearch(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
             const PlanHistory& history, const Drift& drift)
      : geometry_(geometry),
        options_(options),
        plan_(options.plan),
        drift_(drift),
        abeam_rad_(std::max(plan_.least_abeam_rad,
                            plan_.abeam_rad - history.back_offs * plan_.abeam_step_rad)),
        rocks_(geometry, X_DR) {}

  bool HasRocks() const { return !rocks_.empty(); }
  bool Clear(const Candidate& plan) const { return !HasRocks() || plan.cost < kRockCost_m; }

  double CuspTurn() const { return 2.0 * std::atan(drift_.here); }

  /// The cheapest pair forwards to a goal.
  Candidate Forward(const Pose2& start, double max_curvature, const Pose2& goal) const {
    Candidate best;
    ForEachPair(Inverse(start) * goal, {1.0 / max_curvature, Travel::kForward}, plan_.splits,
                [&](const ArcPair& pair) {
                  Offer(start, {pair.begin(), pair.end()}, PairCost(pair), &best);
                });
    return best;
  }

  /// Three arcs forwards, as a way round a rock needs; a cheaper one than the best so far replaces
  /// it.
  void Round(const Pose2& start, double max_curvature, const Pose2& goal, Candidate* best) const {
    const ArcLimits limits{1.0 / max_curvature, Travel::kForward};
    const auto firsts = FirstArcs(limits, plan_.back_step_m, kRoundLimit_m, plan_.back_turns);
    double first_cost = 0.0;
    const auto wants = [&](const Arc& first) {
      first_cost = first.length_m;
      return first.length_m > 0.0 && first_cost + ArcCost(start, first) < best->cost;
    };
    ForEachTriple(
        Inverse(start) * goal, firsts, limits, plan_.back_splits, wants,
        [&](const ArcTriple& arcs) {
          Offer(start, {arcs.begin(), arcs.end()}, first_cost + PairCost({arcs[1], arcs[2]}), best);
        });
  }

  /// Before the mouth, on the line to it, or with the axle aside and the tip on it.
  Pose2 Goal(double gap_m, double aside_m = 0.0) const {
    const double x_m = geometry_.arm_m + gap_m;
    Pose2 goal = MouthLineAt(geometry_, options_.mate, x_m, drift_.at_dock);
    goal.y += aside_m;
    goal.heading = WrapPi(goal.heading + std::asin(aside_m / geometry_.arm_m));
    return goal;
  }

  /// Back by least_steps or more, then on; a cheaper one than the best so far replaces it.
  void BackOff(const Pose2& start, const PlanHistory& history, int least_steps,
               Candidate* best) const {
    const ArcLimits back{1.0 / plan_.max_curvature, Travel::kBackward};
    const double least_m = (least_steps - 0.5) * plan_.back_step_m;
    const auto firsts = FirstArcs(back, plan_.back_step_m, plan_.back_limit_m, plan_.back_turns);
    double back_cost = 0.0;
    const auto wants = [&](const Arc& first) {
      if (first.length_m > -least_m || !MayBackTo(Advance(start, first), history)) return false;
      back_cost = plan_.reverse_cost * -first.length_m;
      return back_cost + ArcCost(start, first) < best->cost;
    };
    ForEachTriple(
        Inverse(start) * Goal(plan_.align_gap_m), firsts,
        {1.0 / plan_.max_curvature, Travel::kForward}, plan_.back_splits, wants,
        [&](const ArcTriple& arcs) {
          Offer(start, {arcs.begin(), arcs.end()}, back_cost + PairCost({arcs[1], arcs[2]}), best);
        },
        CuspTurn());
    CuspPairs(start, history, least_m, best);
  }

 private:
  // The board must be in view after backing off, for the next image pair.
  bool MayBackTo(const Pose2& end, const PlanHistory& history) const {
    return SeesBoard(geometry_, options_.look, end) && !history.BackedTo(end);
  }

  // One arc back, one forwards; only where the course is the same both ways, as pairs are smooth.
  void CuspPairs(const Pose2& start, const PlanHistory& history, double least_m,
                 Candidate* best) const {
    if (std::abs(CuspTurn()) > kStraightOn) return;
    ForEachPair(Inverse(start) * Goal(plan_.align_gap_m),
                {1.0 / plan_.max_curvature, Travel::kEither}, plan_.splits,
                [&](const ArcPair& pair) {
                  const double back_m = -pair[0].length_m;
                  if (back_m < least_m || back_m > plan_.back_limit_m) return;
                  if (pair[1].length_m < 0.0) return;
                  if (!MayBackTo(Advance(start, pair[0]), history)) return;
                  Offer(start, {pair.begin(), pair.end()},
                        plan_.reverse_cost * back_m + pair[1].length_m, best);
                });
  }

  void Offer(const Pose2& start, const std::vector<Arc>& arcs, double cost, Candidate* best) const {
    Pose2 at = start;
    for (const Arc& arc : arcs) {
      if (cost >= best->cost) return;
      cost += ArcCost(at, arc);
      at = Advance(at, arc);
      if (arc.length_m < 0.0) at = at * Pose2{0.0, 0.0, CuspTurn()};
    }
    if (cost < best->cost) *best = {arcs, cost};
  }

  // Cost of this arc beyond its length: turning, board out of view, tether aside, rocks. Infinite
  // if the arc leaves the allowed region.
  double ArcCost(const Pose2& start, const Arc& arc) const {
    const double step = std::abs(arc.length_m) / kSamplesPerArc;
    const bool backwards = arc.length_m < 0.0;
    double cost = plan_.turn_cost_m * std::abs(arc.turn_rad);
    for (int i = 1; i <= kSamplesPerArc; ++i) {
      const Pose2 at = Advance(start, Part(arc, static_cast<double>(i) / kSamplesPerArc));
      if (!backwards && TipOf(geometry_, at).gap_m < plan_.min_tip_gap_m) return kNever;
      if (backwards && std::hypot(at.x, at.y) > plan_.max_range_m) return kNever;
      if (!SeesBoard(geometry_, options_.look, at)) cost += step * plan_.unseen_cost;
      const double aside = std::abs(TetherAngle(geometry_, at));
      cost += step * plan_.tether_angle_cost * std::max(0.0, aside - plan_.tether_angle_rad);
      cost += step * plan_.abeam_cost * std::max(0.0, aside - abeam_rad_);
    }
    if (!rocks_.empty()) cost += rocks_.Cost(start, arc);
    return cost;
  }

  const PlanGeometry& geometry_;
  const AxelOptions& options_;
  const PlanOptions& plan_;
  Drift drift_;
  double abeam_rad_;
  RockCheck rocks_;
};

}  // namespace

Pose2 CourseOf(const Pose2& X_DR, double drift, bool forwards) {
  const double angle = std::atan(drift);
  return {X_DR.x, X_DR.y, WrapPi(X_DR.heading + (forwards ? angle : -angle))};
}

bool PlanHistory::BackedTo(const Pose2& X_DR) const {
  return std::any_of(backed_to.begin(), backed_to.end(), [&](const Pose2& end) {
    return std::hypot(end.x - X_DR.x, end.y - X_DR.y) < kSamePlace_m &&
           std::abs(WrapPi(end.heading - X_DR.heading)) < kSameHeading;
  });
}

AxisPlan PlanOn(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                const Drift& drift) {
  const AxisSearch search(geometry, options, X_DR, {}, drift);
  const PlanOptions& plan = options.plan;
  const Pose2 start = CourseOf(X_DR, drift.here, true);
  struct Try {
    double gap_m, aside_m, max_curvature;
  };
  // First to the side where it is; on a slope not at all, as it would slide farther down.
  const double side = X_DR.y < 0.0 ? -plan.near_aside_m : plan.near_aside_m;
  const double aside = std::abs(drift.at_dock) > kLevelDrift ? 0.0 : side;
  const double near = plan.near_gap_m;
  // The last would cost a recovery if it failed, which is no more than a back-off.
  const Try tries[] = {
      {plan.align_gap_m, 0.0, plan.hold_curvature}, {near, 0.0, plan.hold_curvature},
      {near, aside, plan.hold_curvature},           {near, -aside, plan.hold_curvature},
      {near, aside, plan.last_curvature},           {near, -aside, plan.last_curvature}};
  for (const Try& at : tries) {
    Candidate on = search.Forward(start, at.max_curvature, search.Goal(at.gap_m, at.aside_m));
    if (!on.arcs.empty() && search.Clear(on)) return {start, std::move(on.arcs)};
  }
  if (search.HasRocks()) {
    Candidate round;
    search.Round(start, plan.hold_curvature, search.Goal(plan.align_gap_m), &round);
    if (!round.arcs.empty() && search.Clear(round)) return {start, std::move(round.arcs)};
  }
  return {start, {}};
}

AxisPlan PlanToAxis(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                    const PlanHistory& history, const Drift& drift) {
  const PlanOptions& plan = options.plan;
  if (history.under_way) {
    AxisPlan on = PlanOn(geometry, options, X_DR, drift);
    if (!on.arcs.empty()) return on;
  }
  const AxisSearch search(geometry, options, X_DR, history, drift);
  const Pose2 ahead = CourseOf(X_DR, drift.here, true), back = CourseOf(X_DR, drift.here, false);
  Candidate best = search.Forward(ahead, plan.max_curvature, search.Goal(plan.align_gap_m));
  if (search.HasRocks()) {
    search.Round(ahead, plan.max_curvature, search.Goal(plan.align_gap_m), &best);
  }
  search.BackOff(back, history, 1 + history.back_offs, &best);
  if (best.arcs.empty() || !search.Clear(best)) search.BackOff(back, history, 1, &best);
  if (best.arcs.empty()) best.arcs = {{-plan.back_step_m * (1 + history.back_offs), 0.0}};
  const bool over = !search.Clear(best);
  if (best.arcs.front().length_m >= 0.0) return {ahead, std::move(best.arcs), 0.0, over};
  return {back, std::move(best.arcs), search.CuspTurn(), over};
}

}  // namespace dockyard::axel
