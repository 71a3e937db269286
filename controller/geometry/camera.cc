#include "controller/geometry/camera.h"

#include <cmath>

namespace dockyard {
namespace {

constexpr double kMaxTheta = 120.0 * kPi / 180.0;

double Rho(const std::array<double, 4>& k, double theta) {
  const double t2 = theta * theta;
  return theta * (1.0 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
}

double RhoDerivative(const std::array<double, 4>& k, double theta) {
  const double t2 = theta * theta;
  return 1.0 + t2 * (3.0 * k[0] + t2 * (5.0 * k[1] + t2 * (7.0 * k[2] + t2 * 9.0 * k[3])));
}

}  // namespace

std::optional<Eigen::Vector2d> FisheyeCamera::Project(const Eigen::Vector3d& p_C) const {
  const double radial = std::hypot(p_C.x(), p_C.y());
  const double theta = std::atan2(radial, p_C.z());
  if (theta > kMaxTheta || (radial == 0.0 && p_C.z() <= 0.0)) return std::nullopt;
  if (radial == 0.0) return Eigen::Vector2d(cx, cy);
  const double scale = Rho(k, theta) / radial;
  return Eigen::Vector2d(fx * scale * p_C.x() + cx, fy * scale * p_C.y() + cy);
}

Eigen::Vector3d FisheyeCamera::Ray(const Eigen::Vector2d& pixel) const {
  const double mx = (pixel.x() - cx) / fx, my = (pixel.y() - cy) / fy;
  const double rho = std::hypot(mx, my);
  if (rho == 0.0) return Eigen::Vector3d::UnitZ();
  double theta = std::min(rho, kMaxTheta);
  for (int i = 0; i < 20; ++i) {
    const double slope = RhoDerivative(k, theta);
    if (!(slope > 1e-6)) break;  // beyond the polynomial's peak no pixel has a ray
    const double step = (Rho(k, theta) - rho) / slope;
    theta = std::min(theta - step, kMaxTheta);
    if (std::abs(step) < 1e-14) break;
  }
  const double s = std::sin(theta) / rho;
  return {s * mx, s * my, std::cos(theta)};
}

bool FisheyeCamera::Sees(const Eigen::Vector2d& pixel, double margin_px) const {
  return pixel.x() >= -0.5 + margin_px && pixel.x() <= width - 0.5 - margin_px &&
         pixel.y() >= -0.5 + margin_px && pixel.y() <= height - 0.5 - margin_px;
}

FisheyeCamera EquidistantCamera(int width, int height, double horizontal_fov_rad) {
  const double f = width / horizontal_fov_rad;
  return {.width = width,
          .height = height,
          .fx = f,
          .fy = f,
          .cx = 0.5 * (width - 1),
          .cy = 0.5 * (height - 1)};
}

}  // namespace dockyard
