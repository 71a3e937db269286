// How a part as a whole sits off the place that its drawing gives it.
#pragma once

#include "controller/geometry/pose.h"

namespace dockyard {

/// The part's frame P turned about the part's middle by the mounting's R and shifted by its p, both
/// in the axes of the carrier C. Without a mounting X_CP itself, bit for bit.
inline Pose3 Mounted(const Pose3& X_CP, const Pose3& mounting, const Eigen::Vector3d& p_C_middle) {
  if (mounting.p.isZero(0.0) && mounting.R.isIdentity(0.0)) return X_CP;
  return {mounting.R * X_CP.R, p_C_middle + mounting.p + mounting.R * (X_CP.p - p_C_middle)};
}

}  // namespace dockyard
