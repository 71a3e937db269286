// Distances of rings to turned solids, against closed forms and against a search all round.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/base/random.h"
#include "sim/rigid/turned_solid.h"

namespace dockyard {
namespace {

/// A tube's wall from z = -1 to 1, its hole of this radius.
TurnedSolid Tube(double radius_m) {
  return TurnedSolid({{1.0, 1.0}, {1.0, radius_m}, {-1.0, radius_m}, {-1.0, 1.0}});
}

TEST(TurnedSolid, RefusesACutThatIsNotConvexAndOneWithoutArea) {
  EXPECT_THROW(TurnedSolid({{0.0, 0.0}, {0.0, 1.0}, {0.5, 0.3}, {1.0, 1.0}, {1.0, 0.0}}),
               std::invalid_argument);
  EXPECT_THROW(TurnedSolid({{0.0, 0.0}, {0.0, 1.0}}), std::invalid_argument);
}

TEST(TurnedSolid, DistanceOfAPointIsThatOfSideCornerOrInnerSide) {
  const TurnedSolid disc({{0.0, 0.0}, {0.0, 2.0}, {1.0, 2.0}, {1.0, 0.0}});
  EXPECT_NEAR(disc.NearestTo({0.4, 2.5}).distance_m, 0.5, 1e-15);
  EXPECT_NEAR(disc.NearestTo({1.3, 2.4}).distance_m, 0.5, 1e-15);  // 3, 4, 5
  EXPECT_FALSE(disc.NearestTo({1.3, 2.4}).on_side);
  EXPECT_NEAR(disc.NearestTo({0.9, 1.0}).distance_m, -0.1, 1e-15);
  EXPECT_EQ(disc.NearestTo({0.9, 1.0}).normal, Eigen::Vector2d(1.0, 0.0));
}

TEST(Ring, AskewInATubeIsNearAtBothEndsOfTheAxisItIsTurnedAbout) {
  // Seen along the tube the ring is an ellipse; its long half axis is the ring's radius.
  const Ring ring =
      Pose3{RotX(0.3), Eigen::Vector3d::Zero()} * Ring{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.03};
  RingPoints points;
  ASSERT_EQ(FindNearPoints(ring, Tube(0.032), 0.01, points), 2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(points[i].distance_m, 0.002, 1e-12);
    EXPECT_NEAR(std::abs(points[i].p.x()), 0.03, 1e-9);
    EXPECT_NEAR(points[i].normal.dot(points[i].p), -0.03, 1e-9);
  }
}

// A line all round that is pressed in and moved aside by s is pushed back by s / 2 times the square
// of the normal's part across the axis, to whichever side.
TEST(Ring, ThatFitsAConeIsPushedBackFromAllSides) {
  const double radius_m = 0.015, slope = std::tan(Radians(30.0)), within_m = 5e-4;
  const TurnedSolid cone({{0.02, 0.045},
                          {0.02, radius_m - 0.02 * slope},
                          {-0.02, radius_m + 0.02 * slope},
                          {-0.02, 0.045}});
  const double across = std::cos(Radians(30.0));
  for (const double aside_m : {-2e-6, -1e-9, 1e-9, 2e-6}) {
    for (const double tilt : {0.0, 1e-4}) {
      const Ring ring = Pose3{RotY(tilt), Eigen::Vector3d(aside_m, 0.0, 3e-5)} *
                        Ring{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, radius_m};
      RingPoints points;
      const int count = FindNearPoints(ring, cone, within_m, points, true);
      ASSERT_GE(count, 3);
      Eigen::Vector3d push = Eigen::Vector3d::Zero();
      for (int i = 0; i < count; ++i) {
        push -= points[i].share * points[i].distance_m * points[i].normal;
      }
      EXPECT_NEAR(push.y(), 0.0, 1e-9);
      EXPECT_NEAR(push.z(), -0.5 * 0.5 * 3e-5, 0.02 * 1.5e-5);
      if (tilt > 0.0) continue;
      EXPECT_NEAR(push.x(), -0.5 * across * across * aside_m, 0.03e-6);
    }
  }
}

TEST(Ring, ThatLiesOnAFlatEndHasThreePointsThirdsOfATurnApart) {
  const TurnedSolid floor({{-0.1, 0.0}, {-0.1, 0.05}, {0.0, 0.05}, {0.0, 0.0}});
  for (double tilt : {0.0, 1e-12, 0.01}) {
    Ring ring = Pose3{RotX(tilt), Eigen::Vector3d(0, 0, -1e-4)} *
                Ring{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.03};
    RingPoints points;
    ASSERT_EQ(FindNearPoints(ring, floor, 0.001, points), 3) << tilt;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double depth = 0.0;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(points[i].share, 1.0 / 3.0 + 2.0 / 3.0 * 0.03 * std::sin(tilt) / 1e-3, 1e-9);
      sum += points[i].p;
      depth += points[i].distance_m;
    }
    EXPECT_LT(sum.head<2>().norm(), 3e-6);
    EXPECT_NEAR(depth, -3e-4, 1e-9);
  }
}

TEST(Ring, NearestPlaceIsTheLeastOfASearchAllRound) {
  const TurnedSolid funnel(
      {{0.0, 0.17}, {0.0, 0.12}, {-0.12, 0.032}, {-0.34, 0.032}, {-0.34, 0.17}});
  RandomStream random(3);
  int near = 0;
  for (int i = 0; i < 4000; ++i) {
    const double turned = random.Uniform(-kPi, kPi), tilted = random.Uniform(-1.5, 1.5);
    const double x = random.Uniform(-0.15, 0.15), y = random.Uniform(-0.15, 0.15);
    const double z = random.Uniform(-0.3, 0.05), radius = random.Uniform(0.0, 0.04);
    const Pose3 X{RotZ(turned) * RotX(tilted), Eigen::Vector3d(x, y, z)};
    const Ring ring = X * Ring{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, radius};
    double least = 1.0;
    for (int k = 0; k < 360; ++k) {
      const double angle = 2.0 * kPi * k / 360;
      const Eigen::Vector3d p =
          ring.centre + ring.radius_m * (std::cos(angle) * ring.x + std::sin(angle) * ring.y);
      least = std::min(least, funnel.NearestTo({p.z(), p.head<2>().norm()}).distance_m);
    }
    RingPoints points;
    const int count = FindNearPoints(ring, funnel, 0.01, points);
    if (least > 0.01 || least < -0.005) continue;  // as deep as no contact goes
    ++near;
    ASSERT_GT(count, 0) << i << ' ' << least;
    double found = 1.0;
    for (int k = 0; k < count; ++k) found = std::min(found, points[k].distance_m);
    // Of two minima closer than a sample's 22 deg one counts: 0.01 mm more was seen. The search
    // errs by its own half step, at a kink by slope x step.
    EXPECT_LT(found, least + 5e-5) << i;
    EXPECT_GT(found, least - 4e-4) << i;
  }
  EXPECT_GT(near, 200);
}

}  // namespace
}  // namespace dockyard
