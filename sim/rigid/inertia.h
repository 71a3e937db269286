// Principal axes of a link: Bullet takes inertia about them.
#pragma once

#include <Eigen/Core>

#include "controller/geometry/pose.h"
#include "models/parts/link.h"

namespace dockyard {

struct PrincipalInertia {
  Pose3 X_LP;  // centre of mass and principal axes in the link
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();  // [kg m^2]
};

/// A link that is symmetric about its x-z plane gets axes with y kept exactly, so that mirrored
/// links have mirrored axes.
PrincipalInertia FindPrincipalInertia(const LinkModel& link);

}  // namespace dockyard
