
#include "controller/geometry/lens.h"
#include "controller/geometry/rational_distortion.h"

namespace dockyard {

std::optional<Eigen::Vector2d> RationalPinhole::Project(const Eigen::Vector3d& p,
                                                        PixelJacobian* J) const {
  if (!(p.z() > 0.0)) return std::nullopt;
  const RationalDistortion distortion{k, p1, p2};
  Eigen::Matrix2d M;
  const Eigen::Vector2d m = p.head<2>() / p.z();
  const Eigen::Vector2d d = distortion.Distort(m, M);
  if (!distortion.Holds(m, M)) return std::nullopt;
  if (J) {
    PixelJacobian by_p;
    by_p << 1.0, 0.0, -m.x(), 0.0, 1.0, -m.y();
    *J = Eigen::Vector2d(fx, fy).asDiagonal() * M * by_p / p.z();
  }
  return Eigen::Vector2d(fx * d.x() + cx, fy * d.y() + cy);
}

LensRay RationalPinhole::Ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d wanted((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  Eigen::Vector2d edge = Eigen::Vector2d::Zero();
  const Eigen::Vector2d m = RationalDistortion{k, p1, p2}.Undistort(wanted, &edge).value_or(edge);
  return {.direction = Eigen::Vector3d(m.x(), m.y(), 1.0).normalized()};
}

}  // namespace dockyard
