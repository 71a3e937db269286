#include "render/optics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr double kSharp_px = 0.25;   // a blur circle below this is drawn as a point
constexpr double kWidest_px = 24.0;  // beyond it blur grows no more
constexpr double kDiameterStep_px = 0.1;

// Falloff at places 8 px apart, straight between: within 3e-5 of itself.
constexpr int kStep = 8;

template <typename FalloffAt>
void VignetteByKnots(const Camera& camera, FalloffAt falloff_at, RadianceImage& image) {
  const int w = camera.width, h = camera.height;
  const auto knots = [&](int y) {
    std::vector<float> row;
    for (int x = 0; x < w + kStep; x += kStep) row.push_back(falloff_at(std::min(x, w), y));
    return row;
  };
  std::vector<float> top = knots(0), low, mixed(top.size());
  for (int y = 0; y < h; ++y) {
    const int from = y / kStep * kStep, to = std::min(from + kStep, h);
    if (y == from) {
      if (y > 0) top = std::move(low);
      low = knots(to);
    }
    const float t = static_cast<float>(y - from) / static_cast<float>(to - from);
    for (std::size_t i = 0; i < top.size(); ++i) mixed[i] = top[i] + t * (low[i] - top[i]);
    float* row = &image.values[static_cast<std::size_t>(y) * w];
    int x0 = 0, i = 0;
    for (; x0 + kStep <= w; x0 += kStep, ++i) {
      const float first = mixed[i], per_px = (mixed[i + 1] - first) * (1.0f / kStep);
      for (int k = 0; k < kStep; ++k) row[x0 + k] *= first + static_cast<float>(k) * per_px;
    }
    for (int k = 0; x0 + k < w; ++k) {
      const float per_px = (mixed[i + 1] - mixed[i]) / static_cast<float>(w - x0);
      row[x0 + k] *= mixed[i] + static_cast<float>(k) * per_px;
    }
  }
}

void VignetteByAngle(const Camera& camera, double exponent, RadianceImage& image) {
  VignetteByKnots(
      camera,
      [&](int x, int y) {
        const double cosine = std::max(camera.Direction(Eigen::Vector2d(x, y)).z(), 0.0);
        return static_cast<float>(std::pow(cosine, exponent));
      },
      image);
}

// The same against rho^2, so that no knot needs the lens's inverse.
void VignetteByRadius(const Camera& camera, const KannalaBrandt& lens, double exponent,
                      RadianceImage& image) {
  constexpr int kSize = 512;
  const auto rho2 = [&](double u, double v) {
    const double mx = (u - lens.cx) / lens.fx, my = (v - lens.cy) / lens.fy;
    return mx * mx + my * my;
  };
  double largest = 1e-12;
  for (const double u : {0, camera.width}) {
    for (const double v : {0, camera.height}) largest = std::max(largest, rho2(u, v));
  }
  const double per_rho2 = (kSize - 2) / largest;
  std::array<float, kSize> falloff{};
  for (int i = 0; i < kSize; ++i) {
    const double rho = std::sqrt(i / per_rho2);
    const Eigen::Vector3d ray = camera.Direction({lens.cx + lens.fx * rho, lens.cy});
    falloff[i] = static_cast<float>(std::pow(std::max(ray.z(), 0.0), exponent));
  }
  VignetteByKnots(
      camera,
      [&](int x, int y) {
        const auto at = static_cast<float>(rho2(x, y) * per_rho2);
        const int i = static_cast<int>(at);
        return falloff[i] + (at - static_cast<float>(i)) * (falloff[i + 1] - falloff[i]);
      },
      image);
}

void ApplyVignetting(const Camera& camera, double exponent, RadianceImage& image) {
  if (exponent == 0.0) return;
  if (const auto* fisheye = std::get_if<KannalaBrandt>(&camera.lens)) {
    VignetteByRadius(camera, *fisheye, exponent, image);
  } else {
    VignetteByAngle(camera, exponent, image);
  }
}

// Shares of a disc in the pixels round its middle, (2 radius + 1) a side.
struct Disc {
  int radius = 0;
  std::vector<float> weights;
};

Disc RawDisc(double diameter_px) {
  constexpr int kParts = 16;  // of a pixel, a side
  Disc disc{.radius = std::max(0, static_cast<int>(std::ceil(0.5 * diameter_px - 0.5))),
            .weights = {}};
  const double r2 = 0.25 * diameter_px * diameter_px;
  double sum = 0.0;
  for (int y = -disc.radius; y <= disc.radius; ++y) {
    for (int x = -disc.radius; x <= disc.radius; ++x) {
      int inside = 0;
      for (int j = 0; j < kParts; ++j) {
        for (int i = 0; i < kParts; ++i) {
          const double px = x + (i + 0.5) / kParts - 0.5, py = y + (j + 0.5) / kParts - 0.5;
          inside += px * px + py * py <= r2;
        }
      }
      disc.weights.push_back(static_cast<float>(inside));
      sum += inside;
    }
  }
  for (float& weight : disc.weights) weight = static_cast<float>(weight / sum);
  return disc;
}

