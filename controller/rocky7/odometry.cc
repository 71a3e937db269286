#include "controller/rocky7/odometry.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/arcs.h"

namespace dockyard::rocky7 {
void Odometry::Begin(double yaw_rad) {
  yaw_at_start_rad_ = yaw_rad;
  before_ = {};
}

Pose2 Odometry::Step(double driven_m, const Pose2& counted, double yaw_rad) {
  Pose2 moved = counted;
  if (options_.turn_by_unit) {
    moved = Advance({}, Arc{(1.0 - slip_) * driven_m, WrapPi(yaw_rad - yaw_at_start_rad_)});
  }
  const Pose2 since = Inverse(before_) * moved;
  before_ = moved;
  return since;
}

void Odometry::Learn(double further_m, double sigma_m, double way_m) {
  if (options_.slip <= 0.0 || way_m == 0.0) return;
  const double by_slip_m2 = kSlipSigma * kSlipSigma * way_m * way_m;
  const double gain = by_slip_m2 / (by_slip_m2 + sigma_m * sigma_m);
  slip_ = std::clamp(slip_ + gain * further_m / way_m, 0.0, kMostSlip);
}

}  // namespace dockyard::rocky7
