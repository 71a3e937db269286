// Hulls against closed forms and Euler's formula; edges pressed into them against a search along
// the edge, and against the body's own corners.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "sim/base/random.h"
#include "sim/rigid/convex_body.h"

namespace dockyard {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points BoxCorners(const Eigen::Vector3d& half_m) {
  Points points;
  for (int i = 0; i < 8; ++i) {
    points.push_back(half_m.cwiseProduct(
        Eigen::Vector3d(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0)));
  }
  return points;
}

Eigen::Vector3d Direction(RandomStream& random) {
  const Eigen::Vector3d d(random.Normal(), random.Normal(), random.Normal());
  return d.normalized();
}

ConvexBody SomeRock(RandomStream& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    points.push_back(Direction(random).cwiseProduct(Eigen::Vector3d(0.15, 0.1, 0.06)));
  }
  return HullOf(points);
}

double Volume(const ConvexBody& body) {
  double six = 0.0;
  for (const auto& t : body.triangles) {
    six += body.vertices[t[0]].dot(body.vertices[t[1]].cross(body.vertices[t[2]]));
  }
  return six / 6.0;
}

TEST(ConvexBody, OfABoxHasSixFacesAndNoPointFromWithinIt) {
  Points points = BoxCorners({0.3, 0.2, 0.1});
  points.insert(points.begin() + 3, Eigen::Vector3d(0.01, 0.02, -0.03));  // within
  points.push_back({0.1, 0.05, 0.1});                                     // on a face
  points.push_back({0.3, 0.2, 0.0});                                      // on an edge
  points.push_back({0.3, 0.2, 0.1});                                      // a corner again
  const ConvexBody box = HullOf(points);
  EXPECT_EQ(box.faces.size(), 6u);
  EXPECT_EQ(box.vertices.size(), 8u);
  EXPECT_EQ(box.edges.size(), 12u);
  EXPECT_EQ(box.triangles.size(), 12u);
  EXPECT_NEAR(Volume(box), 0.6 * 0.4 * 0.2, 1e-15);
  EXPECT_NEAR(box.radius_m, std::sqrt(0.09 + 0.04 + 0.01), 1e-15);
  EXPECT_LT(box.centre.norm(), 1e-15);
}

TEST(ConvexBody, RefusesPointsInOnePlane) {
  EXPECT_THROW(HullOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), std::invalid_argument);
  EXPECT_THROW(HullOf({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.4, 0.2, 1}}),
               std::invalid_argument);
}

TEST(ConvexBody, OfPointsOnAnEllipsoidHoldsAllAndObeysEulersFormula) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed);
    Points points;
    for (int i = 0; i < 24; ++i) {
      points.push_back(Direction(random).cwiseProduct(Eigen::Vector3d(0.15, 0.1, 0.06)));
    }
    const ConvexBody body = HullOf(points);
    EXPECT_EQ(body.vertices.size(), points.size());  // an ellipsoid curves everywhere
    EXPECT_EQ(body.vertices.size() + body.faces.size(), body.edges.size() + 2);
    for (const Eigen::Vector3d& p : points) {
      EXPECT_LT(DistanceTo(body, p).distance_m, 1e-12);
      EXPECT_LE((p - body.centre).norm(), body.radius_m + 1e-15);
    }
    for (const auto& t : body.triangles) {
      const Eigen::Vector3d a = body.vertices[t[0]];
      const Eigen::Vector3d n =
          (body.vertices[t[1]] - a).cross(body.vertices[t[2]] - a).normalized();
      EXPECT_GT(n.dot(a - body.centre), 0.0);
      EXPECT_GT(DistanceTo(body, a + 1e-6 * n).distance_m, 0.0);
    }
  }
}

TEST(ConvexBody, KeepsDistancesWhenItIsMoved) {
  RandomStream random(5);
  const ConvexBody body = SomeRock(random, 20);
  Pose3 X_AB;
  X_AB.R = RotZ(0.7) * RotX(-0.4);
  X_AB.p = Eigen::Vector3d(3.0, -2.0, 0.5);
  const ConvexBody moved = X_AB * body;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p = 0.2 * Direction(random) * random.Uniform();
    const FaceDistance before = DistanceTo(body, p), after = DistanceTo(moved, X_AB * p);
    EXPECT_NEAR(before.distance_m, after.distance_m, 1e-14);
    EXPECT_LT((X_AB.R * before.normal - after.normal).norm(), 1e-14);
  }
}

// A box of 2 x 4 x 6 about the origin, from outside along its axes, past it and from within.
TEST(ConvexBody, ARayEntersABoxAtItsNearSide) {
  Points corners;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-2.0, 2.0}) {
      for (const double z : {-3.0, 3.0}) corners.emplace_back(x, y, z);
    }
  }
  const ConvexBody box = HullOf(corners);
  EXPECT_NEAR(RayEnters(box, {-5, 0, 0}, {1, 0, 0}).value(), 4.0, 1e-12);
  EXPECT_NEAR(RayEnters(box, {0, 0, 9}, {0, 0, -2}).value(), 3.0, 1e-12);
  EXPECT_NEAR(RayEnters(box, {-3, -2, 0}, {1, 1, 0}).value(), 2.0, 1e-12);
  EXPECT_FALSE(RayEnters(box, {-5, 2.1, 0}, {1, 0, 0}));
  EXPECT_FALSE(RayEnters(box, {-5, 0, 0}, {-1, 0, 0}));
  EXPECT_FALSE(RayEnters(box, {0, 0, 0}, {1, 0, 0}));
}

