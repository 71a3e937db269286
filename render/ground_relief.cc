#include "render/ground_relief.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace dockyard {
namespace {

constexpr int kMaxMarch = 64;  // nodes towards the sun; shadows of ruts are shorter

}  // namespace

GridPlace PlaceOf(const GroundView& g) { return {g.x0_m, g.y0_m, g.cell_m, g.nx, g.ny}; }

GroundRelief::March GroundRelief::MarchToSun(double cell_m, const Eigen::Vector3d& sun_G,
                                             double relief_m) {
  March march;
  const double level = std::hypot(sun_G.x(), sun_G.y());
  if (level < 1e-9) return march;
  const double slope = sun_G.z() / level;
  const double ux = sun_G.x() / level, uy = sun_G.y() / level;
  const double stride = cell_m / std::max(std::abs(ux), std::abs(uy));
  for (int i = 1; i <= kMaxMarch; ++i) {
    const double distance = i * stride;
    if (distance * slope > relief_m) break;
    march.dx.push_back(static_cast<int>(std::lround(distance * ux / cell_m)));
    march.dy.push_back(static_cast<int>(std::lround(distance * uy / cell_m)));
    march.rise_m.push_back(distance * slope);
    march.distance_m.push_back(distance);
  }
  return march;
}

double GroundRelief::SunShare(int ix, int iy) const {
  const int nx = place_.nx, ny = place_.ny;
  const double here = heights_m_[static_cast<std::size_t>(iy) * nx + ix];
  double share = 1.0;
  for (std::size_t i = 0; i < march_.dx.size(); ++i) {
    const int x = ix + march_.dx[i], y = iy + march_.dy[i];
    if (x < 0 || y < 0 || x >= nx || y >= ny) break;
    const double over = heights_m_[static_cast<std::size_t>(y) * nx + x] - here - march_.rise_m[i];
    if (over < -2.0 * sun_rise_ * march_.distance_m[i]) continue;
    // The horizon there against the sun's disc, which counts as a uniform strip.
    const double covered = 0.5 + 0.5 * over / (sun_rise_ * march_.distance_m[i]);
    share = std::min(share, std::clamp(1.0 - covered, 0.0, 1.0));
    if (share == 0.0) break;
  }
  return share;
}

GridRect GroundRelief::ChangedNodes(const double* heights_m) const {
  GridRect changed{.x_begin = place_.nx, .x_end = 0, .y_begin = place_.ny, .y_end = 0};
  const std::size_t nx = static_cast<std::size_t>(place_.nx);
  for (int iy = 0; iy < place_.ny; ++iy) {
    const double *now = heights_m + iy * nx, *before = heights_m_.data() + iy * nx;
    const auto differs = [&](int ix) { return std::memcmp(now + ix, before + ix, 8) != 0; };
    if (std::memcmp(now, before, nx * sizeof(double)) == 0) continue;
    changed.y_begin = std::min(changed.y_begin, iy);
    changed.y_end = iy + 1;
    int first = 0, end = place_.nx;
    while (first < changed.x_begin && !differs(first)) ++first;
    while (end > changed.x_end && !differs(end - 1)) --end;
    changed.x_begin = first;
    changed.x_end = end;
  }
  return changed;
}

GridRect GroundRelief::InTheirShadow(const GridRect& nodes) const {
  GridRect dark = nodes;
  for (std::size_t i = 0; i < march_.dx.size(); ++i) {
    dark.x_begin = std::min(dark.x_begin, nodes.x_begin - march_.dx[i]);
    dark.x_end = std::max(dark.x_end, nodes.x_end - march_.dx[i]);
    dark.y_begin = std::min(dark.y_begin, nodes.y_begin - march_.dy[i]);
    dark.y_end = std::max(dark.y_end, nodes.y_end - march_.dy[i]);
  }
  return {.x_begin = std::max(dark.x_begin, 0),
          .x_end = std::min(dark.x_end, place_.nx),
          .y_begin = std::max(dark.y_begin, 0),
          .y_end = std::min(dark.y_end, place_.ny)};
}

GridRect GroundRelief::Update(const GroundView& g, const Eigen::Vector3d& sun_G,
                              double sun_angular_diameter_rad) {
  const GridPlace place = PlaceOf(g);
  const bool known =
      place == place_ && sun_G == sun_G_ && sun_angular_diameter_rad == sun_diameter_rad_;
  GridRect nodes{.x_begin = 0, .x_end = g.nx, .y_begin = 0, .y_end = g.ny};
  if (known) {
    nodes = ChangedNodes(g.heights_m);
    if (nodes.empty()) return {};
  }
  place_ = place;
  sun_G_ = sun_G;
  sun_diameter_rad_ = sun_angular_diameter_rad;
  heights_m_.assign(g.heights_m, g.heights_m + static_cast<std::size_t>(g.nx) * g.ny);
  const double level = sun_G.head<2>().norm();
  sun_rise_ = std::max(0.5 * sun_angular_diameter_rad, 1e-4) / std::max(level * level, 1e-4);
  const auto [low, high] = std::minmax_element(heights_m_.begin(), heights_m_.end());
  highest_m_ = *high;
  March march = MarchToSun(g.cell_m, sun_G, *high - *low);
  // How far the march goes depends on the highest and the lowest node of all.
  if (known && march.dx.size() != march_.dx.size()) nodes = {0, g.nx, 0, g.ny};
  march_ = std::move(march);
  shares_.resize(heights_m_.size());
  const GridRect dark = InTheirShadow(nodes);
  for (int iy = dark.y_begin; iy < dark.y_end; ++iy) {
    for (int ix = dark.x_begin; ix < dark.x_end; ++ix) {
      shares_[static_cast<std::size_t>(iy) * g.nx + ix] = static_cast<float>(SunShare(ix, iy));
    }
  }
  // A cell has its own node and the next in each direction.
  return {.x_begin = std::max(dark.x_begin - 1, 0),
          .x_end = std::min(dark.x_end, g.nx - 1),
          .y_begin = std::max(dark.y_begin - 1, 0),
          .y_end = std::min(dark.y_end, g.ny - 1)};
}

GroundRelief::Cell GroundRelief::At(int column, int row) const {
  const std::size_t nx = static_cast<std::size_t>(place_.nx);
  const std::size_t at = row * nx + column;
  const double *h = &heights_m_[at], *k = h + nx;
  const float *s = &shares_[at], *t = s + nx;
  return {.slope_x = static_cast<float>((h[1] - h[0] + k[1] - k[0]) / (2.0 * place_.cell_m)),
          .slope_y = static_cast<float>((k[0] - h[0] + k[1] - h[1]) / (2.0 * place_.cell_m)),
          .sun_share = 0.25f * (s[0] + s[1] + t[0] + t[1])};
}

}  // namespace dockyard
