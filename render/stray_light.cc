#include "render/stray_light.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "render/gauss_blur.h"

namespace dockyard {
namespace {

// Where the scattered light ends. Assumed, 20-45 deg.
constexpr double kScatterEnd_rad = Radians(32.0);

/// A pair of reflections: a disc on the line from the sun's image through the centre.
struct Ghost {
  double turn = 0.0;        // its angle off the axis over the sun's; below 0: on the other side
  double radius_rad = 0.0;  // of the disc
  double share = 0.0;       // of the light in all ghosts
};
// A lens of five air-to-glass surfaces or more has ten pairs or more; these are the brightest.
// Assumed: turns -1.5 to 1, radii 0.5-8 deg.
constexpr Ghost kGhosts[] = {{-0.35, Radians(1.2), 0.30},
                             {-0.62, Radians(2.2), 0.25},
                             {-1.10, Radians(4.5), 0.25},
                             {0.28, Radians(3.0), 0.15},
                             {0.55, Radians(0.9), 0.05}};
constexpr double kSoft = 0.2;  // of a ghost's radius, to both sides of its edge; assumed, 0.05-0.4
// Beyond the image the sun's ghosts fade within this angle, as the stop cuts their light off.
// Assumed, 2-15 deg.
constexpr double kGhostsFade_rad = Radians(5.0);

Eigen::Vector3d Towards(Tan tan) { return Eigen::Vector3d(tan.x, tan.y, 1.0).normalized(); }

double OffAxis(const PixelGrid& grid) {  // of the farthest corner
  double most = 0.0;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    most = std::max(most, static_cast<double>(std::hypot(grid.x[i], grid.y[i])));
  }
  return std::atan(most);
}

/// A ghost in one view: the chord's squares where its edge begins and ends, and its radiance.
struct GhostDisc {
  Eigen::Vector3f to_C;
  float radius = 0.0f, radiance = 0.0f;

