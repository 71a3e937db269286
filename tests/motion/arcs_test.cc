#include "controller/motion/arcs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/random.h"

namespace dockyard {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::SizeIs;

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

TEST(TwoArcs, EndAtTheGoalWhereverItIs) {
  RandomStream random(StreamKey(1, "two arcs"));
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    const Pose2 goal{random.Uniform(-5, 5), random.Uniform(-5, 5), random.Uniform(-kPi, kPi)};
    const auto arcs = TwoArcsTo(goal, random.Uniform(-2, 2));
    if (!arcs) continue;
    ++found;
    EXPECT_LT(Miss(Advance({}, *arcs), goal), 1e-5);
  }
  EXPECT_GT(found, 2900);
}

TEST(TwoArcs, EndAtTheGoalWithAStraightFirstPart) {
  const Pose2 goal{3.0, 1.0, 0.8};
  const auto arcs = TwoArcsTo(goal, 0.0);
  ASSERT_TRUE(arcs);
  EXPECT_EQ(arcs->front().turn_rad, 0.0);
  EXPECT_LT(Miss(Advance({}, *arcs), goal), 1e-9);
}

TEST(TwoArcs, EndAtTheGoalWithAStraightSecondPart) {
  // 1/k1 so that the circle's tangent at 45 deg runs through the goal.
  const Pose2 bend = Advance({}, Arc{0.25 * kPi * 2.0, 0.25 * kPi});
  const Pose2 goal = Advance(bend, Arc{1.5, 0.0});
  const auto arcs = TwoArcsTo(goal, 0.5);
  ASSERT_TRUE(arcs);
  EXPECT_LT(Miss(Advance({}, *arcs), goal), 1e-9);
  EXPECT_THAT(arcs->back().length_m, DoubleNear(1.5, 1e-6));
}

TEST(TwoArcs, AreOneStraightLineToAGoalStraightAhead) {
  EXPECT_EQ(*TwoArcsTo({2.5, 0.0, 0.0}, 0.3), (std::vector<Arc>{{2.5, 0.0}}));
}

TEST(TwoArcs, EndAtATinyOffset) {
  const Pose2 goal{2.0, 1e-7, 1e-7};
  const auto arcs = CheapestTwoArcs(goal, 1.0, +1);
  ASSERT_TRUE(arcs);
  EXPECT_LT(Miss(Advance({}, *arcs), goal), 1e-6);
}

TEST(TwoArcs, ReachASidewaysGoalBackwards) {
  const Pose2 goal{-1.5, 0.3, 0.0};
  const auto arcs = CheapestTwoArcs(goal, 1.5, -1);
  ASSERT_TRUE(arcs);
  EXPECT_LT(Miss(Advance({}, *arcs), goal), 1e-6);
  for (const Arc& arc : *arcs) EXPECT_LE(arc.length_m, 0.0);
}

TEST(TwoArcs, SymmetricPairIsTheCheapestForAParallelShift) {
  // Eq. (14) is twice the longer arc, least when both are equal: for a shift each turns by
  // 2 atan(y/x) and the meeting point is half way.
  const Pose2 goal{2.0, 0.5, 0.0};
  const auto arcs = CheapestTwoArcs(goal, 2.0, +1);
  ASSERT_TRUE(arcs);
  const double turn = 2.0 * std::atan2(goal.y, goal.x);
  const double radius = 0.25 * (goal.x * goal.x + goal.y * goal.y) / goal.y;
  EXPECT_THAT(TwoArcCost(*arcs), DoubleNear(2.0 * radius * turn, 0.02));
}

TEST(TwoArcs, NoPairOfAFineScanIsMuchCheaper) {
  RandomStream random(StreamKey(3, "eq14"));
  for (int i = 0; i < 50; ++i) {
    const Pose2 goal{random.Uniform(1, 4), random.Uniform(-1, 1), random.Uniform(-0.6, 0.6)};
    const auto best = CheapestTwoArcs(goal, 2.0, 0);
    ASSERT_TRUE(best);
    double least = 1e9;
    for (double k = -2.0; k <= 2.0; k += 1e-3) {
      const auto arcs = TwoArcsTo(goal, k);
      if (!arcs) continue;
      bool fits = true;
      for (const Arc& arc : *arcs)
        fits = fits && std::abs(arc.turn_rad) <= 2.0 * std::abs(arc.length_m);
      if (fits) least = std::min(least, TwoArcCost(*arcs));
    }
    EXPECT_LT(TwoArcCost(*best), 1.05 * least);
  }
}

TEST(TwoArcs, MirroredGoalGivesMirroredArcs) {
  const auto left = CheapestTwoArcs({2.7, 0.6, 0.31}, 1.0, +1);
  const auto right = CheapestTwoArcs({2.7, -0.6, -0.31}, 1.0, +1);
  ASSERT_TRUE(left && right);
  ASSERT_THAT(*right, SizeIs(left->size()));
  for (std::size_t i = 0; i < left->size(); ++i) {
    EXPECT_DOUBLE_EQ((*left)[i].length_m, (*right)[i].length_m);
    EXPECT_DOUBLE_EQ((*left)[i].turn_rad, -(*right)[i].turn_rad);
  }
}

}  // namespace
}  // namespace dockyard
