// Between Bullet's vectors and ours.
#pragma once

#include <LinearMath/btTransform.h>

#include <Eigen/Geometry>

#include "controller/geometry/pose.h"

namespace dockyard {

inline btVector3 ToBullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Eigen::Vector3d FromBullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btMatrix3x3 ToBullet(const Eigen::Matrix3d& R) {
  return {R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)};
}
inline Eigen::Matrix3d FromBullet(const btMatrix3x3& R) {
  Eigen::Matrix3d M;
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) M(row, col) = R[row][col];
  }
  return M;
}
inline btTransform ToBullet(const Pose3& X) { return btTransform(ToBullet(X.R), ToBullet(X.p)); }
inline Pose3 FromBullet(const btTransform& X) {
  return {FromBullet(X.getBasis()), FromBullet(X.getOrigin())};
}

}  // namespace dockyard
