#include "models/parts/scoop_shape.h"

#include <utility>

namespace dockyard {
namespace {

using Eigen::Vector2d;

// The profile's corners, as shares of belly and depth. Assumed, 0.3-0.7, 0.2-0.4, 0.6-0.8: a floor
// that rises by 27 deg from the lip, so that with the scoops open by 80 mm it goes into the ground
// 10 deg off the vertical.
constexpr double kTopX = 0.5, kBackTop = 0.3, kBackFoot = 0.7;
// The arm's bar; assumed, 10-20 mm high and 15-30 mm wide.
constexpr double kBarHigh_m = 0.012, kBarWide_m = 0.020;

// A convex outline in x and z, clockwise as seen along +y, between two y.
TriangleMesh Prism(const std::vector<Vector2d>& outline, double from_y, double to_y) {
  TriangleMesh mesh;
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (const double y : {from_y, to_y}) {
    for (const Vector2d& p : outline) mesh.vertices.emplace_back(p.x(), y, p.y());
  }
  for (std::uint32_t i = 2; i < count; ++i) {
    mesh.triangles.push_back({0, i, i - 1});
    mesh.triangles.push_back({count, count + i - 1, count + i});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({i, count + next, count + i});
    mesh.triangles.push_back({i, next, count + next});
  }
  return mesh;
}

// Of a plate whose outer side goes from a to b, its thickness to the left of that way.
Vector2d Inward(const Vector2d& a, const Vector2d& b, double wall_m) {
  const Vector2d way = (b - a).normalized();
  return wall_m * Vector2d(-way.y(), way.x());
}

void Mirror(TriangleMesh& mesh) {
  for (Eigen::Vector3d& p : mesh.vertices) p.x() = -p.x();
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace

std::array<Vector2d, 4> ScoopProfile(const ScoopModel& scoop) {
  const double b = scoop.belly_m, d = scoop.depth_m;
  return {Vector2d(kTopX * b, 0.0), Vector2d(b, -kBackTop * d), Vector2d(b, -kBackFoot * d),
          Vector2d(0.0, -d)};
}

std::vector<TriangleMesh> ScoopPlates(const ScoopModel& scoop, bool front) {
  const auto outer = ScoopProfile(scoop);
  const double half_m = 0.5 * scoop.width_m;
  std::vector<TriangleMesh> plates;
  for (int i = 2; i >= 0; --i) {
    const Vector2d &a = outer[static_cast<std::size_t>(i) + 1],
                   &b = outer[static_cast<std::size_t>(i)];
    const Vector2d in = -Inward(b, a, scoop.wall_m);
    Vector2d a_in = a + in;
    // The lip ends in the plane of the mouth, where it meets the other one.
    if (i == 2) a_in += (0.0 - a_in.x()) / (b - a).x() * (b - a);
    plates.push_back(Prism({a, a_in, b + in, b}, -half_m, half_m));
  }
  if (scoop.sides == ScoopSides::kClosed) {
    const std::vector<Vector2d> side{outer[3], outer[0], outer[1], outer[2]};
    plates.push_back(Prism(side, -half_m, -half_m + scoop.wall_m));
    plates.push_back(Prism(side, half_m - scoop.wall_m, half_m));
  }
  if (!front) {
    for (TriangleMesh& plate : plates) Mirror(plate);
  }
  return plates;
}

TriangleMesh ArmBar(const ArmModel& arm) {
  const double z = 0.5 * kBarHigh_m, end_m = arm.length_m + z;
  return Prism({{0.0, -z}, {0.0, z}, {end_m, z}, {end_m, -z}}, -0.5 * kBarWide_m, 0.5 * kBarWide_m);
}

}  // namespace dockyard
