#include "sim/page/near_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace dockyard {
namespace {

std::shared_ptr<const RenderMesh> Tetrahedron(float side_m) {
  auto mesh = std::make_shared<RenderMesh>();
  mesh->vertices = {{0, 0, 0}, {side_m, 0, 0}, {0, side_m, 0}, {0, 0, side_m}};
  mesh->triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

/// A robot, and a target at (1, 2, 0.1) in the site G, which the second sample has 0.3 m further
/// up.
LoggedRun RunAt(const Pose3& X_WG) {
  LoggedRun run;
  run.times_s = {0.0, 0.1};
  run.X_WG = {X_WG, X_WG};
  run.X_WD = {X_WG, X_WG};
  run.body_names = {"robot", "target"};
  run.X_WO = {{X_WG * Pose3::Translation(3.0, 2.0, 0.1), X_WG * Pose3::Translation(1.2, 2.0, 0.1)},
              {X_WG * Pose3::Translation(1.0, 2.0, 0.1), X_WG * Pose3::Translation(1.0, 2.0, 0.4)}};
  return run;
}

StageShapes ShapesAt(const Pose3& X_WG) {
  StageShapes shapes;
  shapes.bodies.push_back({"robot", true, {{Tetrahedron(0.1f), {}}}});
  shapes.bodies.push_back({"target", false, {{Tetrahedron(0.01f), {}}}});
  shapes.light.to_sun_W = X_WG.R * Eigen::Vector3d(0.3, 0.4, 0.5).normalized();
  return shapes;
}

const Pose3 kHere{}, kElsewhere{RotZ(1.0), {10.0, 5.0, 0.0}};

TEST(NearPart, HasTheTargetsPlacesInTheSite) {
  Payload payload, expected;
  const Json near = NearPart(RunAt(kElsewhere), ShapesAt(kElsewhere), payload);
  Json at = Json::array();
  for (const auto& values : {std::vector<double>{1.0, 1.0}, {2.0, 2.0}, {0.1, 0.4}}) {
    at.push_back(expected.AddChannel(values, 1e-4));
  }
  EXPECT_EQ(near["at"], at);
  EXPECT_EQ(payload.Text({}), expected.Text({}));
}

TEST(NearPart, HasTheSameViewWhereverTheSiteIs) {
  Payload payload;
  const Json here = NearPart(RunAt(kHere), ShapesAt(kHere), payload)["out"];
  const Json elsewhere = NearPart(RunAt(kElsewhere), ShapesAt(kElsewhere), payload)["out"];
  Eigen::Vector3d out(0.0, 0.0, 0.0);
  for (int i = 0; i < 3; ++i) {
    out(i) = elsewhere[i];
    EXPECT_NEAR(out(i), here[i].get<double>(), 1e-9);
  }
  // It shows 0.15 m to either side of the point in an image that is 38 deg high.
  EXPECT_NEAR(out.norm(), 0.15 / std::sin(19.0 * kPi / 180.0), 1e-9);
  EXPECT_GT(out.z(), 0.1);
}

TEST(NearPart, OfALogWithoutASampleIsNone) {
  Payload payload;
  EXPECT_TRUE(NearPart(LoggedRun{}, ShapesAt(kHere), payload).is_null());
}

}  // namespace
}  // namespace dockyard
