#include "controller/axel/station_hold.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {
namespace {

// The ellipsoid bulges beyond the true limit surface of four soles, by up to 16 % for a pull at the
// mouth. With this share of the moment it is right to 6 %, as the test computes it.
constexpr double kMomentShare = 0.8;

// Of the line from the mouth to the rover's tip, against the station's axis.
double PullAside(const Nominal& nominal, const Senses& senses) {
  if (!senses.filter().located()) return 0.0;
  const Pose2 X_DR = senses.pose();
  const double tip_x = X_DR.x + nominal.arm_length_m * std::cos(X_DR.heading);
  const double tip_y = X_DR.y + nominal.arm_length_m * std::sin(X_DR.heading);
  return tip_x > 0.0 ? std::abs(std::atan2(tip_y, tip_x)) : 0.0;
}

}  // namespace

// With k = M/M0 over F/F0 of a pull F, and the weight's share G downhill in the same direction:
//   ((F + G)/F0)^2 + (k F/F0)^2 = 1.
double SureHold(const Nominal& nominal, const HoldOptions& options, double slope_rad,
                double aside_rad) {
  const double weight_n = nominal.station_weight_n * (1.0 - options.weight_share);
  const double friction = nominal.station_friction * (1.0 - options.friction_share);
  const double hold_n = friction * weight_n * std::cos(slope_rad);
  const double downhill_n = weight_n * std::sin(slope_rad);
  if (downhill_n >= hold_n) return 0.0;
  const double arm_m = kMomentShare * nominal.station_spread_m;
  const double lever = arm_m > 0.0 ? nominal.station_back_m / arm_m : 0.0;
  const double k = lever * std::abs(std::sin(aside_rad)), a = 1.0 + k * k;
  const double root =
      std::sqrt(downhill_n * downhill_n + a * (hold_n * hold_n - downhill_n * downhill_n));
  return (root - downhill_n) / a;
}

double KnownSlope(const Senses& senses) {
  const double lean = std::max(senses.ground().lean_D().norm(), std::abs(senses.side_slope()));
  return std::asin(std::min(1.0, lean));
}

double SeatTension(const AxelOptions& options, const Senses& senses) {
  return options.mate.taut_tension_n +
         options.noise.weight_n * std::max(0.0, -senses.ground().up_D().x());
}

double SetPointBelow(double tension_n, const HoldOptions& options) {
  return (tension_n - options.over_n) / options.over_share;
}

double SurePull(const Nominal& nominal, const HoldOptions& options, const Senses& senses) {
  const double hold_n = SureHold(nominal, options, KnownSlope(senses), PullAside(nominal, senses));
  return std::max(options.least_pull_n, SetPointBelow(hold_n, options));
}

double TautTension(const Nominal& nominal, const AxelOptions& options, const Senses& senses) {
  if (!senses.filter().located()) return options.hold.least_pull_n;
  return std::min(options.tether.drive_tension_n, SurePull(nominal, options.hold, senses));
}

}  // namespace dockyard::axel
