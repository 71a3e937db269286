// Shapes in plan.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace dockyard {

/// Corners of an area in order, either way round; the last one is joined to the first.
using Polygon = std::vector<Eigen::Vector2d>;

struct Disc {
  Eigen::Vector2d centre{0, 0};
  double radius_m = 0.0;
};

/// In the frame in which paths are planned.
struct Obstacles {
  std::vector<Disc> discs{};
  std::vector<Polygon> polygons{};
};

}  // namespace dockyard
