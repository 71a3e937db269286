// A face as the rover has it before itself, and the tool against its normal.
#pragma once

#include <Eigen/Core>

#include "controller/rocky7/mast.h"

namespace dockyard::rocky7 {

/// A face's point and its outward normal, in R.
struct FaceAt {
  Eigen::Vector3d p_RT{0, 0, 0}, normal_R{-1, 0, 0};
  Eigen::Matrix3d bend_R = Eigen::Matrix3d::Zero();  // of the normal, as FacePlane has it
};
/// As seen from R at a pose X_RN.
FaceAt SeenFrom(const Pose2& X_RN, const FaceAt& face);

/// The angle between the tool's axis and the inward normal where the mast places the instrument
/// from here; pi where it does not reach the point.
double ToolOff(const NominalMast& mast, const FaceAt& face);

}  // namespace dockyard::rocky7
