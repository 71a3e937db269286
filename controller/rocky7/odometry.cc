#include "controller/rocky7/odometry.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// Of a turn, what stones under the wheels add, squared: one of so much teaches half of what it
// shows. Assumed, 2-6 deg.
constexpr double kTurnNoise2 = Radians(4.0) * Radians(4.0);
// No more and no less is believed. Assumed, 0.3-0.6 and 1-1.3.
constexpr double kLeastTurn = 0.4, kMostTurn = 1.2;
// Downhill, of a metre at a roll of 90 deg. Assumed, 1.5-3.
constexpr double kMostDrift = 2.0;

}  // namespace

void Odometry::Begin(double yaw_rad) {
  const double counted_rad = before_.heading, turned_rad = WrapPi(yaw_rad - yaw_at_start_rad_);
  const double gain = counted_rad * counted_rad / (counted_rad * counted_rad + kTurnNoise2);
  if (counted_rad != 0.0) {
    const double share = std::clamp(turned_rad / counted_rad, kLeastTurn, kMostTurn);
    turn_share_ += gain * (share - turn_share_);
  }
  yaw_at_start_rad_ = yaw_before_rad_ = yaw_rad;
  driven_before_m_ = 0.0;
  before_ = {};
}

// Slip may be learnt half-way: it counts from there on.
Pose2 Odometry::Step(double driven_m, const Pose2& counted, const ImuSample& attitude) {
  Pose2 since = Inverse(before_) * counted;
  const double distance_m = driven_m - driven_before_m_;
  if (options_.turn_by_unit) {
    since = Advance(
        {}, Arc{(1.0 - SlipOn(driven_m)) * distance_m, WrapPi(attitude.yaw_rad - yaw_before_rad_)});
  }
  since.y += DriftOn(distance_m, attitude.roll_rad);
  before_ = counted;
  driven_before_m_ = driven_m;
  yaw_before_rad_ = attitude.yaw_rad;
  return since;
}

void Odometry::Learn(double further_m, double sigma_m, double way_m) {
  if (options_.slip <= 0.0 || way_m == 0.0) return;
  const double by_slip_m2 = kSlipSigma * kSlipSigma * way_m * way_m;
  const double gain = by_slip_m2 / (by_slip_m2 + sigma_m * sigma_m);
  double& slip = slip_[way_m < 0.0 ? 1 : 0];
  slip = std::clamp(slip + gain * further_m / way_m, 0.0, kMostSlip);
}

Arc Odometry::AgainstSlip(const Arc& arc) const {
  return {arc.length_m / (1.0 - SlipOn(arc.length_m)), arc.turn_rad / turn_share_};
}

double Odometry::DriftOn(double distance_m, double roll_rad) const {
  return drift_ * std::abs(distance_m) * std::sin(roll_rad);
}

double Odometry::DriftSigma(double rolled_m) const {
  return options_.drifts ? std::sqrt(drift_variance_) * std::abs(rolled_m) : 0.0;
}

// A scalar Kalman filter: the drift of this soil stays.
void Odometry::LearnDrift(double left_m, double sigma_m, double rolled_m) {
  if (!options_.drifts) return;
  const double innovation_m2 = drift_variance_ * rolled_m * rolled_m + sigma_m * sigma_m;
  const double gain = drift_variance_ * rolled_m / innovation_m2;
  drift_ = std::clamp(drift_ + gain * left_m, -kMostDrift, 0.0);
  drift_variance_ *= 1.0 - gain * rolled_m;
}

}  // namespace dockyard::rocky7
