#include "controller/axel/planner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dockyard::axel {
namespace {

constexpr int kSamplesPerArc = 8;
constexpr double kNever = std::numeric_limits<double>::infinity();

Pose2 OnAxis(double x_m) { return {x_m, 0.0, kPi}; }

// Cost of this arc beyond its length: board out of view, tether aside. Infinite if the arc leaves
// the allowed region.
double SideCost(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& start,
                const Arc& arc) {
  const double step = std::abs(arc.length_m) / kSamplesPerArc;
  double cost = 0.0;
  for (int i = 1; i <= kSamplesPerArc; ++i) {
    const Pose2 at = Advance(start, Part(arc, static_cast<double>(i) / kSamplesPerArc));
    const bool backwards = arc.length_m < 0.0;
    if (!backwards && TipOf(geometry, at).gap_m < options.plan.min_tip_gap_m) return kNever;
    if (backwards && std::hypot(at.x, at.y) > options.plan.max_range_m) return kNever;
    if (!SeesBoard(geometry, options.look, at)) cost += step * options.plan.unseen_cost;
    const double aside = std::abs(TetherAngle(geometry, at)) - options.plan.tether_angle_rad;
    cost += step * options.plan.tether_angle_cost * std::max(0.0, aside);
  }
  return cost;
}

struct Candidate {
  std::vector<Arc> arcs;
  double cost = kNever;
};

bool FitsForward(const std::vector<Arc>& arcs, double max_curvature) {
  return std::all_of(arcs.begin(), arcs.end(), [&](const Arc& arc) {
    return arc.length_m >= 0.0 &&
           std::abs(arc.turn_rad) <= max_curvature * std::abs(arc.length_m) + 1e-9;
  });
}

// The best two forward arcs from here, none sharper than this, that cost less than the bound.
Candidate BestForward(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                      double max_curvature, double bound) {
  const Pose2 goal = Inverse(X_DR) * OnAxis(geometry.arm_m + options.plan.align_gap_m);
  Candidate best{{}, bound};
  for (const double k1 : CurvatureFan(max_curvature, options.plan.curvatures)) {
    const auto arcs = TwoArcsTo(goal, k1);
    if (!arcs || !FitsForward(*arcs, max_curvature)) continue;
    double cost = TwoArcCost(*arcs) + options.plan.turn_cost_m * Turning(*arcs);
    Pose2 start = X_DR;
    for (const Arc& arc : *arcs) {
      if (cost >= best.cost) break;
      cost += SideCost(geometry, options, start, arc);
      start = Advance(start, arc);
    }
    if (cost < best.cost) best = {*arcs, cost};
  }
  return best;
}

// The board must be in view after backing off, for the next image pair.
void TryBackingOff(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                   const Arc& back, Candidate* best) {
  const Pose2 end = Advance(X_DR, back);
  if (!SeesBoard(geometry, options.look, end)) return;
  const double cost = options.plan.reverse_cost * std::abs(back.length_m) +
                      options.plan.turn_cost_m * std::abs(back.turn_rad) +
                      SideCost(geometry, options, X_DR, back);
  if (cost >= best->cost) return;
  const Candidate forward =
      BestForward(geometry, options, end, options.plan.max_curvature, best->cost - cost);
  if (forward.arcs.empty()) return;
  best->cost = cost + forward.cost;
  best->arcs = {back};
  best->arcs.insert(best->arcs.end(), forward.arcs.begin(), forward.arcs.end());
}

// Backwards by at least this many steps, straight or turning.
void TryBackingOffFrom(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                       int least_steps, Candidate* best) {
  const PlanOptions& plan = options.plan;
  const int steps = static_cast<int>(plan.back_limit_m / plan.back_step_m + 0.5);
  for (int i = least_steps; i <= steps; ++i) {
    const double length = -i * plan.back_step_m;
    TryBackingOff(geometry, options, X_DR, {length, 0.0}, best);
    for (int j = 1; j <= plan.back_turns; ++j) {
      const double turn = j * plan.back_turn_rad;
      if (turn > plan.max_curvature * -length) break;
      TryBackingOff(geometry, options, X_DR, {length, turn}, best);
      TryBackingOff(geometry, options, X_DR, {length, -turn}, best);
    }
  }
}

}  // namespace

PlanGeometry PlanGeometryOf(const Nominal& nominal) {
  PlanGeometry geometry;
  geometry.arm_m = nominal.arm_length_m;
  geometry.mating_depth_m = nominal.mating_depth_m;
  const Camera& lens = nominal.rig.left;
  const Eigen::Vector2d centre = lens.centre_px();
  const double narrow = std::min(centre.x() + 0.5, lens.width - 0.5 - centre.x());
  const Eigen::Vector3d edge = lens.Direction({centre.x() + narrow, centre.y()});
  geometry.half_view_rad = std::atan2(edge.x(), edge.z());
  geometry.board_half_width_m = 0.5 * nominal.board.width_m;
  geometry.p_DB = nominal.X_DB.p.head<2>();
  return geometry;
}

TipPlace TipOf(const PlanGeometry& geometry, const Pose2& X_DR) {
  return {X_DR.x + geometry.arm_m * std::cos(X_DR.heading),
          X_DR.y + geometry.arm_m * std::sin(X_DR.heading)};
}

double BoardBearing(const PlanGeometry& geometry, const Pose2& X_DR) {
  const Eigen::Vector2d to = geometry.p_DB - Eigen::Vector2d(X_DR.x, X_DR.y);
  return WrapPi(std::atan2(to.y(), to.x()) - X_DR.heading);
}

