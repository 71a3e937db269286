#include "render/exposure_rule.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace dockyard {
namespace {

// The k-th smallest of numbers that are not negative: their bits are in the same order, so first
// the upper halves are counted, then the lower halves of those that share the upper.
float Smallest(std::span<const RadianceImage> images, std::size_t k) {
  std::vector<std::uint32_t> counts(1u << 16, 0);
  const auto each = [&](auto visit) {
    for (const RadianceImage& image : images) {
      for (const float v : image.values) visit(std::bit_cast<std::uint32_t>(std::max(v, 0.0f)));
    }
  };
  const auto find = [&] {
    std::uint32_t bin = 0;
    while (k >= counts[bin]) k -= counts[bin++];
    return bin;
  };
  each([&](std::uint32_t bits) { ++counts[bits >> 16]; });
  const std::uint32_t upper = find();
  std::fill(counts.begin(), counts.end(), 0u);
  each([&](std::uint32_t bits) {
    if (bits >> 16 == upper) ++counts[bits & 0xffffu];
  });
  return std::bit_cast<float>(upper << 16 | find());
}

// The radiance that the given share of all pixels exceeds: the quantile itself.
double ExceededBy(std::span<const RadianceImage> images, double percent) {
  std::size_t count = 0;
  for (const RadianceImage& image : images) count += image.values.size();
  if (count == 0) return 0.0;
  const auto above = static_cast<std::size_t>(0.01 * percent * static_cast<double>(count));
  return Smallest(images, count - 1 - std::min(above, count - 1));
}

// In the dark the exposure is limited.
double CutOf(std::span<const RadianceImage> images, const SensorOptions& s) {
  return std::max(ExceededBy(images, s.exposure_percent), 1e-6);
}

}  // namespace

double ElectronsOfRadiance(std::span<const RadianceImage> images, const SensorOptions& s) {
  const double stops = std::exp2(s.exposure_stops);
  if (s.fixed_exposure_e > 0.0) return stops * s.fixed_exposure_e;
  return stops * s.target_level * s.full_well_e / CutOf(images, s);
}

double ElectronsOfRadiance(std::span<const RadianceImage> images, const SensorOptions& s,
                           KeptExposure* before) {
  if (!before || s.fixed_exposure_e > 0.0) return ElectronsOfRadiance(images, s);
  const double found = s.target_level * s.full_well_e / CutOf(images, s);
  const double taken = before->electrons > 0.0 ? before->electrons : found;
  const bool lit = std::any_of(images.begin(), images.end(),
                               [](const RadianceImage& image) { return !image.values.empty(); });
  if (lit) before->electrons = found;
  return std::exp2(s.exposure_stops) * taken;
}

}  // namespace dockyard
