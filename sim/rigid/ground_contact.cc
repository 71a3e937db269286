#include "sim/rigid/ground_contact.h"

#include <algorithm>

#include "sim/base/hash.h"
#include "sim/rigid/ground_friction.h"

namespace dockyard {

Eigen::Vector3d GroundForce(const HeightGrid& ground, const GroundMaterial& material,
                            const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G, double dt_s,
                            GroundPoint& point) {
  const double below = ground.Height(p_G.x(), p_G.y()) - p_G.z();
  if (below <= 0.0) {
    point.bend_G.setZero();
    return Eigen::Vector3d::Zero();
  }
  const Eigen::Vector3d n = ground.Normal(p_G.x(), p_G.y());
  const double speed_out = v_G.dot(n);
  const double depth = below * n.z();
  const double borne = material.plate.force_n_per_m_n > 0.0
                           ? PressPlate(material.plate, depth, point.sunk_m)
                           : material.stiffness_n_per_m * depth;
  const double press = std::max(0.0, borne - material.damping_ns_per_m * speed_out);
  const Eigen::Vector3d v_along = v_G - speed_out * n;
  const GroundBristle bristle{material.stiffness_n_per_m, material.damping_ns_per_m};
  return press * n +
         GroundFriction(bristle, material.friction * press, n, v_along, dt_s, point.bend_G);
}

std::uint64_t HashPoint(std::uint64_t hash, const GroundPoint& point) {
  for (int i = 0; i < 3; ++i) hash = HashDouble(hash, point.bend_G[i]);
  return point.sunk_m == 0.0 ? hash : HashDouble(hash, point.sunk_m);
}

}  // namespace dockyard
