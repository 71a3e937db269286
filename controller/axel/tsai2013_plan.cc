#include "controller/axel/tsai2013_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/axel/tether_length.h"
#include "controller/motion/two_arcs.h"

namespace dockyard::axel {
namespace {

Pose2 OnAxis(double r_m) { return {r_m, 0.0, kPi}; }

// The pair of least way and turning (IV-A).
std::optional<std::vector<Arc>> BestPair(const Tsai2013Options& options, const Pose2& X_DR,
                                         const Pose2& X_DR_goal, Travel travel) {
  std::optional<std::vector<Arc>> best;
  double least = 0.0;
  ForEachPair(Inverse(X_DR) * X_DR_goal, {options.least_radius_m, travel}, options.splits,
              [&](const ArcPair& pair) {
                std::vector<Arc> arcs(pair.begin(), pair.end());
                for (const Arc& arc : arcs) {
                  if (std::abs(arc.turn_rad) > options.most_turn_rad) return;
                }
                const double cost = PairCost(pair) + options.turn_cost_m * Turning(arcs);
                if (best && cost >= least) return;
                least = cost;
                best = std::move(arcs);
              });
  return best;
}

// Straight back where no pair of arcs leads to the recovery goal.
Tsai2013Plan Recovery(const Tsai2013Options& options, const Pose2& X_DR) {
  const Pose2 goal = OnAxis(options.recover_r_m);
  if (auto pair = BestPair(options, X_DR, goal, Travel::kBackward)) {
    return {Tsai2013Step::kRecover, std::move(*pair)};
  }
  const double back_m = std::max(0.5 * options.recover_r_m, options.recover_r_m - X_DR.x);
  return {Tsai2013Step::kRecover, {{-back_m, 0.0}}};
}

double HeadingError(const Pose2& X_DR) { return std::abs(WrapPi(X_DR.heading - kPi)); }

// Straight on from here, the tip comes to the mouth this far beside its middle.
double OffsetAtMouth(const PlanGeometry& geometry, const Pose2& X_DR) {
  const TipPlace tip = TipOf(geometry, X_DR);
  return std::abs(tip.offset_m - tip.gap_m * std::tan(WrapPi(X_DR.heading - kPi)));
}

// "The rover rechecks its alignment then puts its wheels in free rotation mode" (IV).
Tsai2013Plan Mating(const PlanGeometry& geometry, const Tsai2013Options& options,
                    const Pose2& X_DR) {
  if (HeadingError(X_DR) > options.heading_rad) return Recovery(options, X_DR);
  const TipPlace tip = TipOf(geometry, X_DR);
  const double to_contact_m = tip.gap_m + options.contact_depth_m;
  if (to_contact_m <= options.contact_within_m) {
    if (std::abs(tip.offset_m) > options.tip_offset_m) return Recovery(options, X_DR);
    return {Tsai2013Step::kReel, {}};
  }
  const Pose2 contact = OnAxis(geometry.arm_m - options.contact_depth_m);
  auto pair = BestPair(options, X_DR, contact, Travel::kForward);
  if (pair) return {Tsai2013Step::kMate, std::move(*pair)};
  if (OffsetAtMouth(geometry, X_DR) > options.tip_offset_m) return Recovery(options, X_DR);
  return {Tsai2013Step::kMate, {{to_contact_m, 0.0}}};
}

}  // namespace

Tsai2013Plan PlanTsai2013(const PlanGeometry& geometry, const Tsai2013Options& options,
                          const Pose2& X_DR) {
  const double r_m = std::hypot(X_DR.x, X_DR.y);
  if (r_m <= options.mate_r_m) return Mating(geometry, options, X_DR);
  if (r_m > options.align_r_m) {
    auto approach = BestPair(options, X_DR, OnAxis(options.align_r_m), Travel::kForward);
    if (approach) return {Tsai2013Step::kApproach, std::move(*approach)};
  }
  const Pose2 before_mouth = OnAxis(geometry.arm_m + options.mate_gap_m);
  auto align = BestPair(options, X_DR, before_mouth, Travel::kForward);
  if (align) return {Tsai2013Step::kAlign, std::move(*align)};
  return Recovery(options, X_DR);
}

std::vector<double> TetherShortening(double arm_m, const Pose2& X_DR_start,
                                     const std::vector<Arc>& arcs) {
  std::vector<double> shorten_m;
  Pose2 at = X_DR_start;
  double length_m = CosineLawTether(arm_m, ToDockingCoords(at));
  for (const Arc& arc : arcs) {
    at = Advance(at, arc);
    const double then_m = CosineLawTether(arm_m, ToDockingCoords(at));
    shorten_m.push_back(length_m - then_m);
    length_m = then_m;
  }
  return shorten_m;
}

}  // namespace dockyard::axel
