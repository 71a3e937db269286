#include "render/fisheye_warp.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dockyard {
namespace {

constexpr double kWidest_rad = 60.0 * kPi / 180.0;
constexpr int kTableSize = 8192;
constexpr double kBorder = 0.02;
constexpr int kMostTaps = 6;

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
  if (AngleOf(ray) > kWidest_rad) {
    throw std::invalid_argument("camera: a pixel sees more than 60 deg off the axis");
  }
  if (!camera.HasRay(pixel)) {
    throw std::invalid_argument("camera: the lens polynomial gives some pixels no ray");
  }
  return ray;
}

// A flat view in its own pixels.
struct Sampler {
  explicit Sampler(const FlatView& view)
      : values(view.values.data()),
        width(view.width),
        x0(static_cast<float>(view.rect.left)),
        y0(static_cast<float>(view.rect.top)),
        sx(static_cast<float>(view.width / (view.rect.right - view.rect.left))),
        sy(static_cast<float>(view.height / (view.rect.bottom - view.rect.top))),
        last_x(static_cast<float>(view.width) - 1.001f),
        last_y(static_cast<float>(view.height) - 1.001f) {}

  Eigen::Vector2f ToPixels(const Eigen::Vector2f& tan) const {
    return {(tan.x() - x0) * sx - 0.5f, (tan.y() - y0) * sy - 0.5f};
  }
  bool Holds(const Eigen::Vector2f& tan) const {
    const Eigen::Vector2f p = ToPixels(tan);
    return p.x() >= 1.0f && p.y() >= 1.0f && p.x() <= last_x - 1.0f && p.y() <= last_y - 1.0f;
  }
  // The caller keeps to the view: the border round the picture, or Holds.
  float Bilinear(float x, float y) const {
    const int ix = static_cast<int>(x), iy = static_cast<int>(y);
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    const float* a = values + static_cast<std::ptrdiff_t>(iy) * width + ix;
    const float* b = a + width;
    const float top = a[0] + fx * (a[1] - a[0]), low = b[0] + fx * (b[1] - b[0]);
    return top + fy * (low - top);
  }

  const float* values;
  int width;
  float x0, y0, sx, sy, last_x, last_y;
};

// Corners of a footprint in a flat view's pixels, in the order of the image: 00, 10, 01, 11.
struct Footprint {
  Eigen::Vector2f c00, c10, c01, c11;
};

int Taps(float length) { return std::clamp(static_cast<int>(length + 0.6f), 2, kMostTaps); }

// nu x nv taps spread over the footprint. With constant counts the compiler unrolls.
inline float AverageOf(const Sampler& view, const Footprint& f, int nu, int nv) {
  const float du = 1.0f / static_cast<float>(nu), dv = 1.0f / static_cast<float>(nv);
  float sum = 0.0f;
  for (int j = 0; j < nv; ++j) {
    const float v = (static_cast<float>(j) + 0.5f) * dv;
    const float lx = f.c00.x() + v * (f.c01.x() - f.c00.x());
    const float ly = f.c00.y() + v * (f.c01.y() - f.c00.y());
    const float wx = f.c10.x() + v * (f.c11.x() - f.c10.x()) - lx;
    const float wy = f.c10.y() + v * (f.c11.y() - f.c10.y()) - ly;
    for (int i = 0; i < nu; ++i) {
      const float u = (static_cast<float>(i) + 0.5f) * du;
      sum += view.Bilinear(lx + u * wx, ly + u * wy);
    }
  }
  return sum * (du * dv);
}

float Average(const Sampler& view, const Footprint& f) {
  const float across = std::max(std::abs(f.c10.x() - f.c00.x()), std::abs(f.c10.y() - f.c00.y()));
  const float down = std::max(std::abs(f.c01.x() - f.c00.x()), std::abs(f.c01.y() - f.c00.y()));
  const int nu = Taps(across), nv = Taps(down);
  if (nu == 2 && nv == 2) return AverageOf(view, f, 2, 2);
  return AverageOf(view, f, nu, nv);
}

Footprint InPixels(const Sampler& view, const Footprint& tan) {
  return {view.ToPixels(tan.c00), view.ToPixels(tan.c10), view.ToPixels(tan.c01),
          view.ToPixels(tan.c11)};
}

}  // namespace

TanScale::TanScale(const Camera& camera) : camera_(camera) {
  RequireSound(camera);
  if (const auto* fisheye = std::get_if<KannalaBrandt>(&camera.lens)) {
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
  corners_.reserve(static_cast<std::size_t>(camera_.width + 1) * (camera_.height + 1));
  for (int y = 0; y <= camera_.height; ++y) {
    for (int x = 0; x <= camera_.width; ++x) {
      const Eigen::Vector3d ray = RequiredRay(camera_, {x - 0.5, y - 0.5});
      corners_.emplace_back((ray.head<2>() / ray.z()).cast<float>());
    }
  }
}

Eigen::Vector2d TanScale::operator()(const Eigen::Vector2d& pixel) const {
  const auto* lens = std::get_if<KannalaBrandt>(&camera_.lens);
  if (!lens) {
    const Eigen::Vector3d ray = camera_.Direction(pixel);
    return ray.head<2>() / ray.z();
  }
  const double mx = (pixel.x() - lens->cx) / lens->fx;
  const double my = (pixel.y() - lens->cy) / lens->fy;
  const double at = std::min((mx * mx + my * my) * per_rho2_, kTableSize - 1.001);
  const int i = static_cast<int>(at);
  const double scale = table_[i] + (at - i) * (table_[i + 1] - table_[i]);
  return {scale * mx, scale * my};
}

void TanScale::CornerRow(int y, std::vector<Eigen::Vector2f>& row) const {
  if (!corners_.empty()) {
    const auto first = corners_.begin() + static_cast<std::ptrdiff_t>(y) * (camera_.width + 1);
    row.assign(first, first + camera_.width + 1);
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

RadianceImage WarpToFisheye(const Camera& camera, const TanScale& scale, const FlatView& wide,
                            const FlatView* close) {
  RadianceImage image{.width = camera.width, .height = camera.height, .values = {}};
  image.values.resize(static_cast<std::size_t>(camera.width) * camera.height);
  const Sampler far_view(wide), close_view(close ? *close : wide);
  std::vector<Eigen::Vector2f> above, below;
  scale.CornerRow(0, above);
  for (int y = 0; y < camera.height; ++y) {
    scale.CornerRow(y + 1, below);
    float* out = &image.values[static_cast<std::size_t>(y) * camera.width];
    for (int x = 0; x < camera.width; ++x) {
      const Footprint tan{above[x], above[x + 1], below[x], below[x + 1]};
      if (close && close_view.Holds(tan.c00) && close_view.Holds(tan.c11) &&
          close_view.Holds(tan.c10) && close_view.Holds(tan.c01)) {
        out[x] = Average(close_view, InPixels(close_view, tan));
        continue;
      }
      out[x] = Average(far_view, InPixels(far_view, tan));
    }
    std::swap(above, below);
  }
  return image;
}

}  // namespace dockyard
