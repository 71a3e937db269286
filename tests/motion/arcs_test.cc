#include "controller/motion/arcs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/random.h"

namespace dockyard {
namespace {

using testing::DoubleNear;

double Miss(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) + std::abs(WrapPi(a.heading - b.heading));
}

TEST(Arc, StraightGoesStraight) { EXPECT_EQ(Advance({}, Arc{2.0, 0.0}), (Pose2{2.0, 0.0, 0.0})); }

TEST(Arc, QuarterCircleEndsAtItsRadius) {
  const Pose2 end = Advance({}, Arc{kPi, 0.5 * kPi});  // radius 2 m
  EXPECT_LT(Miss(end, {2.0, 2.0, 0.5 * kPi}), 1e-12);
}

TEST(Arc, BackwardsUndoesForwards) {
  const Pose2 there = Advance({1.0, -2.0, 0.7}, Arc{1.3, 0.9});
  EXPECT_LT(Miss(Advance(there, Arc{-1.3, -0.9}), {1.0, -2.0, 0.7}), 1e-12);
}

TEST(Arc, TwoPartsMakeTheWhole) {
  const Arc arc{1.7, -1.1};
  const Pose2 half = Advance({}, Part(arc, 0.3));
  EXPECT_LT(Miss(Advance(half, Part(arc, 0.7)), Advance({}, arc)), 1e-12);
}

TEST(Arc, ATinyTurnIsTheLimitOfTheCircle) {
  // Sideways by l theta / 2 to first order.
  const Pose2 end = Advance({}, Arc{3.0, 1e-7});
  EXPECT_THAT(end.y, DoubleNear(1.5e-7, 1e-13));
}

TEST(Truncate, StopsInsideTheSecondArc) {
  const std::vector<Arc> path{{1.0, 0.5}, {-2.0, 1.0}};
  EXPECT_EQ(Truncate(path, 1.5), (std::vector<Arc>{{1.0, 0.5}, {-0.5, 0.25}}));
}

// Where the arc carries the point P of the rover.
Eigen::Vector2d Carried(const Arc& arc, const Eigen::Vector2d& p_RP) {
  return Advance({}, arc) * p_RP;
}

TEST(OneArc, CarriesThePointToTheGoalWhereverItIs) {
  RandomStream random(StreamKey(7, "one arc"));
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d goal(random.Uniform(-4, 4), random.Uniform(-4, 4));
    const Eigen::Vector2d point(random.Uniform(-0.5, 1.5), random.Uniform(-0.3, 0.3));
    // P turns about a centre on the axle, so goals at its own distance only mirrored: skip poles.
    if (std::hypot(goal.x() + point.x(), goal.y() - point.y()) < 0.05) continue;
    const auto arc = OneArcTo(goal, point);
    ASSERT_TRUE(arc);
    EXPECT_LT((Carried(*arc, point) - goal).norm(), 1e-9) << goal.transpose();
  }
}

TEST(OneArc, GoesBackwardsToAGoalBehind) {
  EXPECT_LT(OneArcTo({-2.0, 0.5}, {0.0, 0.0})->length_m, 0.0);
}

TEST(OneArc, HasNoneWhereThePointIsAlready) { EXPECT_FALSE(OneArcTo({1.0, 0.2}, {1.0, 0.2})); }

}  // namespace
}  // namespace dockyard
