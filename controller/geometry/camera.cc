#include "controller/geometry/camera.h"

#include <cmath>

namespace dockyard {
namespace {

/// Pixels (u, v) become (a u + b) for any lens.
void Map(Lens& lens, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  if (auto* cahvore = std::get_if<Cahvore>(&lens)) {
    cahvore->H = a.x() * cahvore->H + b.x() * cahvore->A;
    cahvore->V = a.y() * cahvore->V + b.y() * cahvore->A;
    return;
  }
  std::visit(
      [&](auto& l) {
        if constexpr (requires { l.fx; }) {
          l.fx *= a.x();
          l.fy *= a.y();
          l.cx = a.x() * l.cx + b.x();
          l.cy = a.y() * l.cy + b.y();
        }
      },
      lens);
}

/// Pixels per radian on the axis, for one along each side of the image plane.
struct AxisScale {
  double operator()(const Cahvore& l) const { return 1.0 + l.R[0]; }
  double operator()(const DoubleSphere& l) const { return 1.0 / (1.0 + l.xi); }
  double operator()(const Omni& l) const { return 1.0 / (1.0 + l.xi); }
  double operator()(const FovPinhole& l) const { return 2.0 * std::tan(0.5 * l.w_rad) / l.w_rad; }
  template <typename L>
  double operator()(const L&) const {
    return 1.0;
  }
};

/// A radial term of the lens moved by `by`; the focal length on the axis stays.
void BendBy(DoubleSphere& lens, double by) { lens.alpha += by; }
void BendBy(Eucm& lens, double by) { lens.alpha += by; }
void BendBy(FovPinhole& lens, double by) {
  const double before = AxisScale()(lens);
  lens.w_rad += by;
  const double focal = before / AxisScale()(lens);
  lens.fx *= focal;
  lens.fy *= focal;
}

/// The term moved until the pixel of the direction lies shift_px further out: Newton's first step.
template <typename L>
void BendUntil(L& lens, const Eigen::Vector3d& ray, double shift_px) {
  constexpr double kStep = 1e-5;
  L more = lens, less = lens;
  BendBy(more, kStep);
  BendBy(less, -kStep);
  const auto far = more.Project(ray, nullptr), near = less.Project(ray, nullptr);
  if (!far || !near) return;
  // `ray` lies to the left of the axis: outwards is to smaller u.
  const double slope = (near->x() - far->x()) / (2.0 * kStep);
  if (slope != 0.0) BendBy(lens, shift_px / slope);
}

}  // namespace

std::optional<Eigen::Vector2d> Camera::Project(const Eigen::Vector3d& p_C) const {
  return std::visit([&](const auto& l) { return l.Project(p_C, nullptr); }, lens);
}

std::optional<Eigen::Vector2d> Camera::Project(const Eigen::Vector3d& p_C, PixelJacobian& J) const {
  return std::visit([&](const auto& l) { return l.Project(p_C, &J); }, lens);
}

LensRay Camera::Ray(const Eigen::Vector2d& pixel) const {
  return std::visit([&](const auto& l) { return l.Ray(pixel); }, lens);
}

bool Camera::HasRay(const Eigen::Vector2d& pixel) const {
  const LensRay ray = Ray(pixel);
  const auto back = Project(ray.origin + ray.direction);
  return back && (*back - pixel).norm() < 1e-6;
}

bool Camera::Sees(const Eigen::Vector2d& pixel, double margin_px) const {
  return pixel.x() >= -0.5 + margin_px && pixel.x() <= width - 0.5 - margin_px &&
         pixel.y() >= -0.5 + margin_px && pixel.y() <= height - 0.5 - margin_px;
}

Eigen::Vector2d Camera::focal_px() const {
  const double scale = std::visit(AxisScale(), lens);
  return std::visit(
      [&](const auto& l) -> Eigen::Vector2d {
        if constexpr (requires { l.fx; }) {
          return {scale * l.fx, scale * l.fy};
        } else {
          const CahvScales scales = ScalesOf(l);
          return scale * Eigen::Vector2d(scales.hs, scales.vs);
        }
      },
      lens);
}

Eigen::Vector2d Camera::centre_px() const {
  constexpr double kFar_m = 1e6;  // a pupil's centimetre is then negligible
  const auto pixel = Project({0.0, 0.0, kFar_m});
  return pixel ? *pixel : Eigen::Vector2d(0.5 * (width - 1), 0.5 * (height - 1));
}

Camera EquidistantCamera(int width, int height, double horizontal_fov_rad) {
  const double f = width / horizontal_fov_rad;
  return {.width = width,
          .height = height,
          .lens = KannalaBrandt{
              .fx = f, .fy = f, .cx = 0.5 * (width - 1), .cy = 0.5 * (height - 1), .k = {}}};
}

Camera Adjusted(Camera camera, double focal_scale, const Eigen::Vector2d& centre_shift_px) {
  if (auto* cahvore = std::get_if<Cahvore>(&camera.lens)) {
    // H = hs H' + hc A with H' across A: scale hs alone.
    const CahvScales s = ScalesOf(*cahvore);
    const double a2 = cahvore->A.squaredNorm();
    const Eigen::Vector2d centre(s.hc / a2, s.vc / a2);
    const Eigen::Vector2d b = (1.0 - focal_scale) * centre + centre_shift_px;
    Map(camera.lens, {focal_scale, focal_scale}, b);
    return camera;
  }
  std::visit(
      [&](auto& l) {
        if constexpr (requires { l.fx; }) {
          l.fx *= focal_scale;
          l.fy *= focal_scale;
          l.cx += centre_shift_px.x();
          l.cy += centre_shift_px.y();
        }
      },
      camera.lens);
  return camera;
}

Camera Bent(Camera camera, double shift_px) {
  // The first free radial term of each model adds f c x^3, x being that model's own distance off
  // the axis at half the image's width.
  const double half = 0.5 * camera.width;
  const Eigen::Vector3d ray = camera.Direction(camera.centre_px() - Eigen::Vector2d(half, 0.0));
  const double across = ray.head<2>().norm();
  const double f = camera.focal_px().x();
  const auto term = [&](double x) { return shift_px / (f * x * x * x); };
  if (auto* cahvore = std::get_if<Cahvore>(&camera.lens)) {
    cahvore->R[1] += term(half / f);
  } else if (auto* pinhole = std::get_if<BrownPinhole>(&camera.lens)) {
    pinhole->k1 += term(across / ray.z());
  } else if (auto* fisheye = std::get_if<KannalaBrandt>(&camera.lens)) {
    fisheye->k[0] += term(std::atan2(across, ray.z()));
  } else if (auto* rational = std::get_if<RationalPinhole>(&camera.lens)) {
    const double x = across / ray.z(), x2 = x * x;
    const auto& k = rational->k;
    rational->k[0] += term(x) * (1.0 + x2 * (k[3] + x2 * (k[4] + x2 * k[5])));
  } else if (auto* omni = std::get_if<Omni>(&camera.lens)) {
    const double x = across / (ray.z() + omni->xi);
    omni->k1 += shift_px / (omni->fx * x * x * x);
  } else {
    std::visit(
        [&](auto& l) {
          if constexpr (requires { BendBy(l, 0.0); }) BendUntil(l, ray, shift_px);
        },
        camera.lens);
  }
  return camera;
}

Camera Resized(Camera camera, int width, int height) {
  const Eigen::Vector2d a(static_cast<double>(width) / camera.width,
                          static_cast<double>(height) / camera.height);
  const Eigen::Vector2d b = 0.5 * a - Eigen::Vector2d(0.5, 0.5);  // (u + 0.5) a - 0.5
  Map(camera.lens, a, b);
  camera.width = width;
  camera.height = height;
  return camera;
}

}  // namespace dockyard
