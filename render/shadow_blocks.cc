#include "render/shadow_blocks.h"

#include <algorithm>
#include <cstring>

#include "render/four_floats.h"

namespace dockyard {

void ShadowBlocks::Clear() {
  std::fill(kept_.begin(), kept_.end(), Kept{});
  last_ = {};
}

ShadowBlocks::Bounds ShadowBlocks::Find(const Map& map, int column, int row, const Rises& rises) {
  constexpr int kAcross = kSide + 2 * kMargin;
  static_assert(kAcross == 8);
  const Four none = {kNoCaster, kNoCaster, kNoCaster, kNoCaster};
  const Four left = {0.5f - kMargin, 1.5f - kMargin, 2.5f - kMargin, 3.5f - kMargin};
  const Four over_left = rises.x * left, over_right = rises.x * (left + 4.0f);
  Four low = -none, high = none;
  const auto take = [&](const float* depth, Four plane) {
    Four d;
    std::memcpy(&d, depth, sizeof d);
    const Four over = (d < 1.0f ? map.top_m - d * map.range_m : none) - plane;
    low = over < low ? over : low;
    high = over > high ? over : high;
  };
  for (int y = -kMargin; y < kSide + kMargin; ++y) {
    const float* depth =
        map.depth + static_cast<std::size_t>(row + y) * map.width + (column - kMargin);
    const float up = rises.y * (static_cast<float>(y) + 0.5f);
    take(depth, over_left + up);
    take(depth + 4, over_right + up);
  }
  return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
          std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
}

}  // namespace dockyard
