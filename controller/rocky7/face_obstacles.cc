#include "controller/rocky7/face_obstacles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "controller/stereo/ground_plane.h"

namespace dockyard::rocky7 {
namespace {

// An obstacle is this high over the ground and no higher (assumed, 5-8 cm and 0.6-1.5 m), in cells
// of such a side (assumed, 3-5 cm), of which images show this share: a few wrong pixels are none
// (assumed, 0.05-0.2).
constexpr double kObstacle_m = 0.06, kNoHigher_m = 1.2, kCell_m = 0.04, kAboutTarget_m = 0.8;
constexpr double kCellShare = 0.1;
constexpr int kTargetCells = 3;  // to either side of the target; assumed, 2-4
// From further away heights over the ground are not sure enough. Assumed, 2-3 m.
constexpr double kObstaclesWithin_m = 2.5;

// One pixel in three along rows and columns is enough for the ground. Assumed, 2-6.
constexpr int kEach_px = 3;
// Not on the boulder itself; assumed, 0.4-0.7 m. With fewer points the plane of before counts;
// assumed, 100-500.
constexpr double kOffBoulder_m = 0.5;
constexpr int kLeastGround = 200;

// Height of the ground over E as (1, x, y) . plane: by the image itself, as the mast's joints err.
Eigen::Vector3d GroundOf(const FaceView& view, const Eigen::Vector2d& p_E) {
  std::vector<Eigen::Vector3d> points;
  for (int v = 0; v < view.disparities.height; v += kEach_px) {
    for (int u = 0; u < view.disparities.width; u += kEach_px) {
      const double disparity_px = view.disparities.at(u, v);
      if (!(disparity_px > 0.0)) continue;
      const Eigen::Vector3d p = view.pair.X_RC * view.pair.Point(u, v, disparity_px);
      const double away_m = (p.head<2>() - p_E).norm();
      if (away_m > kOffBoulder_m && away_m < kObstaclesWithin_m) points.push_back(p);
    }
  }
  const Eigen::Vector3d expected(0.0, view.ground_rise.x(), view.ground_rise.y());
  return FitGroundPlane(points, expected, kLeastGround).value_or(expected);
}

}  // namespace

std::vector<Eigen::Vector2d> ObstaclesAbout(const FaceView& view, const Eigen::Vector2d& p_E) {
  const double away_m = (view.pair.X_RC.p.head<2>() - p_E).norm();
  if (away_m > kObstaclesWithin_m) return {};
  const double across_px = view.pair.focal_px * kCell_m / std::max(0.3, away_m);
  const Eigen::Vector3d ground = GroundOf(view, p_E);
  using Cell = std::pair<int, int>;
  std::map<Cell, int> cells;
  for (int v = 0; v < view.disparities.height; ++v) {
    for (int u = 0; u < view.disparities.width; ++u) {
      const double disparity_px = view.disparities.at(u, v);
      if (!(disparity_px > 0.0)) continue;
      const Eigen::Vector3d p = view.pair.X_RC * view.pair.Point(u, v, disparity_px);
      const Eigen::Vector2d from = p.head<2>() - p_E;
      const double up_m = p.z() - ground.dot(Eigen::Vector3d(1.0, p.x(), p.y()));
      if (up_m < kObstacle_m || up_m > kNoHigher_m || from.norm() > kAboutTarget_m) continue;
      ++cells[{static_cast<int>(std::floor(from.x() / kCell_m)),
               static_cast<int>(std::floor(from.y() / kCell_m))}];
    }
  }
  std::erase_if(cells,
                [&](const auto& cell) { return cell.second < kCellShare * across_px * across_px; });
  // The boulder is connected with the target; a cell alone is a wrong range.
  std::vector<Cell> found;
  const auto take = [&](const Cell& cell) {
    if (cells.erase(cell) > 0) found.push_back(cell);
  };
  for (int x = -kTargetCells; x < kTargetCells; ++x) {
    for (int y = -kTargetCells; y < kTargetCells; ++y) take({x, y});
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) take({found[i].first + dx, found[i].second + dy});
    }
  }
  std::vector<Eigen::Vector2d> middles;
  for (const Cell& cell : found) {
    middles.push_back(p_E + kCell_m * Eigen::Vector2d(cell.first + 0.5, cell.second + 0.5));
  }
  return middles;
}

}  // namespace dockyard::rocky7
