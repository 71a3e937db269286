#include "sim/rigid/slope.h"

#include <cmath>

#include "models/parts/gravity.h"

namespace dockyard {

Eigen::Matrix3d Tilt(const Slope& slope) {
  if (slope.angle_rad == 0.0) return Eigen::Matrix3d::Identity();
  // About the level line across the way down, so that the normal leans that way.
  const Eigen::Vector3d across(-std::sin(slope.downhill_rad), std::cos(slope.downhill_rad), 0.0);
  return Eigen::AngleAxisd(slope.angle_rad, across).toRotationMatrix();
}

Pose3 SiteInWorld(const Pose2& X_WG, const Slope& slope) {
  Pose3 X = FromGround(X_WG, 0.0);
  X.R = X.R * Tilt(slope);
  return X;
}

Eigen::Vector3d GravityInSite(const Slope& slope) {
  const double g = kEarthGravity_m_s2;
  if (slope.angle_rad == 0.0) return {0.0, 0.0, -g};
  return Tilt(slope).transpose() * Eigen::Vector3d(0.0, 0.0, -g);
}

}  // namespace dockyard
