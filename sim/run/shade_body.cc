#include "sim/run/shade_body.h"

#include <cstddef>

namespace dockyard {
namespace {

constexpr std::size_t kCorners = 8, kTriangles = 12;  // of a flake
// Green of a leaf, linear; assumed, with what shines through it: 3-12 % of red and blue, 10-25 % of
// green.
const Eigen::Vector3d kGreen{0.08, 0.19, 0.045};

/// A leaf over the flake of these corners, in their order: bit 0 along x, 1 along y, 2 along z. The
/// outline has a point at either end of x; the area is the flake's, so the shadow is as large.
void AddLeaf(const Eigen::Vector3f* corners, RenderMesh& mesh) {
  constexpr float kLength = 1.35f, kWidth = 1.178f;  // half, in the flake's half sides
  // An outline's x and y: its points, and three on either side.
  constexpr float kOutline[8][2] = {{-1.0f, 0.0f}, {-0.5f, -0.75f}, {0.1f, -1.0f}, {0.65f, -0.6f},
                                    {1.0f, 0.0f},  {0.65f, 0.6f},   {0.1f, 1.0f},  {-0.5f, 0.75f}};
  const Eigen::Vector3f middle = 0.5f * (corners[0] + corners[7]);
  const Eigen::Vector3f x = 0.5f * kLength * (corners[1] - corners[0]),
                        y = 0.5f * kWidth * (corners[2] - corners[0]),
                        z = 0.5f * (corners[4] - corners[0]);
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const float side : {-1.0f, 1.0f}) {
    for (const auto& at : kOutline) {
      mesh.vertices.emplace_back(middle + at[0] * x + at[1] * y + side * z);
    }
  }
  for (std::uint32_t i = 1; i + 1 < 8; ++i) {
    mesh.triangles.push_back({base, base + i + 1, base + i});
    mesh.triangles.push_back({base + 8, base + 8 + i, base + 8 + i + 1});
  }
}

/// Leaves in the places of a mesh of flakes, which are boxes.
std::shared_ptr<const RenderMesh> LeavesOf(const RenderMesh& flakes) {
  auto mesh = std::make_shared<RenderMesh>();
  for (std::size_t i = 0; i + kCorners <= flakes.vertices.size(); i += kCorners) {
    AddLeaf(&flakes.vertices[i], *mesh);
  }
  return mesh;
}

}  // namespace

std::vector<StageBody> SurroundingBodies(const Lighting& lighting) {
  std::vector<StageBody> bodies;
  if (!lighting.scenery.empty()) bodies.push_back({.name = "scenery", .parts = {}, .about = true});
  for (const SceneryObject& thing : lighting.scenery) {
    bodies.back().parts.push_back({thing.object.mesh, thing.object.X_WO, thing.object.albedo});
  }
  if (lighting.occluders.empty()) return bodies;
  StageBody shade{.name = "shade", .parts = {}, .about = true, .leaves = lighting.leaves};
  for (const SceneObject& object : lighting.occluders) {
    const bool flakes =
        lighting.leaves && object.mesh->vertices.size() % kCorners == 0 &&
        object.mesh->triangles.size() * kCorners == object.mesh->vertices.size() * kTriangles;
    if (flakes) {
      shade.parts.push_back({LeavesOf(*object.mesh), object.X_WO, kGreen});
    } else {
      shade.parts.push_back({object.mesh, object.X_WO, object.albedo});
    }
  }
  bodies.push_back(std::move(shade));
  return bodies;
}

}  // namespace dockyard
