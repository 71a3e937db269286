#include "controller/motion/two_arcs.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr double kTolerance_m = 1e-9;

}  // namespace

bool Keeps(const Arc& arc, const ArcLimits& limits) {
  if (limits.travel == Travel::kForward && arc.length_m < -kTolerance_m) return false;
  if (limits.travel == Travel::kBackward && arc.length_m > kTolerance_m) return false;
  const double length_m = std::abs(arc.length_m), turn_rad = std::abs(arc.turn_rad);
  if (length_m + kTolerance_m >= limits.least_radius_m * turn_rad) return true;
  return limits.pivot_radius_m && length_m <= *limits.pivot_radius_m * turn_rad + kTolerance_m;
}

bool Keeps(const ArcPair& pair, const ArcLimits& limits) {
  return Keeps(pair[0], limits) && Keeps(pair[1], limits);
}

double PairCost(const ArcPair& pair) {
  return 2.0 * std::max(std::abs(pair[0].length_m), std::abs(pair[1].length_m));
}

}  // namespace dockyard
