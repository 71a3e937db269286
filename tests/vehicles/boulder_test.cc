// Star-shaped bodies, and boulders made of them.
#include "sim/vehicles/boulder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sim/base/random.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

Vector3d AnyDirection(RandomStream& random) {
  const double z = random.Uniform(-1.0, 1.0), angle = random.Uniform(-kPi, kPi);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

StarBody Wavy(int level) {
  return MakeStarBody({0.3, -0.2, 0.1}, level, [](const Vector3d& d) {
    return 0.4 + 0.1 * std::sin(5.0 * d.x()) * std::cos(4.0 * d.y());
  });
}

TEST(StarBody, AnyPointOfAnyTriangleIsOnTheSurface) {
  const StarBody body = Wavy(4);
  RandomStream random(1);
  for (const StarBody::Triangle& t : body.triangles()) {
    const double u = random.Uniform(), v = random.Uniform();
    const double a = std::min(u, 1.0 - u) * v, b = std::max(0.0, 0.9 - a) * u, c = 1.0 - a - b;
    const Vector3d p = a * body.vertices[t[0]] + b * body.vertices[t[1]] + c * body.vertices[t[2]];
    ASSERT_NEAR(DepthIn(body, p).depth_m, 0.0, 1e-12);
  }
}

TEST(StarBody, DepthIsThatOfASphereToTheHeightOfItsTriangles) {
  const StarBody ball = MakeStarBody({0.1, 0.2, 0.3}, 5, [](const Vector3d&) { return 0.5; });
  RandomStream random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d d = AnyDirection(random);
    const double depth_m = random.Uniform(-0.05, 0.05);
    const StarDepth at = DepthIn(ball, ball.centre + (0.5 - depth_m) * d);
    // Edges of 0.0346 rad at most: triangles lie up to r (1 - cos(0.02)) = 0.1 mm within.
    ASSERT_NEAR(at.depth_m, depth_m, 2.5e-4) << i;
    ASSERT_GT(at.normal.dot(d), std::cos(0.04));
  }
}

TEST(StarBody, ARayMeetsTheSurfaceWhereItsDepthIsZero) {
  const StarBody body = Wavy(4);
  RandomStream random(3);
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d from = body.centre + 2.0 * AnyDirection(random);
    const Vector3d to = body.centre + 0.3 * AnyDirection(random);
    const Vector3d direction = (to - from).normalized();
    const auto hit = FirstOnRay(body, from, direction);
    ASSERT_TRUE(hit.has_value());
    ASSERT_NEAR(DepthIn(body, *hit).depth_m, 0.0, 1e-12);
    ASSERT_LT(DepthIn(body, *hit - 1e-3 * direction).depth_m, 0.0);
    ++met;
    EXPECT_FALSE(FirstOnRay(body, from, -direction).has_value());
  }
  EXPECT_EQ(met, 200);
}

TEST(StarBody, RefusesARadiusThatIsNotPositive) {
  EXPECT_THROW(MakeStarBody({0, 0, 0}, 1, [](const Vector3d& d) { return d.x(); }),
               std::invalid_argument);
}

BoulderShape Shape(double up_deg, double roughness_m = 0.0) {
  return {.width_m = 0.6,
          .target_up_m = 0.3,
          .face_up_rad = Radians(up_deg),
          .face_turn_rad = 0.7,
          .roughness_m = roughness_m};
}

