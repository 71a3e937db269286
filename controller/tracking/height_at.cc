#include "controller/tracking/height_at.h"

#include <cmath>

namespace dockyard {

using Eigen::Vector2d;

std::optional<HeightAt> Bilinear(const ElevationMap& map, const Vector2d& p_E) {
  const double x = (p_E.x() - map.x0_m) / map.cell_m, y = (p_E.y() - map.y0_m) / map.cell_m;
  const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
  if (ix < 0 || iy < 0 || ix + 1 >= map.nx || iy + 1 >= map.ny) return std::nullopt;
  HeightAt at;
  for (int corner = 0; corner < 4; ++corner) {
    const int to_x = corner & 1, to_y = corner >> 1;
    const auto cell = static_cast<std::size_t>((iy + to_y) * map.nx + ix + to_x);
    if (map.points[cell] == 0) return std::nullopt;
    const double share = (to_x ? x - ix : 1.0 - x + ix) * (to_y ? y - iy : 1.0 - y + iy);
    const double sigma = static_cast<double>(map.sigma_m[cell]);
    at.height_m += share * static_cast<double>(map.height_m[cell]);
    at.variance_m2 += share * sigma * sigma;
  }
  return at;
}

}  // namespace dockyard