  /// The edge falls evenly from 1 - kSoft to 1 + kSoft radii.
  float At(float chord2) const {
    constexpr auto soft = static_cast<float>(kSoft);
    const float out = radius * (1.0f + soft), in = radius * (1.0f - soft);
    if (chord2 >= out * out) return 0.0f;
    if (chord2 <= in * in) return radiance;
    return radiance * (out - std::sqrt(chord2)) / (out - in);
  }
};

std::vector<GhostDisc> GhostsOf(const StrayLight& stray, const SunInLens& sun, double image_rad) {
  std::vector<GhostDisc> discs;
  const double off = std::acos(std::clamp(sun.to_sun_C.z(), -1.0, 1.0));
  const double fade = std::clamp(1.0 - (off - image_rad) / kGhostsFade_rad, 0.0, 1.0);
  const double light = stray.ghosts * sun.share * fade * std::max(sun.to_sun_C.z(), 0.0);
  if (light == 0.0) return discs;
  const Eigen::Vector2d flat = sun.to_sun_C.head<2>();
  const Eigen::Vector2d side = flat.norm() > 1e-9 ? flat.normalized() : Eigen::Vector2d(1.0, 0.0);
  for (const Ghost& ghost : kGhosts) {
    const double angle = ghost.turn * off;
    const Eigen::Vector2d across = std::sin(angle) * side;
    const double r = 2.0 * std::sin(0.5 * ghost.radius_rad);
    const double solid_sr = kPi * r * r * (1.0 + kSoft * kSoft / 3.0);
    discs.push_back({Eigen::Vector3d(across.x(), across.y(), std::cos(angle)).cast<float>(),
                     static_cast<float>(r), static_cast<float>(light * ghost.share / solid_sr)});
  }
  return discs;
}

/// An image of half the size: each pixel the mean of four by four, the inner ones three times the
/// outer ones along either side. So light keeps its middle, however few pixels it lies on.
RadianceImage Halved(const RadianceImage& image) {
  RadianceImage half{
      .width = (image.width + 1) / 2, .height = (image.height + 1) / 2, .values = {}};
  constexpr float kWeights[4] = {0.125f, 0.375f, 0.375f, 0.125f};
  std::vector<float> row(static_cast<std::size_t>(image.width));
  half.values.reserve(static_cast<std::size_t>(half.width) * half.height);
  for (int y = 0; y < half.height; ++y) {
    std::fill(row.begin(), row.end(), 0.0f);
    for (int k = 0; k < 4; ++k) {
      const int from = std::clamp(2 * y - 1 + k, 0, image.height - 1);
      const float* in = &image.values[static_cast<std::size_t>(from) * image.width];
      for (std::size_t x = 0; x < row.size(); ++x) row[x] += kWeights[k] * in[x];
    }
    for (int x = 0; x < half.width; ++x) {
      float sum = 0.0f;
      for (int k = 0; k < 4; ++k) {
        const int from = std::clamp(2 * x - 1 + k, 0, image.width - 1);
        sum += kWeights[k] * row[static_cast<std::size_t>(from)];
      }
      half.values.push_back(sum);
    }
  }
  return half;
}

/// The two coarse places about a fine one, of which the nearer has three quarters.
struct Neighbours {
  int near = 0, far = 0;
};
Neighbours Coarse(int fine, int count) {
  const int near = fine / 2;
  return {near, std::clamp(near + (fine % 2 == 0 ? -1 : 1), 0, count - 1)};
}

/// Adds an image of half the size, linear between its pixels.
void AddDoubled(const RadianceImage& half, RadianceImage& image) {
  for (int y = 0; y < image.height; ++y) {
    const Neighbours row = Coarse(y, half.height);
    float* out = &image.values[static_cast<std::size_t>(y) * image.width];
    for (int x = 0; x < image.width; ++x) {
      const Neighbours column = Coarse(x, half.width);
      const float near =
          0.75f * half.at(column.near, row.near) + 0.25f * half.at(column.far, row.near);
      const float far =
          0.75f * half.at(column.near, row.far) + 0.25f * half.at(column.far, row.far);
      out[x] += 0.75f * near + 0.25f * far;
    }
  }
}

/// The image spread by the mean of the Gaussians. Each is drawn at the coarsest size at which it is
/// 2 px wide or more; halving and doubling widen it by (4^level - 1) / 2 px^2, by which its own
/// blur is the narrower.
RadianceImage Scattered(RadianceImage image, const std::vector<double>& sigmas_px) {
  std::vector<RadianceImage> levels{std::move(image)}, sums;
  const auto level_of = [](double sigma_px) {
    return std::max(0, static_cast<int>(std::floor(std::log2(0.5 * sigma_px))));
  };
  const int last = level_of(sigmas_px.back());
  while (static_cast<int>(levels.size()) <= last) levels.push_back(Halved(levels.back()));
  const auto weight = static_cast<float>(1.0 / static_cast<double>(sigmas_px.size()));
  for (const RadianceImage& level : levels) {
    sums.push_back({.width = level.width, .height = level.height, .values = {}});
    sums.back().values.assign(level.values.size(), 0.0f);
  }
  for (const double sigma_px : sigmas_px) {
    const int at = level_of(sigma_px);
    const double size2 = std::pow(4.0, at);
    RadianceImage blurred = levels[static_cast<std::size_t>(at)];
    Blur(std::sqrt(std::max(sigma_px * sigma_px - 0.5 * (size2 - 1.0), 0.0) / size2), blurred);
    std::vector<float>& sum = sums[static_cast<std::size_t>(at)].values;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * blurred.values[i];
  }
  for (std::size_t i = sums.size() - 1; i > 0; --i) AddDoubled(sums[i], sums[i - 1]);
  return std::move(sums.front());
}

/// The view without the sun's disc, whose light is not a pixel's: the mean of the rest is there.
RadianceImage WithoutDisc(const RadianceImage& image, const std::vector<std::size_t>& disc) {
  RadianceImage rest{.width = image.width, .height = image.height, .values = image.values};
  if (disc.empty() || disc.size() == rest.values.size()) return rest;
  for (const std::size_t i : disc) rest.values[i] = 0.0f;
  double sum = 0.0;
  for (const float value : rest.values) sum += value;
  const auto mean = static_cast<float>(sum / static_cast<double>(rest.values.size() - disc.size()));
  for (const std::size_t i : disc) rest.values[i] = std::min(image.values[i], mean);
  return rest;
}

}  // namespace

