// Where a rigid link is and how it moves, in the site frame G.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "controller/geometry/pose.h"

namespace dockyard {

struct LinkMotion {
  Pose3 X_GL;
  Eigen::Vector3d v_GL_G = Eigen::Vector3d::Zero();  // of the link frame's origin [m/s]
  Eigen::Vector3d w_GL_G = Eigen::Vector3d::Zero();  // [rad/s]

  /// Velocity of the link's material point that is at p_G now.
  Eigen::Vector3d VelocityAt(const Eigen::Vector3d& p_G) const {
    return v_GL_G + w_GL_G.cross(p_G - X_GL.p);
  }
};

}  // namespace dockyard
