#include "controller/rocky7/paths_to_point.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/steering.h"
#include "controller/motion/three_arcs.h"

namespace dockyard::rocky7 {
namespace {

// First arcs of a path of two: lengths in steps up to a longest. Assumed, 2-10 cm and 0.3-1 m.
constexpr double kFirstStep_m = 0.03, kFirstLongest_m = 0.6;
constexpr int kFirstCurvatures = 3;
// A shorter first arc is lost in the sand as the wheels start and stop. Assumed, 5-15 cm.
constexpr double kFirstShortest_m = 0.09;
// All paths of one arc or two, as the limits let them.
template <class Visit>
void ForEachPath(const Eigen::Vector2d& p_RG, const Eigen::Vector2d& p_RP, const ArcLimits& limits,
                 Visit&& visit) {
  for (const Arc& first : FirstArcs(limits, kFirstStep_m, kFirstLongest_m, kFirstCurvatures)) {
    // Ahead and back again would hide the goal below the rover.
    if (first.length_m > std::max(0.0, p_RG.x() - p_RP.x())) continue;
    const auto second = OneArcTo(Inverse(Advance({}, first)) * p_RG, p_RP);
    if (!second || !Keeps(*second, limits)) continue;
    visit(first.length_m == 0.0 ? std::vector<Arc>{*second} : std::vector<Arc>{first, *second});
  }
}

}  // namespace

ArcLimits GentleLimits(const RoverPlan& plan) {
  ArcLimits limits = LimitsOf(plan.wheels, Travel::kEither);
  limits.pivot_radius_m.reset();
  return limits;
}

Arc NoSharper(const Arc& arc, const ArcLimits& limits) {
  if (Keeps(arc, limits) || limits.least_radius_m <= 0.0) return arc;
  const double turn_rad = std::abs(arc.length_m) / limits.least_radius_m;
  return {arc.length_m, std::copysign(turn_rad, arc.turn_rad)};
}

std::vector<Arc> ArcsToPoint(const Eigen::Vector2d& p_RG, const Eigen::Vector2d& p_RP,
                             const ArcLimits& limits) {
  const auto straight = OneArcTo(p_RG, p_RP);
  if (straight && Keeps(*straight, limits)) return {*straight};
  std::vector<Arc> best, shortest;
  ForEachPath(p_RG, p_RP, limits, [&](const std::vector<Arc>& path) {
    if (shortest.empty() || Length(path) < Length(shortest)) shortest = path;
    if (std::abs(path.front().length_m) < kFirstShortest_m) return;
    if (best.empty() || Length(path) < Length(best)) best = path;
  });
  return best.empty() ? shortest : best;
}

std::vector<Arc> GentleArcsToPoint(const Eigen::Vector2d& p_RG, const RoverPlan& plan) {
  const ArcLimits limits = GentleLimits(plan);
  ArcLimits gentle = limits;
  gentle.least_radius_m = std::max(limits.least_radius_m, kGentleRadius_m);
  const std::vector<Arc> path = ArcsToPoint(p_RG, plan.p_RP, gentle);
  return path.empty() ? ArcsToPoint(p_RG, plan.p_RP, limits) : path;
}

}  // namespace dockyard::rocky7
