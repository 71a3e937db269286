#include "controller/vision/board/exposure_merge.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dockyard {
namespace {

constexpr int kNumbers = 256;  // of an 8-bit pixel

/// Radiance and weight of each number of one picture.
struct Response {
  std::array<double, kNumbers> radiance{}, weight{};
};

Response ResponseAt(double stops, const ExposureMergeOptions& options) {
  Response response;
  const double gain = std::exp2(stops);
  for (int i = 0; i < kNumbers; ++i) {
    const auto z = static_cast<double>(i);
    const auto at = static_cast<std::size_t>(i);
    const double trust =
        std::clamp((options.saturated - z) / (options.saturated - options.trusted), 0.0, 1.0);
    response.radiance[at] = z / gain;
    response.weight[at] =
        trust * gain * gain / (options.floor_variance + options.shot_variance * z);
  }
  return response;
}

bool SameSize(const GrayImage& a, const GrayImage& b) {
  return a.width == b.width && a.height == b.height && a.pixels.size() == b.pixels.size();
}

struct Sum {
  double weighted = 0.0, weight = 0.0;
};

double MostStops(const std::vector<ExposedImage>& pictures) {
  double most = pictures.front().stops;
  for (const ExposedImage& picture : pictures) most = std::max(most, picture.stops);
  return most;
}

}  // namespace

std::vector<float> MergedRadiance(const std::vector<ExposedImage>& pictures,
                                  const ExposureMergeOptions& options) {
  if (pictures.empty()) return {};
  const GrayImage& first = pictures.front().image;
  std::vector<Sum> sums(first.pixels.size());
  double least = pictures.front().stops;
  for (const ExposedImage& picture : pictures) {
    if (!SameSize(picture.image, first)) continue;
    least = std::min(least, picture.stops);
    const Response response = ResponseAt(picture.stops, options);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const std::uint8_t z = picture.image.pixels[i];
      sums[i].weighted += response.weight[z] * response.radiance[z];
      sums[i].weight += response.weight[z];
    }
  }
  const double bound = (kNumbers - 1) / std::exp2(least);
  std::vector<float> radiance(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    radiance[i] =
        static_cast<float>(sums[i].weight > 0.0 ? sums[i].weighted / sums[i].weight : bound);
  }
  return radiance;
}

GrayImage MergeExposures(const std::vector<ExposedImage>& pictures,
                         const ExposureMergeOptions& options) {
  if (pictures.empty()) return {};
  const std::vector<float> radiance = MergedRadiance(pictures, options);
  const GrayImage& first = pictures.front().image;
  GrayImage merged{.width = first.width, .height = first.height, .pixels = {}};
  merged.pixels.resize(radiance.size());
  if (radiance.empty()) return merged;
  const double knee = options.knee / std::exp2(MostStops(pictures));
  const double brightest = *std::max_element(radiance.begin(), radiance.end());
  // A picture of noise alone is not stretched to white.
  const double scale = 255.0 / std::log1p(std::max(brightest / knee, 1.0));
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    merged.pixels[i] = static_cast<std::uint8_t>(
        scale * std::log1p(static_cast<double>(radiance[i]) / knee) + 0.5);
  }
  return merged;
}

}  // namespace dockyard
