#include <cmath>

#include "controller/geometry/lens.h"

namespace dockyard {
namespace {

double Rho(const std::array<double, 4>& k, double theta) {
  const double t2 = theta * theta;
  return theta * (1.0 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
}

double RhoDerivative(const std::array<double, 4>& k, double theta) {
  const double t2 = theta * theta;
  return 1.0 + t2 * (3.0 * k[0] + t2 * (5.0 * k[1] + t2 * (7.0 * k[2] + t2 * 9.0 * k[3])));
}

}  // namespace

std::optional<Eigen::Vector2d> KannalaBrandt::Project(const Eigen::Vector3d& p,
                                                      PixelJacobian* J) const {
  const double radial = std::hypot(p.x(), p.y());
  const double theta = std::atan2(radial, p.z());
  if (theta > kWidestView_rad || (radial == 0.0 && p.z() <= 0.0)) return std::nullopt;
  const double slope = RhoDerivative(k, theta);
  if (!(slope > 0.0)) return std::nullopt;  // beyond the polynomial's peak, which nothing passes
  if (radial == 0.0) {
    if (J) *J << fx / p.z(), 0.0, 0.0, 0.0, fy / p.z(), 0.0;
    return Eigen::Vector2d(cx, cy);
  }
  const double scale = Rho(k, theta) / radial;
  if (J) {
    const double r2 = radial * radial, d2 = r2 + p.z() * p.z();
    const double along = (slope * p.z() / d2 - scale) / r2;  // (d scale / d radial) / radial
    const double deep = -slope / d2;                         // d scale / d z
    const double x = p.x(), y = p.y();
    *J << fx * (scale + along * x * x), fx * along * x * y, fx * deep * x,  //
        fy * along * x * y, fy * (scale + along * y * y), fy * deep * y;
  }
  return Eigen::Vector2d(fx * scale * p.x() + cx, fy * scale * p.y() + cy);
}

LensRay KannalaBrandt::Ray(const Eigen::Vector2d& pixel) const {
  const double mx = (pixel.x() - cx) / fx, my = (pixel.y() - cy) / fy;
  const double rho = std::hypot(mx, my);
  if (rho == 0.0) return {};
  double theta = std::min(rho, kWidestView_rad);
  for (int i = 0; i < 20; ++i) {
    const double slope = RhoDerivative(k, theta);
    if (!(slope > 1e-6)) break;  // beyond the polynomial's peak no pixel has a ray
    const double step = (Rho(k, theta) - rho) / slope;
    theta = std::min(theta - step, kWidestView_rad);
    if (std::abs(step) < 1e-14) break;
  }
  const double s = std::sin(theta) / rho;
  return {.direction = {s * mx, s * my, std::cos(theta)}};
}

}  // namespace dockyard
