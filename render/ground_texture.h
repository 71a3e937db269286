// What the ground looks like where geometry ends: slopes and own shadow of the height grid, grain,
// pebbles and lumps of the soil, each as a pyramid of ever coarser pictures. No GL.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/flat_view.h"
#include "render/scene.h"
#include "render/shading.h"
#include "render/sun_shadow.h"

namespace dockyard {

/// Four numbers side by side; the compiler keeps them in one register.
typedef float Four __attribute__((vector_size(16)));

/// Pictures of four bytes a texel, each half the size of the one before; they repeat.
class SoilPyramid {
 public:
  SoilPyramid() = default;
  /// side: a power of two.
  SoilPyramid(std::vector<std::uint8_t> texels, int side);
  /// At (u, v) in tiles, between the levels next to lod (0: the finest).
  Four At(float u, float v, float lod) const;
  /// Bilinear in the finest level.
  Four Finest(float u, float v) const { return Bilinear(levels_.front(), u, v); }
  int top() const { return static_cast<int>(levels_.size()) - 1; }

 private:
  struct Level {
    int side = 0;
    std::vector<std::uint32_t> texels;
  };
  static Four Bilinear(const Level& level, float u, float v);
  std::vector<Level> levels_;
};

/// Slopes along x and y, share of the sun that the ground itself leaves, tone of the lumps.
class ReliefPyramid {
 public:
  ReliefPyramid() = default;
  ReliefPyramid(std::vector<Four> nodes, int nx, int ny);
  /// At grid coordinates (column, row), held at the border, in the level nearest to lod.
  Four At(float column, float row, float lod) const;

 private:
  struct Level {
    int nx = 0, ny = 0;
    std::vector<Four> nodes;
  };
  std::vector<Level> levels_;
};

/// Keeps its pyramids until the ground or the sun changes.
class GroundTexture {
 public:
  void Update(const GroundView& ground, const Eigen::Vector3d& to_sun_W, double sun_diameter_rad);

 private:
  friend class GroundShader;
  Four Lumps(float x_m, float y_m) const;

  ReliefPyramid relief_;
  SoilPyramid soil_, lumps_;
  std::optional<std::uint64_t> relief_key_, soil_seed_;
};

/// The ground's radiance for one camera.
class GroundShader {
 public:
  GroundShader(const GroundTexture& texture, const Scene& scene, const SunShadow& shadow,
               const Pose3& X_WC, Channel channel);
  /// A ray into the ground, and the ray next to it whose 1/z is known.
  struct Look {
    Tan tan, known;
  };
  /// Where the ray (tan, 1) meets the ground; inverse_depth: where its neighbour does. step_x,
  /// step_y: the ray's change from pixel to pixel along and down the picture; turn: see SunShadow.
  float operator()(const Look& look, float inverse_depth, Tan step_x, Tan step_y, int turn) const;

 private:
  const GroundTexture& texture_;
  const SunShadow& shadow_;
  Eigen::Vector2f p_GC_;
  Eigen::Matrix<float, 2, 3> to_level_;  // camera axes to the site's x and y
  Eigen::Matrix3f R_UC_, R_UG_;
  Eigen::Vector3f p_UC_, up_C_, sun_G_, up_G_;
  float x0_, y0_, per_cell_, cell_, cell_log_;
  float last_column_, last_row_;
  float sun_, sky_, bounce_;
};

}  // namespace dockyard
