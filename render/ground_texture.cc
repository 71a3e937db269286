#include "render/ground_texture.h"

namespace dockyard {

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

bool GroundTexture::KeepLumps(const GroundView& g) {
  const GridPlace place = PlaceOf(g);
  if (!cell_lumps_.empty() && place == lumps_of_) return false;
  lumps_of_ = place;
  cell_lumps_.clear();
  for (int row = 0; row + 1 < g.ny; ++row) {
    for (int column = 0; column + 1 < g.nx; ++column) {
      const double x = g.x0_m + g.cell_m * (static_cast<double>(column) + 0.5);
      const double y = g.y0_m + g.cell_m * (static_cast<double>(row) + 0.5);
      cell_lumps_.push_back(Lumps(static_cast<float>(x), static_cast<float>(y)));
    }
  }
  return true;
}

bool GroundTexture::IsPlain(int columns, int rows) const {
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const GroundRelief::Cell cell = heights_.At(column, row);
      if (cell.slope_x != 0.0f || cell.slope_y != 0.0f || cell.sun_share != 1.0f) return false;
    }
  }
  return true;
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
    cell_lumps_.clear();
  }
  if (const auto grain = static_cast<float>(ground.grain); grain_ != grain) {
    grain_ = grain;
    cell_lumps_.clear();
  }
  const Eigen::Vector3d sun_G = ground.X_WG.R.transpose() * to_sun_W;
  GridRect changed = heights_.Update(ground, sun_G, sun_diameter_rad);
  const int columns = ground.nx - 1, rows = ground.ny - 1;
  if (KeepLumps(ground)) {
    relief_ = ReliefPyramid(columns, rows);
    changed = {.x_begin = 0, .x_end = columns, .y_begin = 0, .y_end = rows};
  }
  if (changed.empty()) return;
  relief_.Fill(changed, [&](int column, int row) {
    const GroundRelief::Cell cell = heights_.At(column, row);
    return Four{cell.slope_x, cell.slope_y, cell.sun_share, 0.0f} +
           cell_lumps_[static_cast<std::size_t>(row) * columns + column];
  });
  plain_ = grain_ == 0.0f && IsPlain(columns, rows);
}

}  // namespace dockyard