bool SeesBoard(const PlanGeometry& geometry, const LookOptions& look, const Pose2& X_DR) {
  const double range = (geometry.p_DB - Eigen::Vector2d(X_DR.x, X_DR.y)).norm();
  const double half = std::atan2(geometry.board_half_width_m, range);
  return std::abs(BoardBearing(geometry, X_DR)) + look.board_share * half <=
         geometry.half_view_rad - look.view_margin_rad;
}

double TetherAngle(const PlanGeometry& geometry, const Pose2& X_DR) {
  const TipPlace tip = TipOf(geometry, X_DR);
  return WrapPi(std::atan2(-tip.offset_m, -tip.gap_m) - X_DR.heading);
}

double SocketAngle(const PlanGeometry& geometry, double axle_offset_m) {
  const double sine = std::clamp(axle_offset_m / geometry.arm_m, -1.0, 1.0);
  return std::asin(sine) * std::exp(-geometry.mating_depth_m / geometry.arm_m);
}

bool Aligned(const PlanGeometry& geometry, const MateOptions& mate, const Pose2& X_DR) {
  const double h = WrapPi(X_DR.heading - kPi);
  if (std::abs(h) > mate.heading_rad) return false;
  const double to_mouth = std::max(0.0, X_DR.x - geometry.arm_m);
  const double axle_then = X_DR.y - to_mouth * std::tan(h);
  const double tip_then = axle_then - geometry.arm_m * std::sin(h);
  return std::abs(tip_then) <= mate.tip_offset_m &&
         std::abs(SocketAngle(geometry, axle_then)) <= mate.socket_rad;
}

std::vector<Arc> PlanToAxis(const PlanGeometry& geometry, const AxelOptions& options,
                            const Pose2& X_DR, const PlanHistory& history) {
  const PlanOptions& plan = options.plan;
  if (history.under_way) {
    const Candidate on = BestForward(geometry, options, X_DR, plan.hold_curvature, kNever);
    if (!on.arcs.empty()) return on.arcs;
  }
  Candidate best = BestForward(geometry, options, X_DR, plan.max_curvature, kNever);
  TryBackingOffFrom(geometry, options, X_DR, 1 + history.back_offs, &best);
  if (best.arcs.empty()) TryBackingOffFrom(geometry, options, X_DR, 1, &best);
  if (best.arcs.empty()) return {{-plan.back_step_m, 0.0}};
  return best.arcs;
}

std::vector<Arc> PlanRecovery(const PlanGeometry& geometry, const AxelOptions& options,
                              const Pose2& X_DR) {
  std::vector<Arc> arcs;
  const double gap = TipOf(geometry, X_DR).gap_m;
  if (gap < options.plan.min_tip_gap_m) arcs.push_back({gap - options.plan.min_tip_gap_m, 0.0});
  const Pose2 out = Advance(X_DR, arcs);
  const Pose2 goal = Inverse(out) * OnAxis(geometry.arm_m + options.plan.recover_gap_m);
  const auto pair = CheapestTwoArcs(goal, options.plan.max_recover_curvature, -1);
  if (pair) {
    arcs.insert(arcs.end(), pair->begin(), pair->end());
  } else {
    arcs.push_back({-std::max(options.plan.back_step_m, -goal.x), 0.0});
  }
  return arcs;
}

std::vector<Arc> FirstLeg(const PlanGeometry& geometry, const AxelOptions& options,
                          const Pose2& X_DR, const std::vector<Arc>& plan) {
  if (plan.front().length_m < 0.0) return {plan.front()};
  constexpr double kStep = 0.05;
  const PlanOptions& limits = options.plan;
  std::vector<Arc> leg;
  double way = 0.0, turned = 0.0;
  Pose2 start = X_DR;
  for (const Arc& arc : plan) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(arc.length_m / kStep)));
    for (int i = 1; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      const double gone = way + share * arc.length_m;
      const double turn = turned + share * std::abs(arc.turn_rad);
      const bool enough =
          gone >= limits.leg_max_m || (gone >= limits.leg_min_m && turn >= limits.leg_turn_rad);
      const bool rest_is_long = Length(plan) - gone >= 0.5 * limits.leg_min_m;
      const Pose2 at = Advance(start, Part(arc, share));
      if (enough && rest_is_long && SeesBoard(geometry, options.look, at)) {
        leg.push_back(Part(arc, share));
        return leg;
      }
    }
    leg.push_back(arc);
    way += arc.length_m;
    turned += std::abs(arc.turn_rad);
    start = Advance(start, arc);
  }
  return leg;
}

Decision Decide(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                const PlanHistory& history) {
  const double gap = TipOf(geometry, X_DR).gap_m;
  if (gap <= options.plan.align_gap_m + options.plan.align_tolerance_m) {
    if (Aligned(geometry, options.mate, X_DR)) {
      const std::vector<Arc> on{{std::max(0.0, gap - options.mate.look_gap_m), 0.0}};
      return {Event::kGoMate, on, on};
    }
    const std::vector<Arc> back = PlanRecovery(geometry, options, X_DR);
    return {Event::kGoRecover, back, back};
  }
  const std::vector<Arc> plan = PlanToAxis(geometry, options, X_DR, history);
  const std::vector<Arc> leg = FirstLeg(geometry, options, X_DR, plan);
  if (plan.front().length_m < 0.0) return {Event::kGoBackOff, plan, leg};
  const bool near = std::hypot(X_DR.x, X_DR.y) <= options.plan.align_range_m;
  return {near ? Event::kGoAlign : Event::kGoApproach, plan, leg};
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
