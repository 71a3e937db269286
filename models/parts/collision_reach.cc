#include "models/parts/collision_reach.h"

#include <algorithm>
#include <cmath>

namespace dockyard {

double ReachAlongX(const Collision& collision) {
  const Eigen::RowVector3d x_G = collision.X_LG.R.row(0);
  double reach = 0.0;
  if (const auto* box = std::get_if<BoxShape>(&collision.shape)) {
    reach = 0.5 * x_G.cwiseAbs().dot(box->size_m.transpose());
  } else if (const auto* cylinder = std::get_if<CylinderShape>(&collision.shape)) {
    reach = 0.5 * std::abs(x_G.z()) * cylinder->length_m +
            std::hypot(x_G.x(), x_G.y()) * cylinder->radius_m;
  } else if (const auto* sphere = std::get_if<SphereShape>(&collision.shape)) {
    reach = sphere->radius_m;
  } else if (const auto* hull = std::get_if<HullShape>(&collision.shape)) {
    reach = -1e9;
    for (const Eigen::Vector3d& p : hull->points) reach = std::max(reach, x_G.dot(p));
  } else if (const auto* turned = std::get_if<TurnedShape>(&collision.shape)) {
    reach = -1e9;
    for (const Eigen::Vector2d& p : turned->profile_m) {
      reach = std::max(reach, x_G.z() * p.x() + std::hypot(x_G.x(), x_G.y()) * p.y());
    }
  }
  return collision.X_LG.p.x() + reach;
}

}  // namespace dockyard
