#include "sim/rigid/ground_friction.h"

namespace dockyard {

Eigen::Vector3d GroundFriction(const GroundBristle& bristle, double most_n,
                               const Eigen::Vector3d& n_G, const Eigen::Vector3d& v_along_G,
                               double dt_s, Eigen::Vector3d& bend_G) {
  bend_G += v_along_G * dt_s;
  bend_G -= bend_G.dot(n_G) * n_G;
  const double held = bristle.stiffness_n_per_m * bend_G.norm();
  if (held > most_n) bend_G *= most_n / held;
  Eigen::Vector3d drag = -bristle.stiffness_n_per_m * bend_G - bristle.damping_ns_per_m * v_along_G;
  const double drag_size = drag.norm();
  if (drag_size > most_n) drag *= most_n / drag_size;
  return drag;
}

}  // namespace dockyard
