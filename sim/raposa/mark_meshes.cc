#include "sim/raposa/mark_meshes.h"

#include <array>
#include <cmath>

#include "sim/plant/scenery.h"
#include "sim/raposa/mating_shapes.h"

namespace dockyard::raposa {
namespace {

/// Corners of the square on the faces at this distance from the base, along a face; ordered
/// counter-clockwise as seen from the guide.
std::array<Eigen::Vector3d, 4> SquareOn(const MarksModel& marks, double along_m) {
  const double half_m = 0.5 * marks.edge_m - along_m * std::cos(marks.rise_rad);
  const double x_m = -marks.behind_m + along_m * std::sin(marks.rise_rad);
  return {Eigen::Vector3d(x_m, -half_m, -half_m), Eigen::Vector3d(x_m, half_m, -half_m),
          Eigen::Vector3d(x_m, half_m, half_m), Eigen::Vector3d(x_m, -half_m, half_m)};
}

}  // namespace

RenderMesh GuideMesh(const GuideModel& guide) {
  return TurnedMesh(GuideProfile(guide), GuideAxis(guide));
}

RenderMesh RodMesh(const PyramidModel& pyramid) {
  const GuideModel& guide = pyramid.guide;
  const double front_m = GuideProfile(guide).front().x();
  const double rear_m = -pyramid.marks.behind_m / std::cos(guide.up_rad);
  return TurnedMesh({{rear_m, guide.rod_radius_m}, {front_m, guide.rod_radius_m}},
                    GuideAxis(guide));
}

RenderMesh StripsMesh(const MarksModel& marks) {
  RenderMesh mesh;
  const auto outer = SquareOn(marks, 0.0), inner = SquareOn(marks, marks.strip_m);
  for (const auto& square : {outer, inner}) {
    for (const Eigen::Vector3d& p : square) mesh.vertices.push_back(p.cast<float>());
  }
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4;
    mesh.triangles.push_back({k, next, 4 + next});
    mesh.triangles.push_back({k, 4 + next, 4 + k});
  }
  return mesh;
}

RenderMesh FacesMesh(const MarksModel& marks) {
  RenderMesh mesh;
  for (const Eigen::Vector3d& p : SquareOn(marks, marks.strip_m)) {
    mesh.vertices.push_back(p.cast<float>());
  }
  const double apex_m = -marks.behind_m + 0.5 * marks.edge_m * std::tan(marks.rise_rad);
  mesh.vertices.push_back(Eigen::Vector3d(apex_m, 0.0, 0.0).cast<float>());
  for (std::uint32_t k = 0; k < 4; ++k) mesh.triangles.push_back({k, (k + 1) % 4, 4});
  return mesh;
}

}  // namespace dockyard::raposa
