#include "render/ground_pyramids.h"

#include <bit>
#include <cstring>

#include "controller/base/two_widths.h"

namespace dockyard {

SoilPyramid::SoilPyramid(std::vector<std::uint8_t> texels, int side) {
  while (true) {
    Level level{.side = side, .texels = std::vector<std::uint32_t>(texels.size() / 4)};
    std::memcpy(level.texels.data(), texels.data(), texels.size());
    levels_.push_back(std::move(level));
    if (side == 1) break;
    const int half = side / 2;
    std::vector<std::uint8_t> coarse(4u * half * half);
    for (int y = 0; y < half; ++y) {
      for (int i = 0; i < 4 * half; ++i) {
        const std::uint8_t* from = &texels[4u * (2 * y * side) + 8 * (i / 4) + i % 4];
        const int sum = from[0] + from[4] + from[4 * side] + from[4 * side + 4];
        coarse[4u * y * half + i] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
    texels = std::move(coarse);
    side = half;
  }
}

// As in Bilinear, side by side.
[[gnu::always_inline]] inline void SoilPyramid::Find(const float* u, const float* v,
                                                     const std::int32_t* level, int count,
                                                     Corners& c) const {
  const std::int32_t finest = top();
  for (int i = 0; i < count; ++i) {
    const float side = std::bit_cast<float>((finest - level[i] + 127) << 23);  // 2^(finest - level)
    const std::int32_t mask = static_cast<std::int32_t>(side) - 1;
    const float x = u[i] * side - 0.5f, y = v[i] * side - 0.5f;
    std::int32_t ix = static_cast<std::int32_t>(x), iy = static_cast<std::int32_t>(y);
    ix -= x < static_cast<float>(ix) ? 1 : 0;
    iy -= y < static_cast<float>(iy) ? 1 : 0;
    c.fx[i] = x - static_cast<float>(ix);
    c.fy[i] = y - static_cast<float>(iy);
    c.x0[i] = ix & mask;
    c.x1[i] = (ix + 1) & mask;
    // Exact: no level has 2^24 texels.
    c.top[i] = static_cast<std::int32_t>(static_cast<float>(iy & mask) * side);
    c.low[i] = static_cast<std::int32_t>(static_cast<float>((iy + 1) & mask) * side);
  }
}

DOCKYARD_TWO_WIDTHS
void SoilPyramid::At(const float* u, const float* v, const float* lod, int count,
                     Four* texels) const {
  Corners fine, coarse;
  std::int32_t level[kAtOnce], next[kAtOnce];
  float t[kAtOnce];
  const float most = static_cast<float>(top()) - 0.001f;
  for (int i = 0; i < count; ++i) {
    const float at = lod[i] < 0.0f ? 0.0f : most < lod[i] ? most : lod[i];
    level[i] = static_cast<std::int32_t>(at);
    next[i] = level[i] + 1;
    t[i] = at - static_cast<float>(level[i]);
  }
  Find(u, v, level, count, fine);
  Find(u, v, next, count, coarse);
  const auto mixed = [](const Level& of, const Corners& c, int i) {
    const std::uint32_t *high = &of.texels[static_cast<std::size_t>(c.top[i])],
                        *low = &of.texels[static_cast<std::size_t>(c.low[i])];
    return Mix(Mix(Unpacked(high[c.x0[i]]), Unpacked(high[c.x1[i]]), c.fx[i]),
               Mix(Unpacked(low[c.x0[i]]), Unpacked(low[c.x1[i]]), c.fx[i]), c.fy[i]);
  };
  for (int i = 0; i < count; ++i) {
    const Level* levels = &levels_[static_cast<std::size_t>(level[i])];
    const Four near = mixed(levels[0], fine, i);
    texels[i] = t[i] == 0.0f ? near : Mix(near, mixed(levels[1], coarse, i), t[i]);
  }
}

ReliefPyramid::Level::Level(int x, int y, int k)
    : nodes(static_cast<std::size_t>(x) * y),
      nx(x),
      ny(y),
      scale(1.0f / static_cast<float>(1 << k)),
      shift(0.5f * scale - 0.5f),
      last_x(static_cast<float>(x) - 1.001f),
      last_y(static_cast<float>(y) - 1.001f) {}

ReliefPyramid::ReliefPyramid(int nx, int ny) {
  levels_.emplace_back(nx, ny, 0);
  for (int k = 1; levels_.back().nx > 4 && levels_.back().ny > 4; ++k) {
    levels_.emplace_back(levels_.back().nx / 2, levels_.back().ny / 2, k);
  }
}

void ReliefPyramid::FillCoarse(GridRect rect) {
  for (std::size_t k = 1; k < levels_.size(); ++k) {
    const Level& fine = levels_[k - 1];
    Level& level = levels_[k];
    // The last column or row of an odd number has no pair.
    rect = {.x_begin = rect.x_begin / 2,
            .x_end = std::min((rect.x_end + 1) / 2, level.nx),
            .y_begin = rect.y_begin / 2,
            .y_end = std::min((rect.y_end + 1) / 2, level.ny)};
    for (int y = rect.y_begin; y < rect.y_end; ++y) {
      for (int x = rect.x_begin; x < rect.x_end; ++x) {
        const Four* from = &fine.nodes[static_cast<std::size_t>(2 * y) * fine.nx + 2 * x];
        level.nodes[static_cast<std::size_t>(y) * level.nx + x] =
            0.25f * (from[0] + from[1] + from[fine.nx] + from[fine.nx + 1]);
      }
    }
  }
}

}  // namespace dockyard
