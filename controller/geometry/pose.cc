#include "controller/geometry/pose.h"

#include <algorithm>
#include <cmath>

namespace dockyard {

double WrapPi(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

Pose2 operator*(const Pose2& X_AB, const Pose2& X_BC) {
  const Eigen::Vector2d p = X_AB * Eigen::Vector2d(X_BC.x, X_BC.y);
  return {p.x(), p.y(), WrapPi(X_AB.heading + X_BC.heading)};
}

Eigen::Vector2d operator*(const Pose2& X_AB, const Eigen::Vector2d& p_BQ) {
  const double c = std::cos(X_AB.heading), s = std::sin(X_AB.heading);
  return {X_AB.x + c * p_BQ.x() - s * p_BQ.y(), X_AB.y + s * p_BQ.x() + c * p_BQ.y()};
}

Pose2 Inverse(const Pose2& X_AB) {
  const double c = std::cos(X_AB.heading), s = std::sin(X_AB.heading);
  return {-(c * X_AB.x + s * X_AB.y), -(-s * X_AB.x + c * X_AB.y), WrapPi(-X_AB.heading)};
}

Pose3 operator*(const Pose3& X_AB, const Pose3& X_BC) {
  return {X_AB.R * X_BC.R, X_AB.R * X_BC.p + X_AB.p};
}

Eigen::Vector3d operator*(const Pose3& X_AB, const Eigen::Vector3d& p_BQ) {
  return X_AB.R * p_BQ + X_AB.p;
}

Pose3 Inverse(const Pose3& X_AB) { return {X_AB.R.transpose(), -(X_AB.R.transpose() * X_AB.p)}; }

Eigen::Matrix3d RotX(double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitX()).toRotationMatrix();
}
Eigen::Matrix3d RotY(double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
}
Eigen::Matrix3d RotZ(double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

Eigen::Matrix3d RotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  // Two mirrors: one that keeps a, then one that swaps a and b; both are perpendicular to the plane
  // of the two, so that the axis is perpendicular to both and the turn is the smallest.
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const auto mirror = [](const Eigen::Vector3d& normal) {
    return Eigen::Matrix3d(Eigen::Matrix3d::Identity() - 2.0 * normal * normal.transpose());
  };
  if (a.dot(b) > 0.0) {  // the middle of both is far from zero
    const Eigen::Vector3d middle = (a + b).normalized();
    return mirror(middle) * mirror(a);
  }
  const Eigen::Vector3d aside = b - a.dot(b) * a;
  Eigen::Vector3d square = aside.norm() > 1e-14 ? aside.normalized() : a.unitOrthogonal();
  square = (square - a.dot(square) * a).normalized();
  return mirror((a - b).normalized()) * mirror(square);
}

RollPitchYaw ToRollPitchYaw(const Eigen::Matrix3d& R) {
  return {std::atan2(R(2, 1), R(2, 2)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)),
          std::atan2(R(1, 0), R(0, 0))};
}

Eigen::Matrix3d ToRotation(const RollPitchYaw& rpy) {
  return RotZ(rpy.yaw) * RotY(rpy.pitch) * RotX(rpy.roll);
}

Pose2 ToGround(const Pose3& X_AB) {
  return {X_AB.p.x(), X_AB.p.y(), std::atan2(X_AB.R(1, 0), X_AB.R(0, 0))};
}

Pose3 FromGround(const Pose2& X_AB, double z_m) {
  return {RotZ(X_AB.heading), Eigen::Vector3d(X_AB.x, X_AB.y, z_m)};
}

DockingCoords ToDockingCoords(const Pose2& X_DR) {
  return {std::hypot(X_DR.x, X_DR.y), std::atan2(X_DR.y, X_DR.x), WrapPi(X_DR.heading - kPi)};
}

Pose2 FromDockingCoords(const DockingCoords& at) {
  return {at.r * std::cos(at.alpha), at.r * std::sin(at.alpha), WrapPi(at.h + kPi)};
}

}  // namespace dockyard