TEST(PressedEdge, IsWhereASearchAlongTheEdgeFindsIt) {
  int met = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    RandomStream random(seed);
    const ConvexBody body = SomeRock(random, 18);
    const Eigen::Vector3d a = 0.2 * Direction(random) * random.Uniform();
    const Eigen::Vector3d b = a + 0.2 * Direction(random);
    constexpr int kSamples = 4000;
    double deepest = -1.0, first = 2.0, last = -1.0;
    for (int i = 0; i <= kSamples; ++i) {
      const double share = static_cast<double>(i) / kSamples;
      const double depth = DepthAlong(body, a, b, share);
      deepest = std::max(deepest, depth);
      if (depth < 0.0) continue;
      first = std::min(first, share);
      last = share;
    }
    const std::optional<PressedEdge> pressed = PressEdge(body, a, b);
    if (!pressed) {
      EXPECT_LT(deepest, 0.0);
      continue;
    }
    if (deepest < 0.0) continue;  // shorter than a sample
    ++met;
    EXPECT_NEAR(pressed->from, first, 1.0 / kSamples);
    EXPECT_NEAR(pressed->to, last, 1.0 / kSamples);
    EXPECT_NEAR(DepthAlong(body, a, b, pressed->deepest), deepest, 0.2 / kSamples);
    EXPECT_GE(DepthAlong(body, a, b, pressed->deepest), deepest - 1e-15);
  }
  EXPECT_GT(met, 100);
}

TEST(PressedEdge, LeavesTheBodyByItsDepthAlongItsNormal) {
  int ridges = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    RandomStream random(seed);
    const ConvexBody body = SomeRock(random, 18);
    // Grazes the body some millimetres below a corner.
    const Eigen::Vector3d out = Direction(random), along = out.unitOrthogonal();
    Eigen::Vector3d top = body.vertices[0];
    for (const Eigen::Vector3d& p : body.vertices) top = out.dot(p) > out.dot(top) ? p : top;
    const Eigen::Vector3d middle =
        top + random.Uniform(0.001, 0.01) * (body.centre - top).normalized();
    const Eigen::Vector3d a = middle - 0.3 * along, b = middle + 0.3 * along;
    const std::optional<PressedEdge> pressed = PressEdge(body, a, b);
    ASSERT_TRUE(pressed.has_value());
    EXPECT_NEAR(pressed->normal.norm(), 1.0, 1e-12);
    const Eigen::Vector3d way = pressed->depth_m * pressed->normal;
    EXPECT_FALSE(PressEdge(body, a + 1.001 * way, b + 1.001 * way).has_value());
    if (std::abs(pressed->normal.dot(along)) < 1e-9) ++ridges;
  }
  EXPECT_GT(ridges, 50);
}

TEST(PressedEdge, LeavesARidgeByNoLessThanItsDepth) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RandomStream random(seed);
    const double left = random.Uniform(0.05, 0.3), right = random.Uniform(0.05, 0.3);
    const ConvexBody roof = HullOf(
        {{0, -1, 0.1}, {0, 1, 0.1}, {-left, -1, 0}, {-left, 1, 0}, {right, -1, 0}, {right, 1, 0}});
    // Across the ridge at any angle, and sloped less than either side.
    const double depth = random.Uniform(1e-4, 5e-3);
    const Eigen::Vector3d along =
        Eigen::Vector3d(1.0, random.Uniform(-1.0, 1.0), random.Uniform(-0.2, 0.2)).normalized();
    const Eigen::Vector3d p(0.0, random.Uniform(-0.2, 0.2), 0.1 - depth);
    const Eigen::Vector3d a = p - 0.5 * along, b = p + 0.5 * along;
    const std::optional<PressedEdge> pressed = PressEdge(roof, a, b);
    ASSERT_TRUE(pressed.has_value());
    EXPECT_LT(std::abs(pressed->normal.dot(along)), 1e-12);
    EXPECT_LT(std::abs(pressed->normal.y()), 1e-12);  // square to the ridge too
    const Eigen::Vector3d way = pressed->depth_m * pressed->normal;
    EXPECT_FALSE(PressEdge(roof, a + 1.001 * way, b + 1.001 * way).has_value());
    EXPECT_TRUE(PressEdge(roof, a + 0.999 * way, b + 0.999 * way).has_value());
  }
}

TEST(PressedEdge, AcrossARidgeIsPushedSquareToItselfAndToTheRidge) {
  // A roof along y whose sides fall by 45 and by 30 deg; the edge lies level across it.
  const double x = 0.1, z = 0.1;
  const ConvexBody roof = HullOf({{0, -1, z},
                                  {0, 1, z},
                                  {-x, -1, 0},
                                  {-x, 1, 0},
                                  {z * std::sqrt(3.0), -1, 0},
                                  {z * std::sqrt(3.0), 1, 0}});
  const std::optional<PressedEdge> pressed = PressEdge(roof, {-0.5, 0, 0.09}, {0.5, 0, 0.09});
  ASSERT_TRUE(pressed.has_value());
  EXPECT_NEAR(pressed->depth_m, 0.01, 1e-12);
  EXPECT_LT((pressed->normal - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(pressed->from, 0.49, 1e-12);
  EXPECT_NEAR(pressed->to, 0.5 + 0.01 * std::sqrt(3.0), 1e-12);
}

TEST(PressedEdge, ThatLiesOnAFlatTopIsPushedOffIt) {
  const ConvexBody box = HullOf(BoxCorners({0.1, 0.1, 0.1}));
  const std::optional<PressedEdge> pressed =
      PressEdge(box, {-0.3, 0.02, 0.099}, {0.3, 0.02, 0.099});
  ASSERT_TRUE(pressed.has_value());
  EXPECT_NEAR(pressed->depth_m, 0.001, 1e-15);
  EXPECT_EQ(pressed->normal, Eigen::Vector3d::UnitZ());
}

}  // namespace
}  // namespace dockyard
