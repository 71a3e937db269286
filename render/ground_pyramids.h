// Textures of the ground, each as a pyramid of ever coarser ones. No GL.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "render/four_floats.h"
#include "render/ground_relief.h"

namespace dockyard {

/// Within 0.09 of the binary logarithm: exponent, and the mantissa as a straight line.
inline float RoughLog2(float x) {
  return static_cast<float>(std::bit_cast<std::int32_t>(x) - 0x3f800000) * 0x1.0p-23f;
}

/// Textures of four bytes a texel, each half the size of the one before; they repeat.
class SoilPyramid {
 public:
  SoilPyramid() = default;
  /// side: a power of two.
  SoilPyramid(std::vector<std::uint8_t> texels, int side);
  /// At (u, v) in tiles, between the levels next to lod (0: the finest).
  Four At(float u, float v, float lod) const {
    const float at = std::clamp(lod, 0.0f, static_cast<float>(top()) - 0.001f);
    const int level = static_cast<int>(at);
    const Four fine = Bilinear(levels_[level], u, v);
    const float t = at - static_cast<float>(level);
    return t == 0.0f ? fine : Mix(fine, Bilinear(levels_[level + 1], u, v), t);
  }
  /// The same of many points, to the bit; at most kAtOnce.
  static constexpr int kAtOnce = 64;
  void At(const float* u, const float* v, const float* lod, int count, Four* texels) const;
  /// Bilinear in the finest level.
  Four Finest(float u, float v) const { return Bilinear(levels_.front(), u, v); }
  int top() const { return static_cast<int>(levels_.size()) - 1; }

 private:
  struct Level {
    int side = 0;
    std::vector<std::uint32_t> texels;
  };
  // Where points lie in levels, whole rows of texels before them, and between texels.
  struct Corners {
    std::int32_t x0[kAtOnce], x1[kAtOnce], top[kAtOnce], low[kAtOnce];
    float fx[kAtOnce], fy[kAtOnce];
  };
  void Find(const float* u, const float* v, const std::int32_t* level, int count,
            Corners& corners) const;
  // Four bytes as four floats: interleaved twice with zeros, one instruction each on every x86-64.
  static Four Unpacked(std::uint32_t texel) {
    typedef std::uint8_t Bytes __attribute__((vector_size(16)));
    typedef std::uint16_t Words __attribute__((vector_size(16)));
    typedef std::int32_t Numbers __attribute__((vector_size(16)));
    const Bytes bytes = (Bytes)(Numbers{static_cast<std::int32_t>(texel), 0, 0, 0});
    const Words words = (Words)__builtin_shufflevector(bytes, Bytes{}, 0, 16, 1, 17, 2, 18, 3, 19,
                                                       4, 20, 5, 21, 6, 22, 7, 23);
    const Numbers numbers =
        (Numbers)__builtin_shufflevector(words, Words{}, 0, 8, 1, 9, 2, 10, 3, 11);
    return __builtin_convertvector(numbers, Four);
  }
  static Four Bilinear(const Level& level, float u, float v) {
    // Far enough from zero that cutting off is rounding down, near enough to keep the fraction.
    const float x = u * static_cast<float>(level.side) - 0.5f;
    const float y = v * static_cast<float>(level.side) - 0.5f;
    int ix = static_cast<int>(x), iy = static_cast<int>(y);
    ix -= x < static_cast<float>(ix);
    iy -= y < static_cast<float>(iy);
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    const int mask = level.side - 1;
    const int x0 = ix & mask, x1 = (ix + 1) & mask;
    const std::uint32_t* top = &level.texels[static_cast<std::size_t>(iy & mask) * level.side];
    const std::uint32_t* low =
        &level.texels[static_cast<std::size_t>((iy + 1) & mask) * level.side];
    return Mix(Mix(Unpacked(top[x0]), Unpacked(top[x1]), fx),
               Mix(Unpacked(low[x0]), Unpacked(low[x1]), fx), fy);
  }
  std::vector<Level> levels_;
};

/// Slopes along x and y, share of the sun that the ground itself leaves, tone of the lumps.
class ReliefPyramid {
 public:
  ReliefPyramid() = default;
  ReliefPyramid(int nx, int ny);
  /// Nodes of the finest level anew, and all that is made of them: node(column, row).
  template <typename Node>
  void Fill(const GridRect& rect, const Node& node) {
    Level& finest = levels_.front();
    for (int y = rect.y_begin; y < rect.y_end; ++y) {
      for (int x = rect.x_begin; x < rect.x_end; ++x) {
        finest.nodes[static_cast<std::size_t>(y) * finest.nx + x] = node(x, y);
      }
    }
    FillCoarse(rect);
  }
  /// At grid coordinates (column, row), held at the border, in the level nearest to lod.
  Four At(float column, float row, float lod) const {
    const int last = static_cast<int>(levels_.size()) - 1;
    const int k = std::clamp(static_cast<int>(lod + 0.5f), 0, last);
    const Level& level = levels_[k];
    // Node i of level k stands in the middle of 2^k nodes.
    const float x = std::clamp(column * level.scale + level.shift, 0.0f, level.last_x);
    const float y = std::clamp(row * level.scale + level.shift, 0.0f, level.last_y);
    const int ix = static_cast<int>(x), iy = static_cast<int>(y);
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    const Four* top = &level.nodes[static_cast<std::size_t>(iy) * level.nx + ix];
    const Four* low = top + level.nx;
    return Mix(Mix(top[0], top[1], fx), Mix(low[0], low[1], fx), fy);
  }

 private:
  struct Level {
    Level(int x, int y, int k);
    std::vector<Four> nodes;
    int nx, ny;
    float scale, shift, last_x, last_y;  // from the finest level's coordinates to these
  };
  void FillCoarse(GridRect rect);
  std::vector<Level> levels_;
};

}  // namespace dockyard
