#include "sim/paths/plan_meshes.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/polygon.h"

namespace dockyard {
namespace {

bool IsClockwise(const Polygon& area) {
  double twice = 0.0;
  ForEachSide(area, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    twice += a.x() * b.y() - a.y() * b.x();
  });
  return twice < 0.0;
}

}  // namespace

std::shared_ptr<const RenderMesh> PrismMesh(const Polygon& area, double low_m, double high_m) {
  Polygon corners = area;
  if (IsClockwise(corners)) std::reverse(corners.begin(), corners.end());
  auto mesh = std::make_shared<RenderMesh>();
  const auto Add = [&](const Eigen::Vector2d& p, double z) {
    mesh->vertices.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                static_cast<float>(z));
  };
  for (const double z : {low_m, high_m}) {
    Add(MeanCorner(corners), z);
    for (const Eigen::Vector2d& corner : corners) Add(corner, z);
  }
  const auto count = static_cast<std::uint32_t>(corners.size());
  const std::uint32_t upper = count + 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t here = 1 + i, next = 1 + (i + 1) % count;
    mesh->triangles.push_back({0, next, here});
    mesh->triangles.push_back({upper, upper + here, upper + next});
    mesh->triangles.push_back({here, next, upper + next});
    mesh->triangles.push_back({here, upper + next, upper + here});
  }
  return mesh;
}

Polygon Round(const Disc& disc, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * kPi * i / corners;
    polygon.push_back(disc.centre +
                      disc.radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

}  // namespace dockyard
