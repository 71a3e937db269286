#include "sim/rocky7/visible_stone.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace dockyard::rocky7 {

using Eigen::Vector3d;

StonesInView StonesAtStart(const WorldSetup& world, const Truth& truth) {
  StonesInView stones;
  stones.others_G = world.stones;
  stones.others_G.insert(stones.others_G.end(), world.loose_stones.begin(),
                         world.loose_stones.end());
  if (world.loose_target) {
    stones.target_G = truth.X_GT * *world.loose_target;
  } else {
    stones.target_G = stones.others_G.front();
    stones.others_G.erase(stones.others_G.begin());
  }
  return stones;
}

bool ShowsAnother(const StonesInView& stones, const Vector3d& from_G, const Vector3d& direction_G) {
  const auto target = RayEnters(stones.target_G, from_G, direction_G);
  return std::any_of(stones.others_G.begin(), stones.others_G.end(), [&](const ConvexBody& other) {
    const auto enters = RayEnters(other, from_G, direction_G);
    return enters && (!target || *enters < *target);
  });
}

std::optional<Vector3d> VisibleMiddle(const StonesInView& stones, const HeightGrid& ground_G,
                                      const Vector3d& from_G) {
  Vector3d sum = Vector3d::Zero();
  double area_m2 = 0.0;
  for (const auto& triangle : stones.target_G.triangles) {
    const auto& corners = stones.target_G.vertices;
    const Vector3d &a = corners[triangle[0]], &b = corners[triangle[1]], &c = corners[triangle[2]];
    const Vector3d middle = (a + b + c) / 3.0, across_m2 = 0.5 * (b - a).cross(c - a);
    const Vector3d along = middle - from_G;
    const double shown_m2 = -across_m2.dot(along.normalized());
    const bool hidden = middle.z() < ground_G.Height(middle.x(), middle.y()) || shown_m2 <= 0.0 ||
                        ShowsAnother(stones, from_G, along);
    if (hidden) continue;
    sum += shown_m2 * middle;
    area_m2 += shown_m2;
  }
  return area_m2 > 0.0 ? std::optional<Vector3d>(sum / area_m2) : std::nullopt;
}

}  // namespace dockyard::rocky7
