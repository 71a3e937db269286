#include "render/ground_pyramids.h"

#include <cstring>

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

ReliefPyramid::Level::Level(std::vector<Four> n, int x, int y, int k)
    : nodes(std::move(n)),
      nx(x),
      ny(y),
      scale(1.0f / static_cast<float>(1 << k)),
      shift(0.5f * scale - 0.5f),
      last_x(static_cast<float>(x) - 1.001f),
      last_y(static_cast<float>(y) - 1.001f) {}

ReliefPyramid::ReliefPyramid(std::vector<Four> nodes, int nx, int ny) {
  levels_.emplace_back(std::move(nodes), nx, ny, 0);
  for (int k = 1; levels_.back().nx > 4 && levels_.back().ny > 4; ++k) {
    const Level& fine = levels_.back();
    const int half_x = fine.nx / 2, half_y = fine.ny / 2;
    std::vector<Four> coarse;
    coarse.reserve(static_cast<std::size_t>(half_x) * half_y);
    for (int y = 0; y < half_y; ++y) {
      for (int x = 0; x < half_x; ++x) {
        const Four* from = &fine.nodes[static_cast<std::size_t>(2 * y) * fine.nx + 2 * x];
        coarse.push_back(0.25f * (from[0] + from[1] + from[fine.nx] + from[fine.nx + 1]));
      }
    }
    levels_.emplace_back(std::move(coarse), half_x, half_y, k);
  }
}

}  // namespace dockyard
