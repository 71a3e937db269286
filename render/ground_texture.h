// The ground's detail finer than its geometry: slopes and own shadow of the height grid, grain,
// pebbles and lumps of the soil. No GL.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/ground_pyramids.h"
#include "render/scene.h"
#include "render/soil_texture.h"

namespace dockyard {

/// Keeps its pyramids until the ground or the sun changes.
class GroundTexture {
 public:
  void Update(const GroundView& ground, const Eigen::Vector3d& to_sun_W, double sun_diameter_rad);

  /// At the middles of the grid's cells.
  const ReliefPyramid& relief() const { return relief_; }
  /// Brightness, slopes and height of the grain; see soil_texture.h.
  const SoilPyramid& soil() const { return soil_; }
  /// Contrast of grain and lumps.
  float grain() const { return grain_; }
  /// Of the grid.
  double highest_m() const { return highest_m_; }
  /// Relief of level ground in full sun beyond the grid.
  Four Beyond(float x_m, float y_m) const { return Four{0.0f, 0.0f, 1.0f, 0.0f} + Lumps(x_m, y_m); }
  /// Brightness and slopes of a texel: 128 is zero, 127 steps are one.
  static Four Signed(Four texel) { return (texel - 128.0f) * (1.0f / 127.0f); }

 private:
  struct GridPlace {
    double x0_m = 0.0, y0_m = 0.0, cell_m = 0.0;
    int nx = 0, ny = 0;
    bool operator==(const GridPlace&) const = default;
  };

  Four Lumps(float x_m, float y_m) const;
  /// Those of the grid's cells, which do not change with the heights.
  void KeepLumps(const GroundView& ground);

  ReliefPyramid relief_;
  SoilPyramid soil_, lumps_;
  double highest_m_ = 0.0;
  float grain_ = 1.0f;
  double largest_pebble_m_ = kAllPebbles_m;
  GridPlace lumps_of_;
  std::vector<Four> cell_lumps_;
  std::optional<std::uint64_t> relief_key_, soil_seed_;
};

}  // namespace dockyard
