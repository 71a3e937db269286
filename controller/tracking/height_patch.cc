#include "controller/tracking/height_patch.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace dockyard {

using Eigen::Vector2d;
using Eigen::Vector3d;

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

HeightPatch PatchOf(const ElevationMap& map, const Pose2& X_ET, double half_m, double step_m) {
  HeightPatch patch;
  const int steps = static_cast<int>(std::lround(half_m / step_m));
  for (int iy = -steps; iy <= steps; ++iy) {
    for (int ix = -steps; ix <= steps; ++ix) {
      ++patch.places;
      const Vector2d p_T(ix * step_m, iy * step_m);
      const auto at = Bilinear(map, X_ET * p_T);
      if (at) patch.cells.push_back({p_T, at->height_m, at->variance_m2});
    }
  }
  return patch;
}

Vector3d PlaneThrough(const std::vector<HeightPatch::Cell>& cells) {
  Eigen::Matrix3d normal = 1e-12 * Eigen::Matrix3d::Identity();
  Vector3d right = Vector3d::Zero();
  for (const HeightPatch::Cell& cell : cells) {
    const Vector3d row(1.0, cell.p_T.x(), cell.p_T.y());
    normal += row * row.transpose() / cell.variance_m2;
    right += row * cell.height_m / cell.variance_m2;
  }
  return normal.ldlt().solve(right);
}

double HeightPatch::Relief() const {
  if (cells.size() < 4) return 0.0;
  const Vector3d plane = PlaneThrough(cells);
  double squares = 0.0, noise = 0.0;
  for (const Cell& cell : cells) {
    const double off = cell.height_m - plane.dot(Vector3d(1.0, cell.p_T.x(), cell.p_T.y()));
    squares += off * off;
    noise += cell.variance_m2;
  }
  return std::sqrt(std::max(0.0, squares - noise) / static_cast<double>(cells.size()));
}

}  // namespace dockyard
