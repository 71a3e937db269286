#include "controller/rocky7/face_obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
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
// Cells are in layers of this height. Assumed, 8-15 cm: a boulder's side has gaps in the shade, and
// a wrong range is further up or down.
constexpr double kLayer_m = 0.1;
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

using Cell = std::array<int, 3>;  // from the target: along x and y, and the layer

// Cells about the target that are higher than the ground and of which images show enough.
std::set<Cell> CellsOverGround(const FaceView& view, const Eigen::Vector3d& p_E, double away_m) {
  const double across_px = view.pair.focal_px * kCell_m / std::max(0.3, away_m);
  const Eigen::Vector3d ground = GroundOf(view, p_E.head<2>());
  const auto index = [](double at_m, double side_m) {
    return static_cast<int>(std::floor(at_m / side_m));
  };
  std::map<Cell, int> pixels;
  for (int v = 0; v < view.disparities.height; ++v) {
    for (int u = 0; u < view.disparities.width; ++u) {
      const double disparity_px = view.disparities.at(u, v);
      if (!(disparity_px > 0.0)) continue;
      const Eigen::Vector3d p = view.pair.X_RC * view.pair.Point(u, v, disparity_px);
      const Eigen::Vector3d from = p - p_E;
      const double up_m = p.z() - ground.dot(Eigen::Vector3d(1.0, p.x(), p.y()));
      if (up_m < kObstacle_m || up_m > kNoHigher_m) continue;
      if (from.head<2>().norm() > kAboutTarget_m) continue;
      ++pixels[{index(from.x(), kCell_m), index(from.y(), kCell_m), index(from.z(), kLayer_m)}];
    }
  }
  std::set<Cell> cells;
  for (const auto& [cell, count] : pixels) {
    if (count >= kCellShare * across_px * across_px) cells.insert(cell);
  }
  return cells;
}

// Those that are connected with the target; the others are removed.
std::vector<Cell> ConnectedWithTarget(std::set<Cell> cells) {
  std::vector<Cell> found;
  const auto take = [&](const Cell& cell) {
    if (cells.erase(cell) > 0) found.push_back(cell);
  };
  for (int x = -kTargetCells; x < kTargetCells; ++x) {
    for (int y = -kTargetCells; y < kTargetCells; ++y) {
      for (const int layer : {-1, 0}) take({x, y, layer});
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Cell at = found[i];
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int up = -1; up <= 1; ++up) take({at[0] + dx, at[1] + dy, at[2] + up});
      }
    }
  }
  return found;
}

}  // namespace

std::vector<Eigen::Vector2d> ObstaclesAbout(const FaceView& view, const Eigen::Vector3d& p_E) {
  const double away_m = (view.pair.X_RC.p - p_E).head<2>().norm();
  if (away_m > kObstaclesWithin_m) return {};
  std::set<std::pair<int, int>> places;
  for (const Cell& cell : ConnectedWithTarget(CellsOverGround(view, p_E, away_m))) {
    places.insert({cell[0], cell[1]});
  }
  std::vector<Eigen::Vector2d> middles;
  for (const auto& [x, y] : places) {
    middles.emplace_back(p_E.head<2>() + kCell_m * Eigen::Vector2d(x + 0.5, y + 0.5));
  }
  return middles;
}

}  // namespace dockyard::rocky7
