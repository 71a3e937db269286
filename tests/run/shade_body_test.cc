#include "sim/run/shade_body.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace dockyard {
namespace {

Lighting LightOf(Light light) { return MakeLighting(light, Pose3{}, {0.0, 0.0, 0.5}, 7); }

double AreaOf(const RenderMesh& mesh, std::size_t first, std::size_t count) {
  double area = 0.0;
  for (std::size_t i = first; i < first + count; ++i) {
    const auto& t = mesh.triangles[i];
    const Eigen::Vector3f a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    area += 0.5 * static_cast<double>((b - a).cross(c - a).norm());
  }
  return area;
}

// A spectator's leaf throws the same shade as the flake that the cameras' light meets.
TEST(SurroundingBodies, LeavesAreGreenAndAsLargeAsTheFlakesBehindTheShade) {
  const Lighting lighting = LightOf(Light::kSpeckled);
  const std::vector<StageBody> bodies = SurroundingBodies(lighting);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_TRUE(bodies[0].leaves);
  EXPECT_TRUE(bodies[0].about);
  const StagePart& leaves = bodies[0].parts.at(0);
  EXPECT_GT(leaves.rgb.y(), 2.0 * leaves.rgb.x());
  const RenderMesh& flakes = *lighting.occluders[0].mesh;
  const std::size_t count = flakes.vertices.size() / 8;
  ASSERT_EQ(leaves.mesh->triangles.size(), 12 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f* p = &flakes.vertices[8 * i];
    const double flake = static_cast<double>((p[1] - p[0]).norm() * (p[2] - p[0]).norm());
    EXPECT_NEAR(AreaOf(*leaves.mesh, 12 * i, 12) / 2.0 / flake, 1.0, 0.02);  // both faces
  }
}

TEST(SurroundingBodies, ShowWhatIsNoLeafAsTheCamerasSeeIt) {
  const Lighting lighting = LightOf(Light::kHardShadow);
  const std::vector<StageBody> bodies = SurroundingBodies(lighting);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_FALSE(bodies[0].leaves);
  ASSERT_EQ(bodies[0].parts.size(), lighting.occluders.size());
  for (std::size_t i = 0; i < bodies[0].parts.size(); ++i) {
    EXPECT_EQ(bodies[0].parts[i].mesh, lighting.occluders[i].mesh);
  }
  EXPECT_TRUE(SurroundingBodies(LightOf(Light::kEven)).empty());
}

}  // namespace
}  // namespace dockyard
