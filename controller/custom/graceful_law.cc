#include "controller/custom/graceful_law.h"

#include <algorithm>
#include <cmath>

namespace dockyard::custom {
namespace {

constexpr double kNearest_m = 1e-3;  // the law has no value on its target

}  // namespace

SightCoords ToSightCoords(const Pose2& X_AT) {
  const double sight_rad = std::atan2(X_AT.y, X_AT.x);
  return {std::hypot(X_AT.x, X_AT.y), WrapPi(X_AT.heading - sight_rad), WrapPi(-sight_rad)};
}

double GracefulCurvature(const SightCoords& at, const DockingOptions& options) {
  const double k1 = options.k_phi, k2 = options.k_delta;
  const double reach = k1 * at.theta_rad;
  const double wanted_rad = std::atan(-reach);
  return -(k2 * (at.delta_rad - wanted_rad) +
           (1.0 + k1 / (1.0 + reach * reach)) * std::sin(at.delta_rad)) /
         std::max(at.r_m, kNearest_m);
}

Twist GracefulTwist(const Pose2& X_AT, double travel, const DockingOptions& options) {
  const Pose2 turned{0.0, 0.0, travel < 0.0 ? kPi : 0.0};
  const SightCoords at = ToSightCoords(Inverse(turned) * X_AT * turned);
  const double curvature = GracefulCurvature(at, options);
  double speed =
      options.most_m_s / (1.0 + options.beta * std::pow(std::abs(curvature), options.lambda));
  if (at.r_m < options.slowdown_m)
    speed = std::min(speed, options.most_m_s * at.r_m / options.slowdown_m);
  speed = std::clamp(speed, options.least_m_s, options.most_m_s);
  double turn = curvature * speed;
  if (std::abs(turn) > options.most_rad_s) {
    turn = std::copysign(options.most_rad_s, turn);
    speed = turn / curvature;
  }
  return {travel < 0.0 ? -speed : speed, turn};
}

}  // namespace dockyard::custom
