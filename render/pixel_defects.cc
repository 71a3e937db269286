#include "render/pixel_defects.h"

#include <cmath>

#include "render/pixel_noise.h"

namespace dockyard {
namespace {

// Streams of one pattern: which pixels, how hot, which are stuck, and by how much.
constexpr std::uint64_t kWhich = 0x6465666563, kHeat = 0x68656174, kStuck = 0x737475636b,
                        kOffset = 0x6f6666736574;

double Exponential(std::uint64_t key, std::uint64_t pixel, double mean) {
  return mean > 0.0 ? -mean * std::log1p(-HashUniform(key, pixel)) : 0.0;
}

}  // namespace

void AddDefects(const DefectOptions& defects, std::uint64_t pattern, std::size_t first,
                std::size_t count, float* electrons) {
  const std::uint64_t which = SplitMix(pattern, kWhich), heat = SplitMix(pattern, kHeat);
  const std::uint64_t stuck = SplitMix(pattern, kStuck), offset = SplitMix(pattern, kOffset);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t pixel = first + i;
    const double u = HashUniform(which, pixel);
    if (u < defects.dead_share) {
      electrons[i] = 0.0f;
    } else if (u < defects.dead_share + defects.hot_share) {
      double dark = Exponential(heat, pixel, defects.hot_dark_e);
      if (HashUniform(stuck, pixel) < kStuckShare) {
        dark += Exponential(offset, pixel, defects.hot_offset_e);
      }
      electrons[i] += static_cast<float>(dark);
    }
  }
}

}  // namespace dockyard
