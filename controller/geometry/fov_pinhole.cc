#include <cmath>

#include "controller/geometry/lens.h"

namespace dockyard {
namespace {

/// r' / r, and its derivative by r over r.
struct Ratio {
  double value = 0.0, slope_over_r = 0.0;
};

Ratio RatioAt(double w_rad, double r) {
  const double c = 2.0 * std::tan(0.5 * w_rad), x = c * r, x2 = x * x;
  // atan(x) / x and its derivative over x; near the axis by their series.
  if (x < 1e-2) {
    const double ratio = 1.0 - x2 * (1.0 / 3.0 - x2 * (1.0 / 5.0 - x2 * (1.0 / 7.0 - x2 / 9.0)));
    const double slope = -2.0 / 3.0 + x2 * (4.0 / 5.0 - x2 * (6.0 / 7.0 - x2 * 8.0 / 9.0));
    return {c / w_rad * ratio, c * c * c / w_rad * slope};
  }
  const double ratio = std::atan(x) / x;
  return {c / w_rad * ratio, c * c * c / w_rad * (1.0 / (1.0 + x2) - ratio) / x2};
}

}  // namespace

std::optional<Eigen::Vector2d> FovPinhole::Project(const Eigen::Vector3d& p,
                                                   PixelJacobian* J) const {
  if (!(p.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d m = p.head<2>() / p.z();
  const Ratio ratio = RatioAt(w_rad, m.norm());
  if (J) {
    PixelJacobian by_p;
    by_p << 1.0, 0.0, -m.x(), 0.0, 1.0, -m.y();
    const Eigen::Matrix2d M =
        ratio.value * Eigen::Matrix2d::Identity() + ratio.slope_over_r * m * m.transpose();
    *J = Eigen::Vector2d(fx, fy).asDiagonal() * M * by_p / p.z();
  }
  return Eigen::Vector2d(fx * ratio.value * m.x() + cx, fy * ratio.value * m.y() + cy);
}

LensRay FovPinhole::Ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d bent((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  const double r = bent.norm();
  if (r == 0.0) return {};
  // At a right angle of w r the ray lies in the image's plane: none comes from further out.
  const double angle = std::min(w_rad * r, 0.5 * kPi - 1e-9);
  const double out = std::tan(angle) / (2.0 * std::tan(0.5 * w_rad) * r);
  return {.direction = Eigen::Vector3d(out * bent.x(), out * bent.y(), 1.0).normalized()};
}

}  // namespace dockyard