// A can's face on the boulder's face, and on points about its middle.
TEST(Boulder, ItsFaceIsThePlaneThatWasAskedFor) {
  for (const double up_deg : {0.0, 15.0, 30.0, 45.0, 60.0}) {
    const BoulderShape shape = Shape(up_deg);
    const StarBody body = MakeBoulder(shape, 5);
    const Vector3d normal = FaceNormal(shape), middle(0.0, 0.0, shape.target_up_m);
    EXPECT_NEAR(normal.z(), std::sin(Radians(up_deg)), 1e-12);
    for (int i = 0; i < 12; ++i) {
      const double angle = 2.0 * kPi * i / 12;
      const Vector3d side = Vector3d::UnitZ().cross(normal).normalized();
      const Vector3d p =
          middle + 0.06 * (std::cos(angle) * side + std::sin(angle) * normal.cross(side));
      EXPECT_NEAR(DepthIn(body, p).depth_m, 0.0, 1e-9) << up_deg << " " << i;
    }
    const auto felt = NormalUnderDisc(body, middle, normal, 0.033);
    ASSERT_TRUE(felt.has_value());
    EXPECT_NEAR(felt->dot(normal), 1.0, 1e-9);
  }
}

TEST(Boulder, FallsAwayBehindASmallRim) {
  BoulderShape shape = Shape(60.0);
  shape.rim_m = 0.02;
  const StarBody body = MakeBoulder(shape, 6);
  // Level from the middle: 1 cm up is still on the face, 5 cm up is in the air.
  const double up = std::cos(shape.face_up_rad);
  double highest_m = 0.0;
  for (const Vector3d& vertex : body.vertices) highest_m = std::max(highest_m, vertex.z());
  EXPECT_NEAR(highest_m, shape.target_up_m + 0.02 * up, 5e-3);
}

// Two planes meet in a ridge. A plane through all points under a disc that reaches over it would
// lean towards the other side.
TEST(StarBody, TheNormalOverADiscIsThatOfTheSideItsMiddleIsOn) {
  const Vector3d n = Vector3d(0.0, 0.5, 1.0).normalized();
  const StarBody roof = MakeStarBody({0.0, 0.0, 0.0}, 7, [&](const Vector3d& d) {
    const double up = std::max(n.dot(d), n.dot(Vector3d(d.x(), -d.y(), d.z())));
    return std::min(0.4, up > 0.0 ? 0.2 / up : 0.4);
  });
  const Vector3d top(0.0, 0.0, 0.2 / n.z());
  const Vector3d down = Vector3d::UnitX().cross(n).normalized();  // from the ridge along the plane
  const Vector3d side = down.y() > 0.0 ? down : Vector3d(-down);
  for (const double away_m : {0.006, 0.015, 0.03}) {
    const auto normal = NormalUnderDisc(roof, top + away_m * side, n, 0.02);
    ASSERT_TRUE(normal.has_value());
    // Triangles of 4 mm cut the ridge off.
    EXPECT_GT(normal->dot(n), std::cos(Radians(3.0))) << away_m;
  }
  EXPECT_FALSE(NormalUnderDisc(roof, {1.0, 0.0, 0.2}, Vector3d::UnitZ(), 0.02).has_value());
}

TEST(Boulder, IsAsRoughAsItWasAskedToBe) {
  const BoulderShape shape = Shape(30.0, 1e-3);
  const Vector3d normal = FaceNormal(shape), middle(0.0, 0.0, shape.target_up_m);
  double sum2 = 0.0;
  int count = 0;
  for (std::uint64_t key = 1; key <= 20; ++key) {
    const StarBody body = MakeBoulder(shape, key);
    for (const Vector3d& vertex : body.vertices) {
      if ((vertex - middle).norm() > 0.07) continue;
      const double off_m = normal.dot(vertex - middle);
      sum2 += off_m * off_m;
      ++count;
    }
  }
  // Vertices move along the ray from the centre, which is not the face's normal: less than 1 mm.
  EXPECT_GT(count, 2000);
  EXPECT_NEAR(std::sqrt(sum2 / count), 0.9e-3, 0.25e-3);
}

TEST(Boulder, SameKeySameBoulder) {
  const StarBody a = MakeBoulder(Shape(30.0, 1e-3), 7), b = MakeBoulder(Shape(30.0, 1e-3), 7),
                 c = MakeBoulder(Shape(30.0, 1e-3), 8);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_NE(a.vertices, c.vertices);
}

}  // namespace
}  // namespace dockyard
