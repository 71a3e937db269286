#include "sim/soil/height_map.h"

#include <algorithm>

#include "controller/base/check.h"

namespace dockyard {

double HeightMap::Height(const Eigen::Vector2d& p_G) const {
  const Eigen::Vector2d p_M = Inverse(X_GM) * p_G;
  double fraction[2];
  int low[2], high[2];
  const auto locate = [&](int axis, double at, int count) {
    const double inside = std::clamp(at, 0.0, count - 1.0);
    low[axis] = static_cast<int>(inside);
    high[axis] = std::min(low[axis] + 1, count - 1);
    fraction[axis] = inside - low[axis];
  };
  locate(0, p_M.x() / cell_m + 0.5 * (columns - 1), columns);
  locate(1, -p_M.y() / cell_m + 0.5 * (rows - 1), rows);
  const auto at = [&](int column, int row) -> double {
    return heights_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)];
  };
  const auto across = [&](int row) {
    return at(low[0], row) + fraction[0] * (at(high[0], row) - at(low[0], row));
  };
  return across(low[1]) + fraction[1] * (across(high[1]) - across(low[1]));
}

void AddHeights(HeightGrid& grid, const HeightMap& map, double flat_radius_m) {
  DOCKYARD_CHECK(grid.undisturbed_m.empty());
  const double at_origin_m = map.Height({0.0, 0.0});
  for (int iy = 0; iy < grid.ny; ++iy) {
    for (int ix = 0; ix < grid.nx; ++ix) {
      const Eigen::Vector2d p(grid.x0_m + ix * grid.cell_m, grid.y0_m + iy * grid.cell_m);
      const double weight = ReliefWeight(p.norm(), flat_radius_m);
      const std::size_t index = static_cast<std::size_t>(iy) * grid.nx + ix;
      if (weight > 0.0) grid.heights_m[index] += weight * (map.Height(p) - at_origin_m);
    }
  }
}

}  // namespace dockyard
