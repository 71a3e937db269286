// Coulomb friction of a point on the ground, on a bristle that holds it at rest.
#pragma once

#include <Eigen/Core>

namespace dockyard {

/// Of the bristle, in the ground's plane.
struct GroundBristle {
  double stiffness_n_per_m = 0.0, damping_ns_per_m = 0.0;
};

/// Friction of at most most_n; advances the bristle's bend by one step. v_along_G: of the point in
/// the ground's plane with normal n_G.
Eigen::Vector3d GroundFriction(const GroundBristle& bristle, double most_n,
                               const Eigen::Vector3d& n_G, const Eigen::Vector3d& v_along_G,
                               double dt_s, Eigen::Vector3d& bend_G);

}  // namespace dockyard
