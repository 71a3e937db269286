// The sensor: from ideal radiance to the 8-bit picture. Linear; no gamma.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "controller/base/check.h"
#include "render/pixel_noise.h"
#include "render/stereo_renderer.h"

namespace dockyard {
namespace {

void RequireSound(const SensorOptions& s) {
  const auto require = [](bool good, const char* what) {
    if (!good) throw std::invalid_argument(std::string("sensor: ") + what);
  };
  require(s.full_well_e > 0.0 && std::isfinite(s.full_well_e), "full well must be positive");
  require(s.read_noise_e >= 0.0 && std::isfinite(s.read_noise_e),
          "read noise must not be negative");
  require(s.vignetting_exponent >= 0.0 && s.vignetting_exponent <= 20.0,
          "vignetting exponent must lie in 0 to 20");
  require(s.blur_sigma_px >= 0.0 && s.blur_sigma_px <= 20.0, "blur must lie in 0 to 20 px");
  require(s.exposure_percent > 0.0 && s.exposure_percent < 100.0,
          "exposure percentage must lie between 0 and 100");
  require(s.target_level > 0.0 && s.target_level <= 1.0, "target level must lie in 0 to 1");
}

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

// The radiance that the given share of all pixels exceeds: the quantile itself, no histogram bins.
double ExceededBy(const std::array<RadianceImage, 2>& images, double percent) {
  std::vector<float> all(images[0].values);
  all.insert(all.end(), images[1].values.begin(), images[1].values.end());
  if (all.empty()) return 0.0;
  const auto above = static_cast<std::size_t>(0.01 * percent * static_cast<double>(all.size()));
  const auto cut = all.end() - 1 - static_cast<std::ptrdiff_t>(std::min(above, all.size() - 1));
  std::nth_element(all.begin(), cut, all.end());
  return *cut;
}

// Shot noise by the normal approximation of the Poisson law, with the read noise in one draw.
GrayImage Digitise(const RadianceImage& image, double electrons_per_radiance,
                   const SensorOptions& s, std::uint64_t key) {
  GrayImage out{.width = image.width, .height = image.height, .pixels = {}};
  out.pixels.resize(image.values.size());
  const auto gain = static_cast<float>(electrons_per_radiance);
  const auto read_variance = static_cast<float>(s.read_noise_e * s.read_noise_e);
  const auto levels_per_e = static_cast<float>(255.0 / s.full_well_e);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const float electrons = std::max(gain * image.values[i], 0.0f);
    const float noisy = electrons + std::sqrt(electrons + read_variance) * HashNormal(key, i);
    const float level = noisy * levels_per_e + 0.5f;
    out.pixels[i] = static_cast<std::uint8_t>(std::min(std::max(level, 0.0f), 255.0f));
  }
  return out;
}

}  // namespace

StereoImages ExposeStereo(const std::array<RadianceImage, 2>& radiance, const StereoRig& rig,
                          const SensorOptions& sensor) {
  RequireSound(sensor);
  std::array<RadianceImage, 2> images = radiance;
  for (int eye = 0; eye < 2; ++eye) {
    const Camera& camera = eye == 0 ? rig.left : rig.right;
    DOCKYARD_CHECK(images[eye].width == camera.width && images[eye].height == camera.height);
    DOCKYARD_CHECK(images[eye].values.size() ==
                   static_cast<std::size_t>(camera.width) * camera.height);
    ApplyVignetting(camera, sensor.vignetting_exponent, images[eye]);
    Blur(sensor.blur_sigma_px, images[eye]);
  }
  const double cut = ExceededBy(images, sensor.exposure_percent);
  // In the dark the exposure is not opened without end.
  const double gain = sensor.target_level * sensor.full_well_e / std::max(cut, 1e-6);
  return {.left = Digitise(images[0], gain, sensor, HashBits(sensor.noise_key, 0)),
          .right = Digitise(images[1], gain, sensor, HashBits(sensor.noise_key, 1))};
}

}  // namespace dockyard
