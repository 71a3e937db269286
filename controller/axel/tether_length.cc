#include "controller/axel/tether_length.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {

double CosineLawTether(double arm_m, const DockingCoords& at) {
  const double square =
      arm_m * arm_m + at.r * at.r - 2.0 * arm_m * at.r * std::cos(at.alpha - at.h);
  return std::sqrt(std::max(0.0, square));
}

TetherGeometry TetherGeometryOf(const Nominal& nominal) {
  TetherGeometry geometry;
  const Eigen::Vector3d p_DM(0.0, 0.0, nominal.mouth_height_m);
  // The board sits in the cone's face, so its normal into the station is the cone's axis.
  const Eigen::Vector3d inward = nominal.X_DB.R.col(2);
  geometry.p_DQ = p_DM + std::min(nominal.throat_depth_m, nominal.anchor_depth_m) * inward;
  geometry.p_DA = p_DM + nominal.anchor_depth_m * inward;
  geometry.arm_m = nominal.arm_length_m;
  geometry.axle_height_m = nominal.wheel_radius_m;
  return geometry;
}

Eigen::Vector3d TipInDock(const TetherGeometry& geometry, const Pose2& X_DR, double elevation_rad) {
  const double reach = geometry.arm_m * std::cos(elevation_rad);
  return {X_DR.x + reach * std::cos(X_DR.heading), X_DR.y + reach * std::sin(X_DR.heading),
          geometry.axle_height_m + geometry.arm_m * std::sin(elevation_rad)};
}

double ExposedTether(const TetherGeometry& geometry, const Pose2& X_DR, double elevation_rad) {
  const Eigen::Vector3d p_DT = TipInDock(geometry, X_DR, elevation_rad);
  const Eigen::Vector3d behind = geometry.p_DA - geometry.p_DQ;
  if ((p_DT - geometry.p_DQ).dot(behind) > 0.0) return (p_DT - geometry.p_DA).norm();
  return (p_DT - geometry.p_DQ).norm() + behind.norm();
}

Eigen::Vector3d ExposedTetherSlope(const TetherGeometry& geometry, const Pose2& X_DR,
                                   double elevation_rad) {
  constexpr double kStep = 1e-4;
  const auto slope = [&](const Pose2& more, const Pose2& less) {
    return (ExposedTether(geometry, more, elevation_rad) -
            ExposedTether(geometry, less, elevation_rad)) /
           (2.0 * kStep);
  };
  const auto& [x, y, heading] = X_DR;
  return {slope({x + kStep, y, heading}, {x - kStep, y, heading}),
          slope({x, y + kStep, heading}, {x, y - kStep, heading}),
          slope({x, y, heading + kStep}, {x, y, heading - kStep})};
}

double ExposedTetherRate(const TetherGeometry& geometry, const Pose2& X_DR, double elevation_rad,
                         double speed_m_s, double turn_rad_s) {
  const Eigen::Vector3d slope = ExposedTetherSlope(geometry, X_DR, elevation_rad);
  return slope.x() * speed_m_s * std::cos(X_DR.heading) +
         slope.y() * speed_m_s * std::sin(X_DR.heading) + slope.z() * turn_rad_s;
}

}  // namespace dockyard::axel
