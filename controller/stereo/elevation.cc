#include "controller/stereo/elevation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "controller/base/check.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

struct Point {
  int cell = 0;
  double height_m = 0.0, sigma_m = 0.0;
};

// How far a point's height goes with its disparity: it moves along its ray.
double SigmaUp(const RectifiedPair& pair, const Vector3d& p_C, const Vector3d& up_C,
               double sigma_px) {
  const double depth_per_px = p_C.z() * p_C.z() / (pair.focal_px * pair.baseline_m);
  return std::abs(up_C.dot(p_C / p_C.z())) * depth_per_px * sigma_px;
}

// Of points sorted by height.
double Median(const std::vector<Point>& points, std::size_t first, std::size_t count) {
  const std::size_t middle = first + count / 2;
  return count % 2 == 1 ? points[middle].height_m
                        : 0.5 * (points[middle - 1].height_m + points[middle].height_m);
}

}  // namespace

Pose3 FrameOn(const Plane& ground_R) {
  const Vector3d z = ground_R.normal.normalized();
  const Vector3d ahead = Vector3d::UnitX() - z * z.x();
  if (ahead.norm() < 1e-3) throw std::invalid_argument("the ground must not face ahead");
  Pose3 X_RE;
  X_RE.R.col(0) = ahead.normalized();
  X_RE.R.col(1) = z.cross(X_RE.R.col(0));
  X_RE.R.col(2) = z;
  X_RE.p = ground_R.offset_m * z;
  return X_RE;
}

ElevationMap MapHeights(const RectifiedPair& pair, const Disparities& disparities,
                        const Plane& ground_R, int block_px, const ElevationSettings& settings) {
  ElevationMap map;
  map.X_RE = FrameOn(ground_R);
  map.cell_m = settings.cell_m;
  map.nx = static_cast<int>(std::ceil((settings.x_high_m - settings.x_low_m) / map.cell_m));
  map.ny = static_cast<int>(std::ceil((settings.y_high_m - settings.y_low_m) / map.cell_m));
  DOCKYARD_CHECK(map.cell_m > 0.0 && map.nx > 0 && map.ny > 0);
  map.x0_m = settings.x_low_m + 0.5 * map.cell_m;
  map.y0_m = settings.y_low_m + 0.5 * map.cell_m;
  const Pose3 X_EC = Inverse(map.X_RE) * pair.X_RC;
  const Vector3d up_C = X_EC.R.row(2).transpose();
  std::vector<Point> points;
  for (int v = 0; v < disparities.height; ++v) {
    for (int u = 0; u < disparities.width; ++u) {
      const float disparity = disparities.at(u, v);
      if (!(disparity > 0.0F)) continue;
      const Vector3d p_C = pair.Point(u, v, disparity), p_E = X_EC * p_C;
      const double ix = std::floor((p_E.x() - settings.x_low_m) / map.cell_m);
      const double iy = std::floor((p_E.y() - settings.y_low_m) / map.cell_m);
      if (ix < 0 || iy < 0 || ix >= map.nx || iy >= map.ny) continue;
      points.push_back({static_cast<int>(iy) * map.nx + static_cast<int>(ix), p_E.z(),
                        SigmaUp(pair, p_C, up_C, settings.disparity_sigma_px)});
    }
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.height_m < b.height_m;
  });
  const auto cells = static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny);
  map.height_m.assign(cells, std::numeric_limits<float>::quiet_NaN());
  map.sigma_m = map.height_m;
  map.points.assign(cells, 0);
  for (std::size_t first = 0; first < points.size();) {
    std::size_t end = first;
    double sum = 0.0;
    for (; end < points.size() && points[end].cell == points[first].cell; ++end) {
      sum += points[end].sigma_m * points[end].sigma_m;
    }
    const std::size_t count = end - first, cell = static_cast<std::size_t>(points[first].cell);
    // Pixels that share a block share its error.
    const double apart = std::max(1.0, static_cast<double>(count) / (block_px * block_px));
    const double spread = points[end - 1].height_m - points[first].height_m;
    map.height_m[cell] = static_cast<float>(Median(points, first, count));
    map.sigma_m[cell] = static_cast<float>(
        std::sqrt(sum / static_cast<double>(count) / apart + spread * spread / 12.0 / apart));
    map.points[cell] = static_cast<int>(count);
    first = end;
  }
  return map;
}

}  // namespace dockyard
