#include "render/optics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace dockyard {
namespace {

constexpr double kSharp_px = 0.25;   // a blur circle below this is drawn as a point
constexpr double kWidest_px = 24.0;  // beyond it blur grows no more
constexpr double kDiameterStep_px = 0.1;

// cos^n of the angle off axis on a grid of pixels, straight between: within 3e-5 of itself.
void VignetteByGrid(const Camera& camera, double exponent, RadianceImage& image) {
  constexpr int kStep = 8;
  const int nx = camera.width / kStep + 2, ny = camera.height / kStep + 2;
  std::vector<float> falloff;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const Eigen::Vector2d pixel(std::min(i * kStep, camera.width),
                                  std::min(j * kStep, camera.height));
      const double cosine = std::max(camera.Direction(pixel).z(), 0.0);
      falloff.push_back(static_cast<float>(std::pow(cosine, exponent)));
    }
  }
  for (int y = 0; y < camera.height; ++y) {
    const int j = y / kStep;
    const float t = static_cast<float>(y - j * kStep) / std::min(kStep, camera.height - j * kStep);
    for (int x = 0; x < camera.width; ++x) {
      const int i = x / kStep;
      const float s = static_cast<float>(x - i * kStep) / std::min(kStep, camera.width - i * kStep);
      const float* top = &falloff[static_cast<std::size_t>(j) * nx + i];
      const float* low = top + nx;
      const float above = top[0] + s * (top[1] - top[0]), below = low[0] + s * (low[1] - low[0]);
      image.values[static_cast<std::size_t>(y) * image.width + x] *= above + t * (below - above);
    }
  }
}

// The same against rho^2, so that no pixel needs the lens's inverse.
void VignetteByRadius(const Camera& camera, const KannalaBrandt& lens, double exponent,
                      RadianceImage& image) {
  constexpr int kSize = 2048;
  double largest = 0.0;
  for (const double u : {0.0, camera.width - 1.0}) {
    for (const double v : {0.0, camera.height - 1.0}) {
      largest = std::max(largest, std::hypot((u - lens.cx) / lens.fx, (v - lens.cy) / lens.fy));
    }
  }
  const double per_rho2 = (kSize - 2) / std::max(largest * largest, 1e-12);
  std::array<float, kSize> falloff{};
  for (int i = 0; i < kSize; ++i) {
    const double rho = std::sqrt(i / per_rho2);
    const Eigen::Vector3d ray = camera.Direction({lens.cx + lens.fx * rho, lens.cy});
    falloff[i] = static_cast<float>(std::pow(std::max(ray.z(), 0.0), exponent));
  }
  for (int y = 0; y < camera.height; ++y) {
    const double my = (y - lens.cy) / lens.fy;
    for (int x = 0; x < camera.width; ++x) {
      const double mx = (x - lens.cx) / lens.fx;
      const auto at = static_cast<float>((mx * mx + my * my) * per_rho2);
      const int i = static_cast<int>(at);
      const float share = falloff[i] + (at - static_cast<float>(i)) * (falloff[i + 1] - falloff[i]);
      image.values[static_cast<std::size_t>(y) * image.width + x] *= share;
    }
  }
}

void ApplyVignetting(const Camera& camera, double exponent, RadianceImage& image) {
  if (exponent == 0.0) return;
  if (const auto* fisheye = std::get_if<KannalaBrandt>(&camera.lens)) {
    VignetteByRadius(camera, *fisheye, exponent, image);
  } else {
    VignetteByGrid(camera, exponent, image);
  }
}

std::vector<float> GaussianKernel(double sigma) {
  const int radius = std::max(1, static_cast<int>(std::ceil(4.0 * sigma)));
  std::vector<double> weights(2 * radius + 1);
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    // The Gaussian's share of each pixel, so that narrow blurs keep their width.
    const double root2 = std::sqrt(2.0) * sigma;
    sum += weights[i + radius] = std::erf((i + 0.5) / root2) - std::erf((i - 0.5) / root2);
  }
  std::vector<float> kernel;
  for (const double w : weights) kernel.push_back(static_cast<float>(w / sum));
  return kernel;
}

void Blur(double sigma, RadianceImage& image) {
  if (sigma == 0.0) return;
  const std::vector<float> kernel = GaussianKernel(sigma);
  const int radius = static_cast<int>(kernel.size() / 2), w = image.width, h = image.height;
  std::vector<float> padded(w + 2 * radius), out(image.values.size(), 0.0f);
  for (int y = 0; y < h; ++y) {  // along the rows, in place
    float* row = &image.values[static_cast<std::size_t>(y) * w];
    for (int x = 0; x < w + 2 * radius; ++x) padded[x] = row[std::clamp(x - radius, 0, w - 1)];
    std::fill(row, row + w, 0.0f);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const float weight = kernel[k];
      const float* from = padded.data() + k;
      for (int x = 0; x < w; ++x) row[x] += weight * from[x];
    }
  }
  for (int y = 0; y < h; ++y) {  // down the columns
    float* row = &out[static_cast<std::size_t>(y) * w];
    for (int k = -radius; k <= radius; ++k) {
      const float weight = kernel[k + radius];
      const float* from = &image.values[static_cast<std::size_t>(std::clamp(y + k, 0, h - 1)) * w];
      for (int x = 0; x < w; ++x) row[x] += weight * from[x];
    }
  }
  image.values = std::move(out);
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

// Each pixel spreads its light over its own blur circle; what a pixel gets is their mean. Where
// near and far meet, the blur of either spills over the other.
void Defocus(const Focus& focus, RadianceImage& image) {
  if (focus.distance_m == 0.0) return;
  if (image.inverse_depth.size() != image.values.size()) {
    throw std::invalid_argument("defocus: the view holds no depths");
  }
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

void RequireSoundOptics(const SensorOptions& s) {
  const auto require = [](bool good, const char* what) {
    if (!good) throw std::invalid_argument(std::string("sensor: ") + what);
  };
  require(s.vignetting_exponent >= 0.0 && s.vignetting_exponent <= 20.0,
          "vignetting exponent must lie in 0 to 20");
  require(s.blur_sigma_px >= 0.0 && s.blur_sigma_px <= 20.0, "blur must lie in 0 to 20 px");
  const Focus& focus = s.focus;
  require(focus.distance_m == 0.0 ||
              (focus.focal_length_m > 0.0 && focus.f_number > 0.0 && focus.pixel_pitch_m > 0.0 &&
               focus.distance_m > focus.focal_length_m),
          "focus needs a focal length, an f-number, a pixel pitch, and a distance beyond the focal "
          "length");
}

void ApplyOptics(const Camera& camera, const SensorOptions& sensor, RadianceImage& image) {
  Defocus(sensor.focus, image);
  ApplyVignetting(camera, sensor.vignetting_exponent, image);
  Blur(sensor.blur_sigma_px, image);
}

}  // namespace dockyard