ScatterLaw::ScatterLaw(double core_rad) {
  const int count =
      std::max(1, static_cast<int>(std::lround(std::log2(kScatterEnd_rad / core_rad))));
  for (int k = 0; k < count; ++k) sigmas_rad_.push_back(core_rad * std::exp2(k + 0.5));
  const double widest2 = sigmas_rad_.back() * sigmas_rad_.back();
  exponent_ = static_cast<float>(0.5 / widest2);
  weight_ = static_cast<float>(1.0 / (count * 2.0 * kPi * widest2));
}

float ScatterLaw::operator()(float chord2) const {
  // Of half the width: the fourth power, and four times the peak.
  float value = std::exp(-exponent_ * chord2), peak = weight_, sum = 0.0f;
  for (std::size_t k = 0; k < sigmas_rad_.size(); ++k) {
    sum += peak * value;
    value *= value;
    value *= value;
    peak *= 4.0f;
  }
  return sum;
}

SunStray StrayOfSun(const StrayLight& stray, const PixelGrid& grid, const SunInLens& sun) {
  SunStray of_sun;
  const double cosine = sun.to_sun_C.z();
  if (cosine <= 0.0 || sun.share <= 0.0) return of_sun;
  const ScatterLaw law(stray.core_rad);
  const std::vector<GhostDisc> ghosts = GhostsOf(stray, sun, OffAxis(grid));
  const auto veil = static_cast<float>(stray.veil * sun.share * cosine);
  const Eigen::Vector3f to_sun = sun.to_sun_C.cast<float>();
  of_sun.per_irradiance.reserve(static_cast<std::size_t>(grid.width) * grid.height);
  PixelRow row(grid.width);
  for (int y = 0; y < grid.height; ++y) {
    row.Fill(grid, y);
    for (int x = 0; x < grid.width; ++x) {
      const Pixel pixel = row.At(x);
      const Eigen::Vector3f ray = Towards(pixel.middle).cast<float>();
      const float chord2 = (ray - to_sun).squaredNorm();
      float sum = veil * law(chord2);
      for (const GhostDisc& ghost : ghosts) sum += ghost.At((ray - ghost.to_C).squaredNorm());
      const float near = static_cast<float>(sun.radius_rad) + 2.0f * pixel.blur();
      if (chord2 < near * near) of_sun.disc.push_back(of_sun.per_irradiance.size());
      of_sun.per_irradiance.push_back(sum);
    }
  }
  return of_sun;
}

void AddStrayLight(const StrayLight& stray, double px_per_rad, const SunStray& of_sun,
                   double irradiance, RadianceImage& image) {
  if (stray.veil > 0.0) {
    std::vector<double> sigmas_px = ScatterLaw(stray.core_rad).sigmas_rad();
    for (double& sigma : sigmas_px) sigma *= px_per_rad;
    const RadianceImage scattered = Scattered(WithoutDisc(image, of_sun.disc), sigmas_px);
    const auto veil = static_cast<float>(stray.veil);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
      image.values[i] = (1.0f - veil) * image.values[i] + veil * scattered.values[i];
    }
  }
  if (of_sun.per_irradiance.empty()) return;
  DOCKYARD_CHECK(of_sun.per_irradiance.size() == image.values.size());
  const auto sun = static_cast<float>(irradiance);
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    image.values[i] += sun * of_sun.per_irradiance[i];
  }
}

void CheckStray(const StrayLight& stray) {
  DOCKYARD_CHECK(stray.veil >= 0.0 && stray.veil <= 0.5);
  DOCKYARD_CHECK(stray.core_rad >= Radians(0.05) && stray.core_rad <= Radians(10.0));
  DOCKYARD_CHECK(stray.ghosts >= 0.0 && stray.ghosts <= 0.1);
}

}  // namespace dockyard
