#include "controller/axel/axis_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/axel/leg.h"
#include "controller/axel/mouth_way.h"
#include "controller/axel/rock_check.h"
#include "controller/motion/three_arcs.h"

namespace dockyard::axel {
namespace {

constexpr int kSamplesPerArc = 8;
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kNoTurn = 1e-9;              // numerically straight
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
    TurnedBackOffs(start, history, least_m, best);
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

  // Turned sharply to a heading first, then straight back: so a rover goes uphill backwards, which
  // presses its arm down.
  void TurnedBackOffs(const Pose2& start, const PlanHistory& history, double least_m,
                      Candidate* best) const {
    for (int k = -plan_.back_headings; k <= plan_.back_headings; ++k) {
      const double turn = WrapPi(kPi + k * plan_.back_heading_rad - start.heading);
      if (std::abs(turn) < kNoTurn) continue;  // BackOff goes straight back
      const Arc turned{-std::abs(turn) / plan_.max_recover_curvature, turn};
      const double turned_cost =
          plan_.reverse_cost * std::abs(turned.length_m) + ArcCost(start, turned);
      const Pose2 from = Advance(start, turned);
      const double limit_m = plan_.back_limit_m + turned.length_m;
      for (double way_m = plan_.back_step_m; way_m <= limit_m; way_m += plan_.back_step_m) {
        const Arc straight{-way_m, 0.0};
        const Pose2 end = Advance(from, straight);
        if (way_m - turned.length_m < least_m || !MayBackTo(end, history)) continue;
        const double back_cost = plan_.reverse_cost * way_m + turned_cost;
        if (back_cost + ArcCost(from, straight) >= best->cost) continue;
        const Pose2 on = end * Pose2{0.0, 0.0, CuspTurn()};
        ForEachPair(Inverse(on) * Goal(plan_.align_gap_m),
                    {1.0 / plan_.max_curvature, Travel::kForward}, plan_.back_splits,
                    [&](const ArcPair& pair) {
                      Offer(start, {turned, straight, pair[0], pair[1]},
                            plan_.reverse_cost * (way_m - turned.length_m) + PairCost(pair), best);
                    });
      }
    }
  }

  void Offer(const Pose2& start, const std::vector<Arc>& arcs, double cost, Candidate* best) const {
    Pose2 at = start;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (cost >= best->cost) return;
      const bool cusp = i > 0 && arcs[i - 1].length_m < 0.0 && arcs[i].length_m >= 0.0;
      if (cusp) at = at * Pose2{0.0, 0.0, CuspTurn()};
      cost += ArcCost(at, arcs[i]);
      at = Advance(at, arcs[i]);
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
      cost += step * plan_.far_abeam_cost * std::max(0.0, aside - abeam_rad_ - plan_.far_abeam_rad);
      if (!backwards)
        cost += step * plan_.lift_cost * std::max(0.0, Thrust(at, aside) - plan_.lift_share);
    }
    if (!rocks_.empty()) cost += rocks_.Cost(start, arc);
    return cost;
  }

  // Of the wheels, over the weight: what rolling and the slope take less what the tether gives.
  double Thrust(const Pose2& at, double aside) const {
    const double climb =
        -(drift_.downhill_x * std::cos(at.heading) + drift_.downhill_y * std::sin(at.heading));
    const double tether = TensionAside(options_.tether, aside) / options_.noise.weight_n;
    return plan_.rolling_share + climb - tether * std::cos(aside);
  }

  const PlanGeometry& geometry_;
  const AxelOptions& options_;
  const PlanOptions& plan_;
  Drift drift_;
  double abeam_rad_;
  RockCheck rocks_;
};

AxisPlan Rest(const Pose2& start, Candidate on) {
  const double beyond_m = on.cost - Length(on.arcs);
  return {start, std::move(on.arcs), 0.0, false, beyond_m};
}

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
    if (!on.arcs.empty() && search.Clear(on)) return Rest(start, std::move(on));
  }
  if (search.HasRocks()) {
    Candidate round;
    search.Round(start, plan.hold_curvature, search.Goal(plan.align_gap_m), &round);
    if (!round.arcs.empty() && search.Clear(round)) return Rest(start, std::move(round));
  }
  return {start, {}};
}

AxisPlan PlanToAxis(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                    const PlanHistory& history, const Drift& drift) {
  const PlanOptions& plan = options.plan;
  if (history.under_way) {
    AxisPlan on = PlanOn(geometry, options, X_DR, drift);
    if (!on.arcs.empty() && on.beyond_m <= plan.rest_beyond_m) return on;
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
