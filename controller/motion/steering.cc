#include "controller/motion/steering.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dockyard {

WheelOnArc OnArc(const WheelPlan& wheel, const Arc& arc) {
  const double ahead_m = arc.length_m - arc.turn_rad * wheel.p_RW.y();
  const double aside_m = arc.turn_rad * wheel.p_RW.x();
  if (wheel.steer_limit_rad == 0.0) {
    return {0.0, ahead_m, std::atan2(aside_m, std::abs(ahead_m))};
  }
  const double way_m = std::hypot(ahead_m, aside_m);
  if (ahead_m < 0.0) return {std::atan2(-aside_m, -ahead_m), -way_m, 0.0};
  return {std::atan2(aside_m, ahead_m), way_m, 0.0};
}

// A wheel at (x, y) with the limit d cannot steer to centres within abs(x) / tan d of its own y.
ArcLimits LimitsOf(const std::vector<WheelPlan>& wheels, Travel travel) {
  double least_m = 0.0, pivot_m = std::numeric_limits<double>::infinity();
  for (const WheelPlan& wheel : wheels) {
    const double x = std::abs(wheel.p_RW.x()), y = std::abs(wheel.p_RW.y());
    if (wheel.steer_limit_rad == 0.0 || x == 0.0 || wheel.steer_limit_rad >= 0.5 * kPi) continue;
    const double reach_m = x / std::tan(wheel.steer_limit_rad);
    least_m = std::max(least_m, y + reach_m);
    pivot_m = std::min(pivot_m, y - reach_m);
  }
  ArcLimits limits{least_m, travel};
  if (least_m > 0.0 && pivot_m >= 0.0) limits.pivot_radius_m = pivot_m;
  return limits;
}

}  // namespace dockyard
