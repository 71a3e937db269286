#include <Eigen/LU>

#include "controller/geometry/lens.h"

namespace dockyard {
namespace {

/// Distorted point and, in M, its derivative by the undistorted one.
Eigen::Vector2d Distort(const BrownPinhole& lens, const Eigen::Vector2d& m, Eigen::Matrix2d& M) {
  const double x = m.x(), y = m.y(), r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double slope = lens.k1 + r2 * (2.0 * lens.k2 + r2 * 3.0 * lens.k3);  // d radial / d r^2
  const double p1 = lens.p1, p2 = lens.p2;
  const double mixed = 2.0 * x * y * slope + 2.0 * p1 * x + 2.0 * p2 * y;
  M << radial + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x, mixed,  //
      mixed, radial + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x;
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

/// Whether the image is not folded here: further out the polynomial folds back.
bool Unfolded(const Eigen::Matrix2d& M) { return M.determinant() > 0.0 && M.trace() > 0.0; }

}  // namespace

std::optional<Eigen::Vector2d> BrownPinhole::Project(const Eigen::Vector3d& p,
                                                     PixelJacobian* J) const {
  if (!(p.z() > 0.0)) return std::nullopt;
  Eigen::Matrix2d M;
  const Eigen::Vector2d m = p.head<2>() / p.z();
  const Eigen::Vector2d d = Distort(*this, m, M);
  if (!Unfolded(M)) return std::nullopt;
  if (J) {
    PixelJacobian by_p;
    by_p << 1.0, 0.0, -m.x(), 0.0, 1.0, -m.y();
    *J = Eigen::Vector2d(fx, fy).asDiagonal() * M * by_p / p.z();
  }
  return Eigen::Vector2d(fx * d.x() + cx, fy * d.y() + cy);
}

LensRay BrownPinhole::Ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d wanted((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  Eigen::Vector2d m = wanted;
  Eigen::Matrix2d M;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector2d miss = Distort(*this, m, M) - wanted;
    // Strong barrel distortion folds the start: move it inwards until it unfolds.
    if (!Unfolded(M)) {
      m *= 0.8;
      continue;
    }
    const Eigen::Vector2d step = M.inverse() * miss;
    m -= step;
    if (step.norm() < 1e-15 * (1.0 + m.norm())) break;
  }
  return {.direction = Eigen::Vector3d(m.x(), m.y(), 1.0).normalized()};
}

}  // namespace dockyard
