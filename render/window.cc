#include "render/window.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "render/pixel_noise.h"

namespace dockyard {
namespace {

// Clumps' diameters are log-normal about their median. Assumed, 0.2-0.7.
constexpr double kClumpLogSigma = 0.4;
// A finer one is drawn as wide as a pixel: the blur leaves no more of it than its share.
constexpr double kFinestClump_px = 1.0;

Eigen::Vector2d ToCover(const WindowOptions& window) {  // image rows count down
  return {std::cos(window.cover_side_rad), -std::sin(window.cover_side_rad)};
}

// Share of a rectangle |x| < a, |y| < b beyond the line x + y = at.
double ShareBeyond(double at, double a, double b) {
  const auto square = [](double v) { return v > 0.0 ? v * v : 0.0; };
  const double small = std::min(a, b), large = std::max(a, b);
  if (small < 1e-9 * large) return std::clamp(0.5 - 0.5 * at / large, 0.0, 1.0);
  return (square(a + b - at) - square(a - b - at) - square(b - a - at) + square(-a - b - at)) /
         (8.0 * a * b);
}

// Share of a disc of radius 1 on the far side of a chord at -1 to 1.
double DiscBeyond(double at) {
  if (std::abs(at) >= 1.0) return at < 0.0 ? 1.0 : 0.0;
  return 0.5 - (at * std::sqrt(1.0 - at * at) + std::asin(at)) / kPi;
}

// 1 where a clump lies, over the image and a margin. Clumps fall until the share of the image is
// under them.
struct Mask {
  int margin = 0, width = 0, height = 0;
  std::vector<std::uint8_t> under;
};

Mask DrawClumps(const Camera& camera, const WindowOptions& window, int margin) {
  Mask mask{.margin = margin,
            .width = camera.width + 2 * margin,
            .height = camera.height + 2 * margin,
            .under = {}};
  mask.under.assign(static_cast<std::size_t>(mask.width) * mask.height, 0);
  const double px_per_m = camera.focal_px().x() / window.distance_m;
  const auto wanted = static_cast<long>(
      std::llround(window.dust_share * static_cast<double>(camera.width) * camera.height));
  long covered = 0;
  for (std::uint64_t clump = 0; covered < wanted; ++clump) {
    const double diameter = window.dust_clump_m * px_per_m *
                            std::exp(kClumpLogSigma * HashNormal(window.dust_key, 3 * clump));
    const double r = 0.5 * std::max(diameter, kFinestClump_px);
    const double x0 = mask.width * HashUniform(window.dust_key, 3 * clump + 1);
    const double y0 = mask.height * HashUniform(window.dust_key, 3 * clump + 2);
    const int top = std::max(0, static_cast<int>(std::ceil(y0 - r - 0.5)));
    const int bottom = std::min(mask.height - 1, static_cast<int>(std::floor(y0 + r - 0.5)));
    for (int y = top; y <= bottom; ++y) {
      const double dy = y + 0.5 - y0, half = std::sqrt(std::max(r * r - dy * dy, 0.0));
      const int left = std::max(0, static_cast<int>(std::ceil(x0 - half - 0.5)));
      const int right = std::min(mask.width - 1, static_cast<int>(std::floor(x0 + half - 0.5)));
      const bool in_rows = y >= margin && y < margin + camera.height;
      for (int x = left; x <= right; ++x) {
        std::uint8_t& under = mask.under[static_cast<std::size_t>(y) * mask.width + x];
        if (under == 0 && in_rows && x >= margin && x < margin + camera.width) ++covered;
        under = 1;
      }
    }
  }
  return mask;
}

}  // namespace

double WindowBlur_px(const Camera& camera, const WindowOptions& window) {
  return camera.focal_px().x() * window.pupil_m / window.distance_m;
}

double CoverEdge_px(const Camera& camera, const WindowOptions& window) {
  const Eigen::Vector2d n = ToCover(window);
  const double a = 0.5 * camera.width * std::abs(n.x()), b = 0.5 * camera.height * std::abs(n.y());
  double low = -a - b, high = a + b;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (ShareBeyond(middle, a, b) > window.cover_share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<float> CoverTransmission(const Camera& camera, const WindowOptions& window) {
  const Eigen::Vector2d n = ToCover(window);
  const double edge = CoverEdge_px(camera, window);
  const double per_px = 2.0 / std::max(WindowBlur_px(camera, window), 1e-6);
  std::vector<float> free;
  free.reserve(static_cast<std::size_t>(camera.width) * camera.height);
  for (int y = 0; y < camera.height; ++y) {
    const double along_y = n.y() * (y + 0.5 - 0.5 * camera.height) - edge;
    for (int x = 0; x < camera.width; ++x) {
      const double beyond = n.x() * (x + 0.5 - 0.5 * camera.width) + along_y;
      free.push_back(static_cast<float>(DiscBeyond(beyond * per_px)));
    }
  }
  return free;
}

// The disc is summed by rows: each is a difference of two running sums, with parts of pixels.
std::vector<float> DustTransmission(const Camera& camera, const WindowOptions& window) {
  const double r = 0.5 * WindowBlur_px(camera, window);
  const int rows = std::max(0, static_cast<int>(std::ceil(r - 0.5)));
  const Mask mask = DrawClumps(camera, window, rows + 2);
  const int w = camera.width, h = camera.height;
  std::vector<double> half;  // of the disc's rows
  double area = 0.0;
  for (int dy = -rows; dy <= rows; ++dy) {
    half.push_back(std::max(std::sqrt(std::max(r * r - 1.0 * dy * dy, 0.0)), 0.5));
    area += 2.0 * half.back();
  }
  std::vector<float> shaded(static_cast<std::size_t>(w) * h, 0.0f);
  std::vector<float> sums(static_cast<std::size_t>(mask.width) + 1);
  for (int y = 0; y < mask.height; ++y) {
    const std::uint8_t* under = &mask.under[static_cast<std::size_t>(y) * mask.width];
    sums[0] = 0.0f;
    for (int x = 0; x < mask.width; ++x) sums[x + 1] = sums[x] + under[x];
    for (int dy = -rows; dy <= rows; ++dy) {
      const int to = y - mask.margin + dy;
      if (to < 0 || to >= h) continue;
      const double width = half[static_cast<std::size_t>(dy + rows)];
      // Of the two ends: whole pixels beside the first, and the part of the next.
      const double left = mask.margin + 0.5 - width, right = mask.margin + 0.5 + width;
      const int l = static_cast<int>(left), k = static_cast<int>(right);
      const auto l_part = static_cast<float>(left - l), k_part = static_cast<float>(right - k);
      float* row = &shaded[static_cast<std::size_t>(to) * w];
      for (int x = 0; x < w; ++x) {
        const float from = sums[x + l] + l_part * (sums[x + l + 1] - sums[x + l]);
        row[x] += sums[x + k] + k_part * (sums[x + k + 1] - sums[x + k]) - from;
      }
    }
  }
  const auto per_area = static_cast<float>(1.0 / area);
  for (float& value : shaded) value = std::max(1.0f - per_area * value, 0.0f);
  return shaded;
}

void CheckWindow(const WindowOptions& window) {
  DOCKYARD_CHECK(window.cover_share >= 0.0 && window.cover_share <= 0.95);
  DOCKYARD_CHECK(std::isfinite(window.cover_side_rad));
  DOCKYARD_CHECK(window.dust_share >= 0.0 && window.dust_share <= 0.8);
  DOCKYARD_CHECK(window.dust_scatter >= 0.0 && window.dust_scatter <= 1.0);
  if (window.cover_share == 0.0 && window.dust_share == 0.0) return;
  DOCKYARD_CHECK(window.distance_m > 0.0 && std::isfinite(window.distance_m));
  DOCKYARD_CHECK(window.pupil_m > 0.0 && window.pupil_m <= window.distance_m);
  if (window.dust_share == 0.0) return;
  DOCKYARD_CHECK(window.dust_clump_m > 0.0 && window.dust_clump_m <= window.distance_m);
}

void ApplyWindow(const Camera& camera, const WindowOptions& window, RadianceImage& image) {
  if (window.cover_share > 0.0) {
    const std::vector<float> free = CoverTransmission(camera, window);
    for (std::size_t i = 0; i < free.size(); ++i) image.values[i] *= free[i];
  }
  if (window.dust_share == 0.0) return;
  const std::vector<float> free = DustTransmission(camera, window);
  double caught = 0.0;  // by clumps that the cover leaves in the light
  for (std::size_t i = 0; i < free.size(); ++i) {
    caught += static_cast<double>(image.values[i]) * (1.0 - free[i]);
    image.values[i] *= free[i];
  }
  const auto veil = static_cast<float>(window.dust_scatter * caught /
                                       static_cast<double>(std::max<std::size_t>(free.size(), 1)));
  for (float& value : image.values) value += veil;
}

}  // namespace dockyard
