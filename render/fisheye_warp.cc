#include "render/fisheye_warp.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dockyard {
namespace {

constexpr int kTableSize = 8192;
constexpr double kBorder = 0.02;

void RequireSound(const Camera& c) {
  if (c.width < 1 || c.height < 1 || c.width > 8192 || c.height > 8192) {
    throw std::invalid_argument("camera: the image must have 1 to 8192 pixels a side");
  }
  const Eigen::Vector2d f = c.focal_px(), centre = c.centre_px();
  if (!f.allFinite() || !centre.allFinite() || !(f.minCoeff() > 0.0)) {
    throw std::invalid_argument("camera: focal lengths must be positive and all numbers finite");
  }
}

double LargestRho(const Camera& c, const KannalaBrandt& lens) {
  double rho = 0.0;
  for (const double u : {-0.5, c.width - 0.5}) {
    for (const double v : {-0.5, c.height - 0.5}) {
      rho = std::max(rho, std::hypot((u - lens.cx) / lens.fx, (v - lens.cy) / lens.fy));
    }
  }
  return rho;
}

double AngleOf(const Eigen::Vector3d& ray) {
  return std::atan2(std::hypot(ray.x(), ray.y()), ray.z());
}

Eigen::Vector3d RequiredRay(const Camera& camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector3d ray = camera.Direction(pixel);
  if (AngleOf(ray) > kWidestDrawn_rad) {
    throw std::invalid_argument("camera: a pixel sees more than 65 deg off the axis");
  }
  if (!camera.HasRay(pixel)) {
    throw std::invalid_argument("camera: the lens polynomial gives some pixels no ray");
  }
  return ray;
}

}  // namespace

TanScale::TanScale(const Camera& camera, const LensRipple& ripple)
    : camera_(camera), ripple_(ripple) {
  RequireSound(camera);
  const auto* fisheye = std::get_if<KannalaBrandt>(&camera.lens);
  if (fisheye && ripple.none()) {
    TabulateRadius(*fisheye);
  } else {
    TabulateCorners();
  }
}

void TanScale::TabulateRadius(const KannalaBrandt& lens) {
  const double largest = LargestRho(camera_, lens) * 1.0001;
  per_rho2_ = (kTableSize - 2) / (largest * largest);
  table_.resize(kTableSize);
  for (int i = 0; i < kTableSize; ++i) {
    const double rho = std::sqrt(i / per_rho2_);
    const Eigen::Vector2d pixel(lens.cx + lens.fx * rho, lens.cy);
    const double theta = AngleOf(RequiredRay(camera_, pixel));
    table_[i] = rho > 0.0 ? std::tan(theta) / rho : 1.0;
  }
}

void TanScale::TabulateCorners() {
  const std::size_t count = static_cast<std::size_t>(camera_.width + 1) * (camera_.height + 1);
  corners_.reserve(count);
  const auto* cahvore = std::get_if<Cahvore>(&camera_.lens);
  const bool moves = cahvore && !cahvore->E.isZero(0.0);
  if (moves) pupil_m_.reserve(count);
  for (int y = 0; y <= camera_.height; ++y) {
    for (int x = 0; x <= camera_.width; ++x) {
      const Eigen::Vector2d corner(x - 0.5, y - 0.5);
      const Eigen::Vector2d pixel = corner - ripple_.At(corner);
      const Eigen::Vector3d ray = RequiredRay(camera_, pixel);
      corners_.emplace_back((ray.head<2>() / ray.z()).cast<float>());
      if (moves) {
        pupil_m_.push_back(static_cast<float>(camera_.Ray(pixel).origin.dot(cahvore->O)));
      }
    }
  }
}

Eigen::Vector2d TanScale::operator()(const Eigen::Vector2d& pixel) const {
  const auto* lens = std::get_if<KannalaBrandt>(&camera_.lens);
  if (!lens || !ripple_.none()) {
    const Eigen::Vector3d ray = RayWith(ripple_, camera_, pixel).direction;
    return ray.head<2>() / ray.z();
  }
  const double mx = (pixel.x() - lens->cx) / lens->fx;
  const double my = (pixel.y() - lens->cy) / lens->fy;
  const double at = std::min((mx * mx + my * my) * per_rho2_, kTableSize - 1.001);
  const int i = static_cast<int>(at);
  const double scale = table_[i] + (at - i) * (table_[i + 1] - table_[i]);
  return {scale * mx, scale * my};
}

void TanScale::CornerRow(int y, const RayEnds& ends, std::vector<Eigen::Vector2f>& row) const {
  if (!corners_.empty()) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * (camera_.width + 1);
    row.assign(corners_.begin() + first, corners_.begin() + first + camera_.width + 1);
    if (pupil_m_.empty()) return;
    const Eigen::Vector3d& O = std::get<Cahvore>(camera_.lens).O;
    for (int x = 0; x <= camera_.width; ++x) {
      const Eigen::Vector3d o = static_cast<double>(pupil_m_[first + x]) * O;
      row[x] = ends.Seen(o, row[x].cast<double>()).cast<float>();
    }
    return;
  }
  row.resize(camera_.width + 1);
  for (int x = 0; x <= camera_.width; ++x) {
    row[x] = (*this)(Eigen::Vector2d(x - 0.5, y - 0.5)).cast<float>();
  }
}

TanRect ImageRect(const Camera& camera, const TanScale& scale) {
  TanRect rect{.left = 1e9, .top = 1e9, .right = -1e9, .bottom = -1e9};
  const auto add = [&](double u, double v) {
    const Eigen::Vector2d tan = scale({u, v});
    rect.left = std::min(rect.left, tan.x());
    rect.right = std::max(rect.right, tan.x());
    rect.top = std::min(rect.top, tan.y());
    rect.bottom = std::max(rect.bottom, tan.y());
  };
  for (int x = 0; x <= camera.width; ++x) {
    add(x - 0.5, -0.5);
    add(x - 0.5, camera.height - 0.5);
  }
  for (int y = 0; y <= camera.height; ++y) {
    add(-0.5, y - 0.5);
    add(camera.width - 0.5, y - 0.5);
  }
  // At least three pixels of the flat view, so that interpolation stays inside it.
  const double w = std::max(kBorder * (rect.right - rect.left), 4.0 / camera.focal_px().x());
  const double h = std::max(kBorder * (rect.bottom - rect.top), 4.0 / camera.focal_px().y());
  return {rect.left - w, rect.top - h, rect.right + w, rect.bottom + h};
}

}  // namespace dockyard
