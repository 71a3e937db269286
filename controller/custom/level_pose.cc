#include "controller/custom/level_pose.h"

#include <Eigen/Dense>
#include <cmath>

namespace dockyard::custom {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix63d = Eigen::Matrix<double, 6, 3>;

/// Small turn about x and y that would tilt an upright body like this; z is up.
Eigen::Vector2d TiltOf(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d up = R.col(2);
  const double sine = std::hypot(up.x(), up.y());
  if (sine < 1e-12) return {0.0, 0.0};
  return std::atan2(sine, up.z()) / sine * Eigen::Vector2d(-up.y(), up.x());
}

/// Covariance of the dock's place and small turn in H, from the board's in the camera.
Matrix6d InH(const Matrix6d& covariance, const Eigen::Matrix3d& R_HC,
             const Eigen::Vector3d& p_BD_H) {
  Matrix6d J = Matrix6d::Zero();
  J.topLeftCorner<3, 3>() = R_HC;
  J.topRightCorner<3, 3>() = -CrossMatrix(p_BD_H) * R_HC;
  J.bottomRightCorner<3, 3>() = R_HC;
  return J * covariance * J.transpose();
}

}  // namespace

PlacedDock PlaceDock(const PoseBranch& branch, const Pose3& X_RC, const Pose3& X_DB,
                     double height_m, const ImuSample& imu, const FloorSpread& spread) {
  const Pose3 X_HC =
      Pose3{RotY(imu.pitch_rad) * RotX(imu.roll_rad), Eigen::Vector3d::Zero()} * X_RC;
  const Pose3 X_HB = X_HC * branch.X_CB;
  const Pose3 X_HD = X_HB * Inverse(X_DB);
  const Matrix6d C = InH(branch.covariance, X_HC.R, X_HD.p - X_HB.p);

  // The floor as a measurement of z, and of the turns about x and y: rows 2, 3 and 4.
  const Eigen::Vector2d tilt = TiltOf(X_HD.R);
  const Eigen::Vector3d error(X_HD.p.z() + height_m, tilt.x(), tilt.y());
  const Eigen::Vector3d sigma(spread.height_m, spread.tilt_rad, spread.tilt_rad);
  Eigen::Matrix3d S = C.block<3, 3>(2, 2);
  S.diagonal() += sigma.cwiseAbs2();
  const auto solver = S.ldlt();
  const Matrix63d gain = solver.solve(C.middleRows<3>(2)).transpose();
  const Eigen::Matrix<double, 6, 1> change = -gain * error;
  const Matrix6d rest = C - gain * S * gain.transpose();

  PlacedDock placed;
  placed.floor_misfit = error.dot(solver.solve(error));
  placed.X_HD = {X_HD.p.x() + change(0), X_HD.p.y() + change(1),
                 WrapPi(ToRollPitchYaw(X_HD.R).yaw + change(5))};
  const int kept[3] = {0, 1, 5};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) placed.covariance(i, j) = rest(kept[i], kept[j]);
  }
  const Eigen::Vector2d sight = X_HD.p.head<2>() - X_HC.p.head<2>();
  const Eigen::Vector2d across(-sight.y(), sight.x());
  placed.lasting.topLeftCorner<2, 2>() =
      std::pow(spread.range_share, 2) * sight * sight.transpose() +
      std::pow(spread.aside_rad, 2) * across * across.transpose() +
      std::pow(spread.place_m, 2) * Eigen::Matrix2d::Identity();
  placed.lasting(2, 2) = std::pow(spread.heading_rad, 2);
  placed.covariance += placed.lasting;
  return placed;
}

}  // namespace dockyard::custom
