// The ground as drawn for one place: a fan of rings, fine near and coarse far. Plain arithmetic, no
// GL.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/scene.h"

namespace dockyard {

/// Throws std::invalid_argument for a grid that cannot be drawn (size, cell, heights not finite).
void RequireSoundGround(const GroundView& ground);

/// Whether there is any ground to draw.
inline bool HasGround(const GroundView& ground) { return ground.nx > 0 && ground.ny > 0; }

/// Whether all heights of a ground that there is are the same.
bool IsLevel(const GroundView& ground);

/// Height of the ground in G: bilinear on the grid; outside the border's height, which falls off to
/// the border's mean within a few metres.
class GroundHeight {
 public:
  explicit GroundHeight(const GroundView& ground);
  double operator()(double x_m, double y_m) const;

 private:
  const GroundView& ground_;
  double border_mean_m_ = 0.0;
};

/// A part of the fan, and how fine it is.
inline constexpr int kGroundSectors = 600;
struct FanPart {
  int first = 0, count = kGroundSectors;  // sectors first, first + 1, ... (modulo kGroundSectors)
  int step = 1;                           // sectors that are drawn as one
  double least_ring_m = 0.014;            // between rings near the pole
  double ring_per_r2 = 0.02;              // the same over the square of the distance [1/m]
};

/// Fan of rings; positions relative to (pole_x, pole_y, 0) in G's axes: the pole, then the rings of
/// azimuth 2 pi first / kGroundSectors, those of the next spoke, ... Triangles sector by sector, as
/// many in each.
struct GroundFan {
  double pole_x_m = 0.0, pole_y_m = 0.0;
  int rings = 0;
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::uint32_t> indices;
};
GroundFan MakeGroundFan(const GroundHeight& height, double pole_x_m, double pole_y_m,
                        const FanPart& part = {});

}  // namespace dockyard
