#include "controller/rocky7/exposure.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// Grey about the target: what is aimed at, and what is too bright. Assumed, 60-120 and 180-230.
constexpr double kAimedLevel = 80.0, kTooBright = 200.0;
// Of exposure: a stop less is not worth a picture (assumed, 0.5-1.5); four stops bring the light of
// a clear sky up to that of the sun (assumed, 3-5).
constexpr double kWorthWhile = 1.0, kMostMore = 4.0;

}  // namespace

std::optional<double> MoreStops(const GrayImage& image, const Eigen::Vector2d& pixel, int about_px,
                                double stops_now) {
  const int u0 = static_cast<int>(std::lround(pixel.x()));
  const int v0 = static_cast<int>(std::lround(pixel.y()));
  double sum = 0.0;
  int count = 0;
  for (int v = std::max(0, v0 - about_px); v < std::min(image.height, v0 + about_px); ++v) {
    for (int u = std::max(0, u0 - about_px); u < std::min(image.width, u0 + about_px); ++u) {
      sum += image.at(u, v);
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  const double level = sum / count;
  const double more =
      std::clamp(std::log2(kAimedLevel / std::max(level, 1.0)), -stops_now, kMostMore - stops_now);
  if (more >= kWorthWhile || (level > kTooBright && more < 0.0)) return more;
  return std::nullopt;
}

}  // namespace dockyard::rocky7
