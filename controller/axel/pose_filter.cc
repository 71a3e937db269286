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
          ToAxleAttitude(R_DH).heading, Eigen::Vector3d::Zero()};
}

Eigen::Vector3d FixVariance(const Eigen::Vector3d& p_RB,
                            const Eigen::Matrix<double, 6, 6>& covariance) {
  const double range = std::max(p_RB.head<2>().norm(), 1e-3);
  const Eigen::Vector2d towards = p_RB.head<2>() / range, aside(-towards.y(), towards.x());
  const Eigen::Matrix2d place = covariance.topLeftCorner<2, 2>();
  return {towards.dot(place * towards), aside.dot(place * aside) / Square(range), covariance(5, 5)};
}

Pose2 PoseOf(const BoardFix& fix, const Pose3& X_DB) {
  const double towards = fix.heading_rad + fix.bearing_rad;
  return {X_DB.p.x() - fix.range_m * std::cos(towards),
          X_DB.p.y() - fix.range_m * std::sin(towards), WrapPi(fix.heading_rad)};
}

struct PoseFilter::Innovation {
  Eigen::Vector3d residual;
  Eigen::Matrix<double, 3, kStates> H;
  Eigen::Matrix3d S;
};

void PoseFilter::Predict(const Motion& motion, double seconds, const GroundForce& force,
                         bool free) {
  if (!located_) return;
  const double rolled = motion.length_m, way = std::abs(rolled);
  const double left = way * slip().Drift(force) + motion.lean_m;
  const double length = free ? rolled : slip().Way(rolled, force);
  const Pose2 before = pose(), along = Advance(before, Arc{length, motion.turn_rad});
  const double mean = before.heading + 0.5 * motion.turn_rad;
  const Eigen::Vector2d to_left(-std::sin(mean), std::cos(mean));
  const Eigen::Vector2d p = Eigen::Vector2d(along.x, along.y) + left * to_left;
  Matrix F = Matrix::Identity();
  F(0, 2) = -(p.y() - before.y);
  F(1, 2) = p.x() - before.x;
  F.block<2, 1>(0, 4) = way * force.slope * to_left;
  F.block<2, 1>(0, 5) = way * force.tether * to_left;
  const Eigen::Vector2d ahead(std::cos(before.heading), std::sin(before.heading));
  if (!free) {
    F.block<2, 1>(0, 6) = -rolled * ahead;
    F.block<2, 1>(0, 7) = way * force.ahead * ahead;
  }
  const Eigen::Vector2d aside(-ahead.y(), ahead.x());
  Matrix Q = Matrix::Zero();
  Q.topLeftCorner<2, 2>() = way * (Square(noise_.along_m_per_sqrt_m) * ahead * ahead.transpose() +
                                   Square(noise_.across_m_per_sqrt_m) * aside * aside.transpose());
  Q(2, 2) =
      Square(noise_.heading_rad_per_sqrt_m) * way + Square(noise_.heading_rad_per_sqrt_s) * seconds;
  Q(4, 4) = Q(5, 5) = Q(7, 7) = Square(noise_.slip_per_sqrt_m) * way;
  Q(6, 6) = Square(noise_.rolling_per_sqrt_m) * way;
  Q(8, 8) = Square(noise_.drum_per_sqrt_m) * way;
  P_ = F * P_ * F.transpose() + Q;
  state_.head<3>() << p.x(), p.y(), along.heading;
}

Eigen::Vector3d PoseFilter::VarianceOf(const BoardFix& fix) const {
  const Eigen::Vector3d floor(noise_.range_floor_m, noise_.bearing_rad,
                              noise_.board_heading_floor_rad);
  if (fix.variance.minCoeff() > 0.0) return floor.cwiseAbs2() + fix.variance;
  return {Square(noise_.range_floor_m + noise_.range_m_per_m2 * Square(fix.range_m)),
          Square(noise_.bearing_rad),
          Square(noise_.board_heading_floor_rad + noise_.board_heading_rad_per_m * fix.range_m)};
}

PoseFilter::Innovation PoseFilter::Compare(const BoardFix& fix) const {
  const double dx = X_DB_.p.x() - state_.x(), dy = X_DB_.p.y() - state_.y();
  const double square = std::max(dx * dx + dy * dy, 1e-6), range = std::sqrt(square);
  Innovation at;
  at.residual << fix.range_m - range, WrapPi(fix.bearing_rad - (std::atan2(dy, dx) - state_.z())),
      WrapPi(fix.heading_rad - state_.z());
  at.H.setZero();
  at.H.leftCols<3>() << -dx / range, -dy / range, 0.0,  //
      dy / square, -dx / square, -1.0,                  //
      0.0, 0.0, 1.0;
  at.S = at.H * P_ * at.H.transpose();
  at.S.diagonal() += VarianceOf(fix);
  return at;
}

bool PoseFilter::Fits(const BoardFix& fix) const {
  if (!located_) return true;
  const Innovation at = Compare(fix);
  return at.residual.dot(at.S.inverse() * at.residual) <= noise_.gate;
}

// A change of the states, and the share of their errors that is left.
void PoseFilter::Take(const Vector& change, const Matrix& kept) {
  state_ += change;
  state_.z() = WrapPi(state_.z());
  // Beyond this a sighting was wrong: side forces neither push uphill nor move a wheel like ice.
  constexpr double kMostSlip = 3.5;
  auto slip = state_.segment<4>(4);
  slip = slip.cwiseMax(0.0).cwiseMin(kMostSlip);
  P_ = (kept * P_).eval();
  P_ = (0.5 * (P_ + P_.transpose())).eval();
}

void PoseFilter::Correct(const BoardFix& fix) {
  if (!located_) return Restart(fix);
  const Innovation at = Compare(fix);
  const Eigen::Matrix<double, kStates, 3> K = P_ * at.H.transpose() * at.S.inverse();
  Take(K * at.residual, Matrix::Identity() - K * at.H);
}

void PoseFilter::Restart(const BoardFix& fix) {
  const Pose2 pose = PoseOf(fix, X_DB_);
  state_.head<4>() << pose.x, pose.y, pose.heading, 0.0;
  const Eigen::Matrix<double, 5, 5> kept = P_.bottomRightCorner<5, 5>();  // what is not of the pose
  P_ = kUnknown * Matrix::Identity();
  P_.bottomRightCorner<5, 5>() = kept;
  located_ = true;
  Correct(fix);
}

void PoseFilter::CorrectByTether(double reeled_m, double elevation_rad) {
  if (!located_) return;
  const double expected = ExposedTether(geometry_, pose(), elevation_rad);
  Eigen::Matrix<double, 1, kStates> H = Eigen::Matrix<double, 1, kStates>::Zero();
  H.leftCols<4>() << -ExposedTetherSlope(geometry_, pose(), elevation_rad).transpose(), 1.0;
  H(8) = -reeled_m;
  // Measured: the drum's count. Whole length less drum less path should be zero.
  const double residual = expected - ExposedLength(reeled_m);
  const double S = H * P_ * H.transpose() + Square(noise_.tether_m);
  const Vector K = P_ * H.transpose() / S;
  Take(K * residual, Matrix::Identity() - K * H);
}

}  // namespace dockyard::axel
