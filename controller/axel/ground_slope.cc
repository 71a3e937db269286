#include "controller/axel/ground_slope.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "controller/geometry/axle_attitude.h"

namespace dockyard::axel {
namespace {

// The station leans on uneven ground, and its board is mounted with an error: assumed 1 deg
// (0.5-2).
constexpr double kStationSigma = Radians(1.0);
// The rover rolls on uneven ground: assumed 2 deg (1-3); 3 cm under one wheel.
constexpr double kRollSigma = Radians(2.0);
// A slope counts from here on, and only when it is this unlikely on level ground. Below, what it
// changes is less than the noise of the sightings. Assumed, 2-5 deg and 3-5 sigmas.
constexpr double kLeastSlope = Radians(3.0), kSigmas = 4.0;
// Roll that uneven ground does not give: three of its sigmas.
constexpr double kSlopeRoll = 3.0 * kRollSigma;

double Square(double x) { return x * x; }

Eigen::Vector3d UpInBody(const Attitude& attitude) {
  return Tilt(attitude).transpose() * Eigen::Vector3d::UnitZ();
}

}  // namespace

Eigen::Matrix3d Tilt(const Attitude& attitude) {
  return RotX(attitude.roll_rad) * RotY(attitude.pitch_rad);
}

Attitude AttitudeOf(const ImuSample& imu) {
  const AxleAttitude axle = ToAxleAttitude(RotationOf(imu));
  return {axle.roll, axle.pitch};
}

Eigen::Matrix3d RotationOf(const ImuSample& imu) {
  return ToRotation(RollPitchYaw{imu.roll_rad, imu.pitch_rad, imu.yaw_rad});
}

double HeadingOf(const ImuSample& imu) { return ToAxleAttitude(RotationOf(imu)).heading; }

void GroundSlope::Take(const Pose3& X_RB, double sigma_rad, const ImuSample& imu,
                       const Pose3& X_DB) {
  const Eigen::Matrix3d R_DR = X_DB.R * X_RB.R.transpose();
  const Eigen::Vector3d up_R = UpInBody(AttitudeOf(imu));
  const double weight = 1.0 / (Square(sigma_rad) + Square(kStationSigma));
  information_ += weight * Eigen::Matrix2d::Identity();
  weighted_ += weight * (R_DR * up_R).head<2>();
  // The axle lies along the ground, so the roll is the slope across the heading.
  const double heading = ToAxleAttitude(R_DR).heading;
  const Eigen::Vector2d across(-std::sin(heading), std::cos(heading));
  information_ += across * across.transpose() / Square(kRollSigma);
  weighted_ += across * up_R.y() / Square(kRollSigma);

  lean_D_ = information_.inverse() * weighted_;
  const bool slopes = lean_D_.norm() > std::sin(kLeastSlope) && lean_D_.norm() < 1.0 &&
                      lean_D_.dot(weighted_) > Square(kSigmas);
  up_D_ = Eigen::Vector3d::UnitZ();
  if (slopes) up_D_ << lean_D_, std::sqrt(1.0 - lean_D_.squaredNorm());
}

Attitude GroundSlope::Against(const ImuSample& imu, double heading_rad) const {
  const Attitude against_gravity = AttitudeOf(imu);
  if (level()) return against_gravity;
  // RotX(roll) RotY(pitch) takes gravity's up in the body to where the slope has it.
  const Eigen::Vector3d up_R = UpInBody(against_gravity);
  const Eigen::Vector3d up = RotZ(-heading_rad) * up_D_;
  const double share = up_R.y() / std::hypot(up.y(), up.z());
  const double roll = std::asin(std::clamp(share, -1.0, 1.0)) - std::atan2(up.y(), up.z());
  const Eigen::Vector3d turned = RotX(-roll) * up;
  return {roll, WrapPi(std::atan2(turned.x(), turned.z()) - std::atan2(up_R.x(), up_R.z()))};
}

Eigen::Vector3d UpOfStation(const Attitude& attitude, bool slope_known) {
  const bool rolled = !slope_known && std::abs(attitude.roll_rad) > kSlopeRoll;
  return UpInBody({rolled ? 0.0 : attitude.roll_rad, attitude.pitch_rad});
}

}  // namespace dockyard::axel
