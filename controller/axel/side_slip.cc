#include "controller/axel/side_slip.h"

#include <cmath>

namespace dockyard::axel {

SideForce SideForceOn(const ImuSample& imu, const TetherGeometry& geometry, const Pose2& X_DR,
                      double tether_n, double weight_n) {
  const double tip_x = X_DR.x + geometry.arm_m * std::cos(X_DR.heading);
  const double tip_y = X_DR.y + geometry.arm_m * std::sin(X_DR.heading);
  const double aside = std::atan2(geometry.p_DQ.y() - tip_y, geometry.p_DQ.x() - tip_x);
  return {-std::sin(AttitudeOf(imu).roll_rad),
          tether_n / weight_n * std::sin(aside - X_DR.heading)};
}

double SlopeForceAt(const GroundSlope& ground, double heading_rad) {
  const Eigen::Vector2d left(-std::sin(heading_rad), std::cos(heading_rad));
  return -ground.up_D().head<2>().dot(left);
}

}  // namespace dockyard::axel
