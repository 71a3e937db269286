#include "render/ground_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

constexpr double kFadeOut_m = 2.0;    // outside the grid, assumed: no yard ends in a cliff
constexpr double kHorizon_m = 300.0;  // a camera 0.4 m up sees it 0.08 deg below the level

// Near rings a little closer than the cells of the usual grid. Farther out by the square of the
// distance, for a camera 0.4 m up sees the ground ever flatter: about ten pixels apart at 650
// px/rad, because tiny triangles are slow. Detail finer than the rings is still in the relief that
// shades them.
std::vector<double> RingRadii(const FanPart& part) {
  std::vector<double> radii;
  for (double r = 0.04; r < 0.32; r += 0.04) radii.push_back(r);
  for (double r = 0.32; r < kHorizon_m;
       r += std::max(part.least_ring_m, part.ring_per_r2 * r * r)) {
    radii.push_back(r);
  }
  radii.push_back(kHorizon_m);
  return radii;
}

double BorderMean(const GroundView& g) {
  double sum = 0.0;
  for (int iy = 0; iy < g.ny; ++iy) {
    const double* row = g.heights_m + static_cast<std::size_t>(iy) * g.nx;
    const int step = iy == 0 || iy == g.ny - 1 ? 1 : g.nx - 1;
    for (int ix = 0; ix < g.nx; ix += step) sum += row[ix];
  }
  return sum / (2 * g.nx + 2 * g.ny - 4);
}

std::uint32_t VertexAt(const GroundFan& fan, int spoke, int ring) {
  return static_cast<std::uint32_t>(1 + spoke * fan.rings + ring);
}

}  // namespace

void RequireSoundGround(const GroundView& g) {
  if (!HasGround(g)) return;
  if (!g.heights_m) throw std::invalid_argument("ground: the grid has a size but no heights");
  if (g.nx < 3 || g.ny < 3) throw std::invalid_argument("ground: the grid needs 3 x 3 nodes");
  if (!(g.cell_m > 0.0) || !std::isfinite(g.cell_m + g.x0_m + g.y0_m)) {
    throw std::invalid_argument("ground: the cell must be positive and the origin finite");
  }
  const std::size_t count = static_cast<std::size_t>(g.nx) * g.ny;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(g.heights_m[i])) {
      throw std::invalid_argument("ground: height " + std::to_string(i) + " is not finite");
    }
  }
}

bool IsLevel(const GroundView& g) {
  const double* end = g.heights_m + static_cast<std::size_t>(g.nx) * g.ny;
  return std::all_of(g.heights_m, end, [&](double h) { return h == *g.heights_m; });
}

GroundHeight::GroundHeight(const GroundView& ground)
    : ground_(ground), border_mean_m_(BorderMean(ground)) {}

double GroundHeight::operator()(double x_m, double y_m) const {
  const GroundView& g = ground_;
  const double u = (x_m - g.x0_m) / g.cell_m, v = (y_m - g.y0_m) / g.cell_m;
  const double cu = std::clamp(u, 0.0, g.nx - 1.0), cv = std::clamp(v, 0.0, g.ny - 1.0);
  const int ix = std::min(static_cast<int>(cu), g.nx - 2);
  const int iy = std::min(static_cast<int>(cv), g.ny - 2);
  const double* h = g.heights_m + static_cast<std::size_t>(iy) * g.nx + ix;
  const double fx = cu - ix, fy = cv - iy;
  const double near_row = h[0] + fx * (h[1] - h[0]);
  const double far_row = h[g.nx] + fx * (h[g.nx + 1] - h[g.nx]);
  const double inside = near_row + fy * (far_row - near_row);
  const double outside_m = g.cell_m * std::hypot(u - cu, v - cv);
  if (outside_m == 0.0) return inside;
  const double fade = std::exp(-std::pow(outside_m / kFadeOut_m, 2));
  return border_mean_m_ + fade * (inside - border_mean_m_);
}

GroundFan MakeGroundFan(const GroundHeight& height, double pole_x_m, double pole_y_m,
                        const FanPart& part) {
  const std::vector<double> radii = RingRadii(part);
  GroundFan fan{.pole_x_m = pole_x_m,
                .pole_y_m = pole_y_m,
                .rings = static_cast<int>(radii.size()),
                .vertices = {},
                .indices = {}};
  const auto add = [&](double x, double y) {
    fan.vertices.push_back(Eigen::Vector3d(x, y, height(pole_x_m + x, pole_y_m + y)).cast<float>());
  };
  const int sectors = (part.count + part.step - 1) / part.step;
  const bool whole = part.count == kGroundSectors;
  const int spokes = whole ? sectors : sectors + 1;
  fan.vertices.reserve(1 + radii.size() * spokes);
  add(0.0, 0.0);
  for (int s = 0; s < spokes; ++s) {
    const double azimuth = 2.0 * kPi * (part.first + s * part.step) / kGroundSectors;
    const double c = std::cos(azimuth), sn = std::sin(azimuth);
    for (const double r : radii) add(r * c, r * sn);
  }
  for (int s = 0; s < sectors; ++s) {
    const int next = (s + 1) % spokes;
    fan.indices.insert(fan.indices.end(), {0u, VertexAt(fan, s, 0), VertexAt(fan, next, 0)});
    for (int r = 0; r + 1 < fan.rings; ++r) {
      const std::uint32_t a = VertexAt(fan, s, r), c = VertexAt(fan, next, r);
      fan.indices.insert(fan.indices.end(), {a, a + 1, c, c, a + 1, c + 1});
    }
  }
  return fan;
}

}  // namespace dockyard
