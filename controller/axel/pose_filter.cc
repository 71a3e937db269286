#include "controller/axel/pose_filter.h"

#include <Eigen/LU>
#include <cmath>

#include "controller/geometry/axle_attitude.h"

namespace dockyard::axel {
namespace {

constexpr double kUnknown = 1e3;  // variance of an unknown [m^2, rad^2]

double Square(double x) { return x * x; }

}  // namespace

BoardFix LevelSighting(const Pose3& X_RB, const ImuSample& imu, const Pose3& X_DB,
                       const GroundSlope& ground) {
  const Eigen::Matrix3d R_DR = X_DB.R * X_RB.R.transpose();
  const Eigen::Matrix3d R_HR = Tilt(ground.Against(imu, ToAxleAttitude(R_DR).heading));
  const Pose3 X_HB{R_HR * X_RB.R, R_HR * X_RB.p};
  const Eigen::Matrix3d R_DH = X_DB.R * X_HB.R.transpose();
  return {std::hypot(X_HB.p.x(), X_HB.p.y()), std::atan2(X_HB.p.y(), X_HB.p.x()),
          ToAxleAttitude(R_DH).heading};
}

Pose2 PoseOf(const BoardFix& fix, const Pose3& X_DB) {
  const double towards = fix.heading_rad + fix.bearing_rad;
  return {X_DB.p.x() - fix.range_m * std::cos(towards),
          X_DB.p.y() - fix.range_m * std::sin(towards), WrapPi(fix.heading_rad)};
}

struct PoseFilter::Innovation {
  Eigen::Vector3d residual;
  Eigen::Matrix<double, 3, 4> H;
  Eigen::Matrix3d S;
};

void PoseFilter::Predict(const Motion& motion, double seconds) {
  if (!located_) return;
  const Arc arc{motion.length_m, motion.turn_rad};
  const Pose2 before = pose(), after = Advance(before, arc);
  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F(0, 2) = -(after.y - before.y);
  F(1, 2) = after.x - before.x;
  const double c = std::cos(before.heading), s = std::sin(before.heading);
  const double way = std::abs(motion.length_m);
  const double along = Square(noise_.along_m_per_sqrt_m) * way;
  const double across = Square(noise_.across_m_per_sqrt_m) * way;
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q(0, 0) = along * c * c + across * s * s;
  Q(1, 1) = along * s * s + across * c * c;
  Q(0, 1) = Q(1, 0) = (along - across) * c * s;
  Q(2, 2) =
      Square(noise_.heading_rad_per_sqrt_m) * way + Square(noise_.heading_rad_per_sqrt_s) * seconds;
  P_ = F * P_ * F.transpose() + Q;
  state_.head<3>() << after.x, after.y, after.heading;
}

PoseFilter::Innovation PoseFilter::Compare(const BoardFix& fix) const {
  const double dx = X_DB_.p.x() - state_.x(), dy = X_DB_.p.y() - state_.y();
  const double square = std::max(dx * dx + dy * dy, 1e-6), range = std::sqrt(square);
  Innovation at;
  at.residual << fix.range_m - range, WrapPi(fix.bearing_rad - (std::atan2(dy, dx) - state_.z())),
      WrapPi(fix.heading_rad - state_.z());
  at.H << -dx / range, -dy / range, 0.0, 0.0,  //
      dy / square, -dx / square, -1.0, 0.0,    //
      0.0, 0.0, 1.0, 0.0;
  const double sigma_range = noise_.range_floor_m + noise_.range_m_per_m2 * Square(fix.range_m);
  const double sigma_heading =
      noise_.board_heading_floor_rad + noise_.board_heading_rad_per_m * fix.range_m;
  const Eigen::Vector3d variance(Square(sigma_range), Square(noise_.bearing_rad),
                                 Square(sigma_heading));
  at.S = at.H * P_ * at.H.transpose();
  at.S.diagonal() += variance;
  return at;
}

bool PoseFilter::Fits(const BoardFix& fix) const {
  if (!located_) return true;
  const Innovation at = Compare(fix);
  return at.residual.dot(at.S.inverse() * at.residual) <= noise_.gate;
}

void PoseFilter::Correct(const BoardFix& fix) {
  if (!located_) return Restart(fix);
  const Innovation at = Compare(fix);
  const Eigen::Matrix<double, 4, 3> K = P_ * at.H.transpose() * at.S.inverse();
  state_ += K * at.residual;
  state_.z() = WrapPi(state_.z());
  P_ = (Eigen::Matrix4d::Identity() - K * at.H) * P_;
  P_ = (0.5 * (P_ + P_.transpose())).eval();
}

void PoseFilter::Restart(const BoardFix& fix) {
  const Pose2 pose = PoseOf(fix, X_DB_);
  state_ << pose.x, pose.y, pose.heading, 0.0;
  P_ = Eigen::Vector4d(kUnknown, kUnknown, kUnknown, kUnknown).asDiagonal();
  located_ = true;
  Correct(fix);
}

void PoseFilter::CorrectByTether(double reeled_m, double elevation_rad) {
  if (!located_) return;
  const double expected = ExposedTether(geometry_, pose(), elevation_rad);
  Eigen::RowVector4d H;
  H << -ExposedTetherSlope(geometry_, pose(), elevation_rad).transpose(), 1.0;
  // Measured: the drum's count. Whole length less drum less path should be zero.
  const double residual = -(state_(3) - reeled_m - expected);
  const double S = H * P_ * H.transpose() + Square(noise_.tether_m);
  const Eigen::Vector4d K = P_ * H.transpose() / S;
  state_ += K * residual;
  state_.z() = WrapPi(state_.z());
  P_ = ((Eigen::Matrix4d::Identity() - K * H) * P_).eval();
  P_ = (0.5 * (P_ + P_.transpose())).eval();
}

}  // namespace dockyard::axel
