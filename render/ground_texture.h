// The ground's detail finer than its geometry: slopes and own shadow of the height grid, grain,
// pebbles and lumps of the soil. No GL.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/ground_pyramids.h"
#include "render/ground_relief.h"
#include "render/scene.h"
#include "render/soil_texture.h"

namespace dockyard {

/// Keeps its pyramids from image to image; of a ground that has changed a little, little is made
/// anew.
class GroundTexture {
 public:
  void Update(const GroundView& ground, const Eigen::Vector3d& to_sun_W, double sun_diameter_rad);

  /// At the middles of the grid's cells.
  const ReliefPyramid& relief() const { return relief_; }
  /// Brightness, slopes and height of the grain; see soil_texture.h.
  const SoilPyramid& soil() const { return soil_; }
  /// Contrast of grain and lumps.
  float grain() const { return grain_; }
  /// Whether it is a level floor without grain, the same all over: relief is {0, 0, 1, 1}.
  bool plain() const { return plain_; }
  /// Of the grid.
  double highest_m() const { return heights_.highest_m(); }
  /// Relief of level ground in full sun beyond the grid.
  Four Beyond(float x_m, float y_m) const { return Four{0.0f, 0.0f, 1.0f, 0.0f} + Lumps(x_m, y_m); }
  /// Brightness and slopes of a texel: 128 is zero, 127 steps are one.
  static Four Signed(Four texel) { return (texel - 128.0f) * (1.0f / 127.0f); }

 private:
  Four Lumps(float x_m, float y_m) const;
  /// Those of the grid's cells, which do not change with the heights. Whether they are new.
  bool KeepLumps(const GroundView& ground);
  bool IsPlain(int columns, int rows) const;

  GroundRelief heights_;
  ReliefPyramid relief_;
  SoilPyramid soil_, lumps_;
  float grain_ = 1.0f;
  bool plain_ = false;
  double largest_pebble_m_ = kAllPebbles_m;
  GridPlace lumps_of_;
  std::vector<Four> cell_lumps_;
  std::optional<std::uint64_t> soil_seed_;
};

}  // namespace dockyard
