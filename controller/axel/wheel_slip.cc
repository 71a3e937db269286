#include "controller/axel/wheel_slip.h"

#include <cmath>

namespace dockyard::axel {

double WheelSlip::Way(double rolled_m, const GroundForce& force) const {
  return (1.0 - rolling) * rolled_m + ahead * force.ahead * std::abs(rolled_m);
}

GroundForce GroundForceOn(const ImuSample& imu, const GroundSlope& ground,
                          const TetherGeometry& geometry, const Pose2& X_DR, double tether_n,
                          double weight_n) {
  const double tip_x = X_DR.x + geometry.arm_m * std::cos(X_DR.heading);
  const double tip_y = X_DR.y + geometry.arm_m * std::sin(X_DR.heading);
  const double aside =
      std::atan2(geometry.p_DQ.y() - tip_y, geometry.p_DQ.x() - tip_x) - X_DR.heading;
  const double tether = tether_n / weight_n;
  // Ahead is the left of a rover that has turned to the right. Its own pitch swings about the axle
  // and does not tell the slope along its way.
  const double downhill = SlopeForceAt(ground, X_DR.heading - 0.5 * kPi);
  return {-std::sin(AttitudeOf(imu).roll_rad), tether * std::sin(aside),
          downhill + tether * std::cos(aside)};
}

double SlopeForceAt(const GroundSlope& ground, double heading_rad) {
  const Eigen::Vector2d left(-std::sin(heading_rad), std::cos(heading_rad));
  return -ground.up_D().head<2>().dot(left);
}

}  // namespace dockyard::axel
