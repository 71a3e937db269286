#include "render/pupil.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dockyard {

RayEnds::RayEnds(const Scene& scene, const Pose3& X_WC) {
  constexpr double kMargin_m = 0.02;  // so that no pixel has its corners on both sides of the edge
  for (const BoardView& view : scene.boards) {
    plates_.push_back({.X_BC = Inverse(view.X_WB) * X_WC,
                       .half_width = 0.5 * view.board.width_m + kMargin_m,
                       .half_height = 0.5 * view.board.height_m + kMargin_m});
  }
  const Pose3 X_GC = Inverse(scene.ground.X_WG) * X_WC;
  up_C_ = X_GC.R.row(2).transpose();
  height_ = X_GC.p.z();
}

Eigen::Vector2d RayEnds::Seen(const Eigen::Vector3d& o, const Eigen::Vector2d& tan) const {
  const Eigen::Vector3d d(tan.x(), tan.y(), 1.0);
  const auto at = [&](double t) -> Eigen::Vector2d {
    return (o.head<2>() + t * tan) / (o.z() + t);
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (const Plate& plate : plates_) {
    const Eigen::Vector3d o_B = plate.X_BC * o, d_B = plate.X_BC.R * d;
    const double t = -o_B.z() / d_B.z();
    const Eigen::Vector3d p_B = o_B + t * d_B;
    const bool hit =
        t > 0.02 && std::abs(p_B.x()) < plate.half_width && std::abs(p_B.y()) < plate.half_height;
    if (hit) nearest = std::min(nearest, t);
  }
  if (std::isfinite(nearest)) return at(nearest);
  const double t = -(height_ + up_C_.dot(o)) / up_C_.dot(d);
  return t > 0.02 && std::isfinite(t) ? at(t) : tan;
}

}  // namespace dockyard