double Variance(const Disc& disc) {  // along x
  double variance = 0.0;
  const float* weight = disc.weights.data();
  for (int y = -disc.radius; y <= disc.radius; ++y) {
    for (int x = -disc.radius; x <= disc.radius; ++x) variance += *weight++ * x * x;
  }
  return variance;
}

// The view's pixels have averaged once already, so the disc's own pixels must not widen it: the
// disc is drawn smaller until its second moment is c^2 / 16, a uniform disc's.
Disc MakeDisc(double diameter_px) {
  constexpr double kWide_px = 4.0;
  if (diameter_px > kWide_px) return RawDisc(std::sqrt(diameter_px * diameter_px - 4.0 / 3.0));
  double low = 0.1, high = diameter_px;
  for (int i = 0; i < 14; ++i) {
    const double middle = 0.5 * (low + high);
    (Variance(RawDisc(middle)) < diameter_px * diameter_px / 16.0 ? low : high) = middle;
  }
  return RawDisc(high);
}

// Each pixel spreads its light over its own blur circle; a pixel gets the mean of all. Where near
// and far meet, the blur of either spills over the other.
void Defocus(const Focus& focus, RadianceImage& image) {
  if (focus.distance_m == 0.0) return;
  DOCKYARD_CHECK(image.inverse_depth.size() == image.values.size());
  std::vector<Disc> discs;
  for (int i = 0; i * kDiameterStep_px <= kWidest_px; ++i) {
    discs.push_back(MakeDisc(std::max(i * kDiameterStep_px, kSharp_px)));
  }
  const int w = image.width, h = image.height;
  std::vector<float> light(image.values.size(), 0.0f), weight(image.values.size(), 0.0f);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * w + x;
      const float near = image.inverse_depth[at];
      const double c = std::min(BlurCircle_px(focus, near > 0.0f ? 1.0 / near : 1e6), kWidest_px);
      if (c < kSharp_px) {
        light[at] += image.values[at];
        weight[at] += 1.0f;
        continue;
      }
      const Disc& disc = discs[static_cast<std::size_t>(c / kDiameterStep_px + 0.5)];
      const float* share = disc.weights.data();
      for (int dy = -disc.radius; dy <= disc.radius; ++dy) {
        for (int dx = -disc.radius; dx <= disc.radius; ++dx, ++share) {
          if (x + dx < 0 || x + dx >= w || y + dy < 0 || y + dy >= h) continue;
          const std::size_t to = static_cast<std::size_t>(y + dy) * w + (x + dx);
          light[to] += *share * image.values[at];
          weight[to] += *share;
        }
      }
    }
  }
  for (std::size_t i = 0; i < light.size(); ++i) image.values[i] = light[i] / weight[i];
}

}  // namespace

double BlurCircle_px(const Focus& focus, double z_m) {
  if (focus.distance_m == 0.0) return 0.0;
  const double f = focus.focal_length_m, zf = focus.distance_m;
  const double c_m = f * f / focus.f_number * std::abs(z_m - zf) / (z_m * (zf - f));
  return c_m / focus.pixel_pitch_m;
}

void CheckOptics(const SensorOptions& s) {
  DOCKYARD_CHECK(s.vignetting_exponent >= 0.0 && s.vignetting_exponent <= 20.0);
  DOCKYARD_CHECK(s.blur_sigma_px >= 0.0 && s.blur_sigma_px <= 20.0);
  const Focus& focus = s.focus;
  if (focus.distance_m == 0.0) return;
  DOCKYARD_CHECK(focus.focal_length_m > 0.0 && focus.distance_m > focus.focal_length_m);
  DOCKYARD_CHECK(focus.f_number > 0.0 && focus.pixel_pitch_m > 0.0);
}

RadianceImage FalloffOf(const Camera& camera, double exponent) {
  RadianceImage even{.width = camera.width, .height = camera.height, .values = {}};
  even.values.assign(static_cast<std::size_t>(camera.width) * camera.height, 1.0f);
  ApplyVignetting(camera, exponent, even);
  return even;
}

void ApplyOptics(const Camera& camera, const SensorOptions& sensor, RadianceImage& image,
                 const RadianceImage* falloff) {
  Defocus(sensor.focus, image);
  if (falloff) {
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] *= falloff->values[i];
  } else {
    ApplyVignetting(camera, sensor.vignetting_exponent, image);
  }
  Blur(sensor.blur_sigma_px, image);
}

}  // namespace dockyard
