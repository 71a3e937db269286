#include "render/ground_texture.h"

#include <algorithm>
#include <array>
#include <bit>

#include "render/ground_mesh.h"
#include "render/pixel_noise.h"

namespace dockyard {
namespace {

std::uint64_t ReliefKey(const GroundView& g, const Eigen::Vector3d& sun_G, double sun_diameter) {
  constexpr int kLanes = 4;  // side by side, for each waits for its last product
  std::array<std::uint64_t, kLanes> keys{};
  const auto add = [](std::uint64_t& key, double value) {
    key = (key ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15ull;
    key ^= key >> 32;
  };
  keys[0] = MixBits(g.revision + 1);
  for (const double v : {g.x0_m, g.y0_m, g.cell_m, double(g.nx), double(g.ny), sun_diameter,
                         sun_G.x(), sun_G.y(), sun_G.z()}) {
    add(keys[0], v);
  }
  const std::size_t count = static_cast<std::size_t>(g.nx) * g.ny;
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    for (int k = 0; k < kLanes; ++k) add(keys[k], g.heights_m[i + k]);
  }
  for (; i < count; ++i) add(keys[0], g.heights_m[i]);
  return SplitMix(SplitMix(keys[0], keys[1]), SplitMix(keys[2], keys[3]));
}

}  // namespace

// Slopes and tone wider than a tile: zero, zero, slopes first, tone last.
Four GroundTexture::Lumps(float x, float y) const {
  constexpr float kTile = static_cast<float>(kSoilTile_m);
  constexpr float kFull = static_cast<float>(kSoilSlopeFull);
  const float tx = 0.7986f * x - 0.6018f * y, ty = 0.6018f * x + 0.7986f * y;
  const Four wide = grain_ * Signed(lumps_.Finest(tx / (6.7f * kTile), ty / (6.7f * kTile)));
  const Four far = grain_ * Signed(lumps_.Finest(ty / (61.0f * kTile), tx / (61.0f * kTile)));
  return Four{0.5f * kFull * wide[1], 0.5f * kFull * wide[2], 0.0f,
              (1.0f + 0.6f * wide[0]) * (1.0f + 0.8f * far[0])};
}

void GroundTexture::KeepLumps(const GroundView& g) {
  const GridPlace place{g.x0_m, g.y0_m, g.cell_m, g.nx, g.ny};
  if (!cell_lumps_.empty() && place == lumps_of_) return;
  lumps_of_ = place;
  cell_lumps_.clear();
  for (int row = 0; row + 1 < g.ny; ++row) {
    for (int column = 0; column + 1 < g.nx; ++column) {
      const double x = g.x0_m + g.cell_m * (static_cast<double>(column) + 0.5);
      const double y = g.y0_m + g.cell_m * (static_cast<double>(row) + 0.5);
      cell_lumps_.push_back(Lumps(static_cast<float>(x), static_cast<float>(y)));
    }
  }
}

void GroundTexture::Update(const GroundView& ground, const Eigen::Vector3d& to_sun_W,
                           double sun_diameter_rad) {
  if (soil_seed_ != ground.texture_seed || largest_pebble_m_ != ground.largest_pebble_m) {
    const std::vector<std::uint8_t> texels =
        SoilTexture(ground.texture_seed, ground.largest_pebble_m);
    lumps_ = SoilPyramid(SoilLumps(texels), kLumpSide);
    soil_ = SoilPyramid(texels, kSoilSide);
    soil_seed_ = ground.texture_seed;
    largest_pebble_m_ = ground.largest_pebble_m;
    relief_key_.reset();
    cell_lumps_.clear();
  }
  if (const auto grain = static_cast<float>(ground.grain); grain_ != grain) {
    grain_ = grain;
    relief_key_.reset();
    cell_lumps_.clear();
  }
  const Eigen::Vector3d sun_G = ground.X_WG.R.transpose() * to_sun_W;
  const std::uint64_t key = ReliefKey(ground, sun_G, sun_diameter_rad);
  if (relief_key_ == key) return;
  const std::vector<float> relief = GroundRelief(ground, sun_G, sun_diameter_rad);
  const int columns = ground.nx - 1;
  KeepLumps(ground);
  std::vector<Four> cells(relief.size() / 3);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i] = Four{relief[3 * i], relief[3 * i + 1], relief[3 * i + 2], 0.0f} + cell_lumps_[i];
  }
  relief_ = ReliefPyramid(std::move(cells), columns, ground.ny - 1);
  relief_key_ = key;
  const std::size_t count = static_cast<std::size_t>(ground.nx) * ground.ny;
  highest_m_ = *std::max_element(ground.heights_m, ground.heights_m + count);
}

}  // namespace dockyard
