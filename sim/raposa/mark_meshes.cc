#include "sim/raposa/mark_meshes.h"

#include <array>
#include <cmath>

#include "sim/plant/scenery.h"
#include "sim/raposa/mating_shapes.h"

namespace dockyard::raposa {
namespace {

/// Corners of an upright square, counter-clockwise as seen from the guide.
std::array<Eigen::Vector3d, 4> Square(double x_m, double half_m) {
  return {Eigen::Vector3d(x_m, -half_m, -half_m), Eigen::Vector3d(x_m, half_m, -half_m),
          Eigen::Vector3d(x_m, half_m, half_m), Eigen::Vector3d(x_m, -half_m, half_m)};
}

/// Where the sides meet the faces.
double EdgeX_m(const MarksModel& marks) { return -marks.behind_m + marks.strip_m; }

/// Where the paint ends on the faces.
std::array<Eigen::Vector3d, 4> PaintEnd(const MarksModel& marks) {
  return Square(EdgeX_m(marks) + marks.strip_m * std::sin(marks.rise_rad),
                0.5 * marks.edge_m - marks.strip_m * std::cos(marks.rise_rad));
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
  const double half_m = 0.5 * marks.edge_m;
  for (const auto& square :
       {Square(-marks.behind_m, half_m), Square(EdgeX_m(marks), half_m), PaintEnd(marks)}) {
    for (const Eigen::Vector3d& p : square) mesh.vertices.push_back(p.cast<float>());
  }
  for (const std::uint32_t ring : {0u, 4u}) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t at = ring + k, next = ring + (k + 1) % 4;
      mesh.triangles.push_back({at, next, next + 4});
      mesh.triangles.push_back({at, next + 4, at + 4});
    }
  }
  return mesh;
}

RenderMesh FacesMesh(const MarksModel& marks) {
  RenderMesh mesh;
  for (const Eigen::Vector3d& p : PaintEnd(marks)) mesh.vertices.push_back(p.cast<float>());
  const double apex_m = EdgeX_m(marks) + 0.5 * marks.edge_m * std::tan(marks.rise_rad);
  mesh.vertices.push_back(Eigen::Vector3d(apex_m, 0.0, 0.0).cast<float>());
  for (std::uint32_t k = 0; k < 4; ++k) mesh.triangles.push_back({k, (k + 1) % 4, 4});
  return mesh;
}

}  // namespace dockyard::raposa
