// Principal axes of a link: Bullet's bodies, with which tests compare ours, take inertia about
// them.
#pragma once

#include <LinearMath/btQuaternion.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "controller/geometry/decompositions.h"
#include "controller/geometry/pose.h"
#include "models/parts/link.h"

namespace dockyard {

struct PrincipalInertia {
  Pose3 X_LP;  // centre of mass and principal axes in the link
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();  // [kg m^2]
};

/// A link that is symmetric about its x-z plane gets axes with y kept exactly, so that mirrored
/// links have mirrored axes.
inline PrincipalInertia FindPrincipalInertia(const LinkModel& link) {
  const Eigen::Matrix3d& I = link.I_LCom_L;
  PrincipalInertia principal;
  principal.X_LP.p = link.p_LoCom_L;
  const double tiny = 1e-12 * I.trace();
  if (std::abs(I(0, 1)) <= tiny && std::abs(I(1, 2)) <= tiny) {
    if (std::abs(I(0, 2)) > tiny) {
      principal.X_LP.R = RotY(0.5 * std::atan2(-2.0 * I(0, 2), I(0, 0) - I(2, 2)));
    }
    const Eigen::Matrix3d D = principal.X_LP.R.transpose() * I * principal.X_LP.R;
    principal.moments = D.diagonal();
    return principal;
  }
  const SymmetricEigen3 eigen = EigenOfSymmetric(I);
  principal.X_LP.R = eigen.vectors;
  if (principal.X_LP.R.determinant() < 0.0) principal.X_LP.R.col(2) *= -1.0;
  principal.moments = eigen.values;
  return principal;
}

inline btQuaternion ToQuaternion(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return {q.x(), q.y(), q.z(), q.w()};
}

}  // namespace dockyard
