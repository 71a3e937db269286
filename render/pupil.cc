#include "render/pupil.h"

#include <cmath>

namespace dockyard {

RayEnds::RayEnds(const Scene& scene, const Pose3& X_WC) {
  constexpr double kMargin_m = 0.02;  // so that no pixel has its corners on both sides of the edge
  const BoardView& board = scene.board;
  X_BC_ = Inverse(board.X_WB) * X_WC;
  if (board.board.width_m > 0.0 && board.board.height_m > 0.0) {
    half_width_ = 0.5 * board.board.width_m + kMargin_m;
    half_height_ = 0.5 * board.board.height_m + kMargin_m;
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
  if (half_width_ > 0.0) {
    const Eigen::Vector3d o_B = X_BC_ * o, d_B = X_BC_.R * d;
    const double t = -o_B.z() / d_B.z();
    const Eigen::Vector3d p_B = o_B + t * d_B;
    if (t > 0.02 && std::abs(p_B.x()) < half_width_ && std::abs(p_B.y()) < half_height_) {
      return at(t);
    }
  }
  const double t = -(height_ + up_C_.dot(o)) / up_C_.dot(d);
  return t > 0.02 && std::isfinite(t) ? at(t) : tan;
}

}  // namespace dockyard
