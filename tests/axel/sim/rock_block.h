// A rock with level and upright sides, for tests.
#pragma once

#include "sim/rigid/convex_body.h"

namespace dockyard::axel {

/// A block with its top at z, between two corners.
inline ConvexBody Block(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double top_m) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                        i & 4 ? top_m : top_m - 0.5);
  }
  return HullOf(points);
}

}  // namespace dockyard::axel
