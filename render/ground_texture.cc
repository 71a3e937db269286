#include "render/ground_texture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "render/ground_mesh.h"
#include "render/pixel_noise.h"
#include "render/soil_texture.h"

namespace dockyard {
namespace {

// A footprint on the ground is long and narrow: by its length alone the grain would blur away.
constexpr float kSharper = 0.7f, kReliefSharper = 2.0f;
constexpr float kBias_m = 0.001f;
constexpr int kSearches = 4, kPoints = 8;  // of the sun's disc
constexpr float kFadeOut_m = 0.3f;         // of the relief beyond the grid's border

// Four bytes as four floats: interleaved twice with noughts, one instruction each on every x86-64.
Four Unpacked(std::uint32_t texel) {
  typedef std::uint8_t Bytes __attribute__((vector_size(16)));
  typedef std::uint16_t Words __attribute__((vector_size(16)));
  typedef std::int32_t Numbers __attribute__((vector_size(16)));
  const Bytes bytes = (Bytes)(Numbers{static_cast<std::int32_t>(texel), 0, 0, 0});
  const Words words = (Words)__builtin_shuffle(
      bytes, Bytes{}, Bytes{0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23});
  const Numbers numbers =
      (Numbers)__builtin_shuffle(words, Words{}, Words{0, 8, 1, 9, 2, 10, 3, 11});
  return __builtin_convertvector(numbers, Four);
}

Four Mix(Four a, Four b, float t) { return a + t * (b - a); }

// Brightness and slopes: 128 is nought, 127 steps are one.
Four Signed(Four texel) { return (texel - 128.0f) * (1.0f / 127.0f); }

// Within 0.09 of the binary logarithm: exponent, and the mantissa as a straight line.
float RoughLog2(float x) {
  return static_cast<float>(std::bit_cast<std::int32_t>(x) - 0x3f800000) * 0x1.0p-23f;
}

std::uint64_t ReliefKey(const GroundView& g, const Eigen::Vector3d& sun_G, double sun_diameter) {
  std::uint64_t key = MixBits(g.revision + 1);
  const auto add = [&](double value) {
    key = (key ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15ull;
    key ^= key >> 32;
  };
  for (const double v : {g.x0_m, g.y0_m, g.cell_m, double(g.nx), double(g.ny), sun_diameter,
                         sun_G.x(), sun_G.y(), sun_G.z()}) {
    add(v);
  }
  const std::size_t count = static_cast<std::size_t>(g.nx) * g.ny;
  for (std::size_t i = 0; i < count; ++i) add(g.heights_m[i]);
  return key;
}

}  // namespace

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

Four SoilPyramid::Bilinear(const Level& level, float u, float v) {
  // Far enough from nought that cutting off is rounding down, near enough to keep the fraction.
  const float x = u * static_cast<float>(level.side) - 0.5f;
  const float y = v * static_cast<float>(level.side) - 0.5f;
  int ix = static_cast<int>(x), iy = static_cast<int>(y);
  ix -= x < static_cast<float>(ix);
  iy -= y < static_cast<float>(iy);
  const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
  const int mask = level.side - 1;
  const int x0 = ix & mask, x1 = (ix + 1) & mask;
  const std::uint32_t* top = &level.texels[static_cast<std::size_t>(iy & mask) * level.side];
  const std::uint32_t* low = &level.texels[static_cast<std::size_t>((iy + 1) & mask) * level.side];
  return Mix(Mix(Unpacked(top[x0]), Unpacked(top[x1]), fx),
             Mix(Unpacked(low[x0]), Unpacked(low[x1]), fx), fy);
}

Four SoilPyramid::At(float u, float v, float lod) const {
  const float at = std::clamp(lod, 0.0f, static_cast<float>(top()) - 0.001f);
  const int level = static_cast<int>(at);
  return Mix(Bilinear(levels_[level], u, v), Bilinear(levels_[level + 1], u, v),
             at - static_cast<float>(level));
}

ReliefPyramid::ReliefPyramid(std::vector<Four> nodes, int nx, int ny) {
  levels_.push_back({.nx = nx, .ny = ny, .nodes = std::move(nodes)});
  while (levels_.back().nx > 4 && levels_.back().ny > 4) {
    const Level& fine = levels_.back();
    Level coarse{.nx = fine.nx / 2, .ny = fine.ny / 2, .nodes = {}};
    coarse.nodes.reserve(static_cast<std::size_t>(coarse.nx) * coarse.ny);
    for (int y = 0; y < coarse.ny; ++y) {
      for (int x = 0; x < coarse.nx; ++x) {
        const Four* from = &fine.nodes[static_cast<std::size_t>(2 * y) * fine.nx + 2 * x];
        coarse.nodes.push_back(0.25f * (from[0] + from[1] + from[fine.nx] + from[fine.nx + 1]));
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

Four ReliefPyramid::At(float column, float row, float lod) const {
  const int last = static_cast<int>(levels_.size()) - 1;
  const int k = std::clamp(static_cast<int>(lod + 0.5f), 0, last);
  const Level& level = levels_[k];
  const float scale = 1.0f / static_cast<float>(1 << k);
  // Node i of level k stands in the middle of 2^k nodes.
  const float shift = 0.5f * scale - 0.5f;
  const float x = std::clamp(column * scale + shift, 0.0f, static_cast<float>(level.nx) - 1.001f);
  const float y = std::clamp(row * scale + shift, 0.0f, static_cast<float>(level.ny) - 1.001f);
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
  const Four* top = &level.nodes[static_cast<std::size_t>(iy) * level.nx + ix];
  const Four* low = top + level.nx;
  return Mix(Mix(top[0], top[1], fx), Mix(low[0], low[1], fx), fy);
}

// Slopes and tone of what is wider than a tile: nought, nought, slopes first, tone last.
Four GroundTexture::Lumps(float x, float y) const {
  constexpr float kTile = static_cast<float>(kSoilTile_m);
  constexpr float kFull = static_cast<float>(kSoilSlopeFull);
  const float tx = 0.7986f * x - 0.6018f * y, ty = 0.6018f * x + 0.7986f * y;
  const Four wide = Signed(lumps_.Finest(tx / (6.7f * kTile), ty / (6.7f * kTile)));
  const Four far = Signed(lumps_.Finest(ty / (61.0f * kTile), tx / (61.0f * kTile)));
  return Four{0.5f * kFull * wide[1], 0.5f * kFull * wide[2], 0.0f,
              (1.0f + 0.6f * wide[0]) * (1.0f + 0.8f * far[0])};
}

void GroundTexture::Update(const GroundView& ground, const Eigen::Vector3d& to_sun_W,
                           double sun_diameter_rad) {
  if (soil_seed_ != ground.texture_seed) {
    const std::vector<std::uint8_t> texels = SoilTexture(ground.texture_seed);
    lumps_ = SoilPyramid(SoilLumps(texels), kLumpSide);
    soil_ = SoilPyramid(texels, kSoilSide);
    soil_seed_ = ground.texture_seed;
    relief_key_.reset();
  }
  const Eigen::Vector3d sun_G = ground.X_WG.R.transpose() * to_sun_W;
  const std::uint64_t key = ReliefKey(ground, sun_G, sun_diameter_rad);
  if (relief_key_ == key) return;
  const std::vector<float> relief = GroundRelief(ground, sun_G, sun_diameter_rad);
  const int columns = ground.nx - 1;
  std::vector<Four> cells(relief.size() / 3);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double x = ground.x0_m + ground.cell_m * (static_cast<double>(i % columns) + 0.5);
    const double y = ground.y0_m + ground.cell_m * (static_cast<double>(i / columns) + 0.5);
    cells[i] = Four{relief[3 * i], relief[3 * i + 1], relief[3 * i + 2], 0.0f} +
               Lumps(static_cast<float>(x), static_cast<float>(y));
  }
  relief_ = ReliefPyramid(std::move(cells), columns, ground.ny - 1);
  relief_key_ = key;
}

GroundShader::GroundShader(const GroundTexture& texture, const Scene& scene,
                           const SunShadow& shadow, const Pose3& X_WC, Channel channel)
    : texture_(texture), shadow_(shadow) {
  const Pose3 X_UC = Inverse(shadow.fit().X_WU) * X_WC;
  R_UC_ = X_UC.R.cast<float>();
  p_UC_ = X_UC.p.cast<float>();
  R_UG_ = (shadow.fit().X_WU.R.transpose() * scene.ground.X_WG.R).cast<float>();
  const GroundView& ground = scene.ground;
  const Pose3 X_GC = Inverse(ground.X_WG) * X_WC;
  p_GC_ = X_GC.p.head<2>().cast<float>();
  to_level_ = X_GC.R.topRows<2>().cast<float>();
  up_C_ = X_WC.R.row(2).transpose().cast<float>();
  sun_G_ = (ground.X_WG.R.transpose() * scene.light.to_sun_W).cast<float>();
  up_G_ = ground.X_WG.R.row(2).transpose().cast<float>();
  x0_ = static_cast<float>(ground.x0_m);
  y0_ = static_cast<float>(ground.y0_m);
  cell_ = static_cast<float>(ground.cell_m);
  per_cell_ = 1.0f / cell_;
  cell_log_ = RoughLog2(cell_);
  last_column_ = static_cast<float>(ground.nx - 1);
  last_row_ = static_cast<float>(ground.ny - 1);
  const Reflected r = Reflect(scene.light, ground.albedo, channel);
  sun_ = static_cast<float>(r.sun);
  sky_ = static_cast<float>(r.sky);
  bounce_ = static_cast<float>(r.bounce);
}

float GroundShader::operator()(const Look& look, float inverse_depth, Tan step_x, Tan step_y,
                               int turn) const {
  // On level ground depths go inversely with how much a ray sinks in a metre of depth.
  const auto sunk = [&](Tan t) {
    return std::min(up_C_.x() * t.x + up_C_.y() * t.y + up_C_.z(), -1e-3f);
  };
  const Tan tan = look.tan;
  const float z = sunk(look.known) / (sunk(tan) * inverse_depth);
  const float x =
      p_GC_.x() + z * (to_level_(0, 0) * tan.x + to_level_(0, 1) * tan.y + to_level_(0, 2));
  const float y =
      p_GC_.y() + z * (to_level_(1, 0) * tan.x + to_level_(1, 1) * tan.y + to_level_(1, 2));
  // Length of the pixel's footprint on level ground: its ray sinks up_C . tan a metre of depth, and
  // a step that changes that sinking moves the point along the ray in proportion.
  const float sinking =
      std::max(std::abs(up_C_.x() * tan.x + up_C_.y() * tan.y + up_C_.z()), 1e-3f);
  const float tilt = std::max(std::abs(up_C_.x() * step_x.x + up_C_.y() * step_x.y),
                              std::abs(up_C_.x() * step_y.x + up_C_.y() * step_y.y));
  const float across =
      std::max(std::abs(step_x.x) + std::abs(step_x.y), std::abs(step_y.x) + std::abs(step_y.y));
  const float length = z * std::max(tilt / sinking * (1.0f + std::abs(tan.x)), across);
  const float lod_m = RoughLog2(length);  // of one metre

  constexpr float kTile = static_cast<float>(kSoilTile_m);
  constexpr float kTexelLog = -9.3219281f;  // of a texel, log2(1.6 / 1024)
  const float column = (x - x0_) * per_cell_, row = (y - y0_) * per_cell_;
  const float beyond = cell_ * std::max(std::max(std::max(-column, column - last_column_),
                                                 std::max(-row, row - last_row_)),
                                        0.0f);
  const Four level{0.0f, 0.0f, 1.0f, 0.0f};
  Four relief;
  if (beyond < kFadeOut_m) {
    // Of a footprint that is long and narrow the relief keeps more than its length would leave.
    const float relief_lod = std::max(RoughLog2(z * across), lod_m - kReliefSharper) - cell_log_;
    relief = texture_.relief_.At(column - 0.5f, row - 0.5f, relief_lod);
    if (beyond > 0.0f) {
      const float t = beyond / kFadeOut_m;
      relief = Mix(relief, level + texture_.Lumps(x, y), t * t * (3.0f - 2.0f * t));
    }
  } else {
    relief = level + texture_.Lumps(x, y);
  }
  const Four close = Signed(texture_.soil_.At(x / kTile, y / kTile, lod_m - kTexelLog - kSharper));
  constexpr float kFull = static_cast<float>(kSoilSlopeFull);
  const float sx = relief[0] + kFull * close[1];
  const float sy = relief[1] + kFull * close[2];
  const float shorten = 1.0f / std::sqrt(1.0f + sx * sx + sy * sy);
  const float to_sun = (sun_G_.z() - sx * sun_G_.x() - sy * sun_G_.y()) * shorten;
  const float to_zenith = (up_G_.z() - sx * up_G_.x() - sy * up_G_.y()) * shorten;
  const float tone = (1.0f + close[0]) * relief[3];
  const float open = std::clamp(0.92f + 0.5f * close[3], 0.7f, 1.0f);
  float share = 0.0f;
  if (to_sun > 0.0f && relief[2] > 0.0f) {
    const float length = std::sqrt(1.0f + relief[0] * relief[0] + relief[1] * relief[1]);
    const Eigen::Vector3f n_U =
        R_UG_ * Eigen::Vector3f(-relief[0] / length, -relief[1] / length, 1.0f / length);
    const SunShadow::Place place{.p = p_UC_ + R_UC_ * Eigen::Vector3f(z * tan.x, z * tan.y, z),
                                 .n = n_U,
                                 .bias_m = kBias_m,
                                 .blur_m = 0.5f * z * across,
                                 .turn = turn};
    share = relief[2] * shadow_.Share(place, kSearches, kPoints);
  }
  return tone * Shade(sun_, sky_ * open, bounce_ * open, to_sun, to_zenith, share);
}

}  // namespace dockyard
