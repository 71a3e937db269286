#include "controller/tracking/local_maximum.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

struct Window {
  int x_low = 0, x_high = 0, y_low = 0, y_high = 0;  // cells, both ends within
};

Window WindowOf(const ElevationMap& map, const Eigen::Vector2d& p_E, double half_m) {
  const auto Cell = [&](double at, double first, int count) {
    return std::clamp(static_cast<int>(std::lround((at - first) / map.cell_m)), 0, count - 1);
  };
  return {Cell(p_E.x() - half_m, map.x0_m, map.nx), Cell(p_E.x() + half_m, map.x0_m, map.nx),
          Cell(p_E.y() - half_m, map.y0_m, map.ny), Cell(p_E.y() + half_m, map.y0_m, map.ny)};
}

std::optional<double> Known(const ElevationMap& map, int ix, int iy) {
  const auto cell = static_cast<std::size_t>(iy * map.nx + ix);
  if (map.points[cell] == 0) return std::nullopt;
  return static_cast<double>(map.height_m[cell]);
}

// Between the nearest known cells either way along x, or along y.
std::optional<double> Between(const ElevationMap& map, const Window& window, int ix, int iy,
                              bool along_x) {
  std::optional<double> ends[2];
  int away[2] = {0, 0};
  for (const int side : {0, 1}) {
    const int step = side == 0 ? -1 : 1;
    for (int k = 1; !ends[side]; ++k) {
      const int x = along_x ? ix + step * k : ix, y = along_x ? iy : iy + step * k;
      if (x < window.x_low || x > window.x_high || y < window.y_low || y > window.y_high) break;
      ends[side] = Known(map, x, y);
      away[side] = k;
    }
  }
  if (!ends[0] || !ends[1]) return std::nullopt;
  return (*ends[0] * away[1] + *ends[1] * away[0]) / (away[0] + away[1]);
}

std::optional<double> Filled(const ElevationMap& map, const Window& window, int ix, int iy) {
  const auto row = Between(map, window, ix, iy, true), column = Between(map, window, ix, iy, false);
  if (row && column) return 0.5 * (*row + *column);
  return row ? row : column;
}

}  // namespace

std::optional<TrackedTop> HighestInWindow(const ElevationMap& map, const Eigen::Vector2d& p_E,
                                          const LocalMaximumSettings& settings) {
  const Window window = WindowOf(map, p_E, settings.window_m);
  std::optional<TrackedTop> top;
  for (int iy = window.y_low; iy <= window.y_high; ++iy) {
    for (int ix = window.x_low; ix <= window.x_high; ++ix) {
      const std::optional<double> known = Known(map, ix, iy);
      const std::optional<double> height = known ? known : Filled(map, window, ix, iy);
      if (!height || (top && *height <= top->height_m)) continue;
      top = TrackedTop{{map.x0_m + ix * map.cell_m, map.y0_m + iy * map.cell_m}, *height, !known};
    }
  }
  return top;
}

}  // namespace dockyard
