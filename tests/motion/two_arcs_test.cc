#include "controller/motion/two_arcs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/base/random.h"

namespace dockyard {
namespace {

double Miss(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) + std::abs(WrapPi(a.heading - b.heading));
}

Pose2 EndOf(const ArcPair& pair) { return Advance(Advance({}, pair[0]), pair[1]); }

Pose2 AnyGoal(RandomStream& random) {
  return {random.Uniform(-5, 5), random.Uniform(-5, 5), random.Uniform(-kPi, kPi)};
}

TEST(PairOfSplit, EndsAtTheGoalTo1e9WhateverGoalAndSplit) {
  RandomStream random(StreamKey(1, "pair of split"));
  double worst = 0.0;
  for (int i = 0; i < 100'000; ++i) {
    const Pose2 goal = AnyGoal(random);
    const auto pair = PairOfSplit(goal, random.Uniform(0.0, kPi));
    ASSERT_TRUE(pair);
    worst = std::max(worst, Miss(EndOf(*pair), goal));
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(PairOfSplit, HasChordsInTheRatioOfTheSplit) {
  const Pose2 goal{2.0, 1.0, 0.4};
  const auto pair = PairOfSplit(goal, 0.3);
  const auto Chord = [](const Arc& arc) {
    const Pose2 end = Advance({}, arc);
    return std::hypot(end.x, end.y);
  };
  EXPECT_NEAR(Chord((*pair)[0]) / Chord((*pair)[1]), std::tan(0.3), 1e-12);
}

TEST(PairOfSplit, HasNoneAtTheRoversOwnPlace) { EXPECT_FALSE(PairOfSplit({0, 0, 1.0}, 0.5)); }

TEST(CheapestPair, IsTwoArcsOfNoLengthForTheRoversOwnPose) {
  const auto pair = CheapestPair({}, {});
  ASSERT_TRUE(pair);
  EXPECT_EQ(PairCost(*pair), 0.0);
}

// A goal on one circle, straight ahead, or nearly so: the radius is no parameter there, the split
// is. Closed forms: half the way in each arc.
TEST(CheapestPair, IsOneArcHalvedWhereOneArcLeadsToTheGoal) {
  for (const Pose2& goal : {Pose2{1.0, 0.5, 2.0 * std::atan2(0.5, 1.0)}, Pose2{1, 1, 0.5 * kPi},
                            Pose2{2, 0, 0}, Pose2{2, 1e-9, 0}, Pose2{-1.5, 0, 0}}) {
    const double turn = goal.heading, chord = std::hypot(goal.x, goal.y);
    const double way = turn == 0.0 ? chord : chord * 0.5 * turn / std::sin(0.5 * turn);
    const auto pair = CheapestPair(goal, {});
    ASSERT_TRUE(pair);
    EXPECT_NEAR(PairCost(*pair), way, 1e-8) << goal.x << " " << goal.y;
  }
}

// A tenth of the goals is degenerate: on one circle, straight ahead or behind, or where one arc of
// a pair turns in place.
Pose2 AwkwardGoal(RandomStream& random, int i) {
  Pose2 goal = AnyGoal(random);
  if (i % 40 == 0) goal.heading = WrapPi(2.0 * std::atan2(goal.y, goal.x));
  if (i % 40 == 10) goal.y = goal.heading = 0.0;
  if (i % 40 == 20) goal.heading = 0.0;
  if (i % 40 == 30) goal.heading = WrapPi(std::atan2(goal.y, goal.x) + random.Uniform(-1e-9, 1e-9));
  return goal;
}

TEST(CheapestPair, EndsAtTheGoalTo1e9For10000GoalsATenthDegenerate) {
  RandomStream random(StreamKey(4, "cheapest pair"));
  double worst = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    const Pose2 goal = AwkwardGoal(random, i);
    const auto pair = CheapestPair(goal, {});
    ASSERT_TRUE(pair);
    worst = std::max(worst, Miss(EndOf(*pair), goal));
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(CheapestPair, MirroredGoalGivesMirroredArcs) {
  const ArcLimits limits{1.0, Travel::kForward};
  const auto left = CheapestPair({2.7, 0.6, 0.31}, limits);
  const auto right = CheapestPair({2.7, -0.6, -0.31}, limits);
  ASSERT_TRUE(left && right);
  for (std::size_t i = 0; i < left->size(); ++i) {
    EXPECT_NEAR((*left)[i].length_m, (*right)[i].length_m, 1e-12);
    EXPECT_NEAR((*left)[i].turn_rad, -(*right)[i].turn_rad, 1e-12);
  }
}

// r = (x^2 + y^2) / (4 y), the S between parallel headings.
TEST(CheapestPair, IsTheEvenSBetweenParallelHeadings) {
  const auto pair = CheapestPair({2.0, 1.0, 0.0}, {});
  ASSERT_TRUE(pair);
  for (const Arc& arc : *pair) EXPECT_NEAR(std::abs(arc.length_m / arc.turn_rad), 1.25, 1e-9);
  EXPECT_NEAR((*pair)[0].turn_rad, 2.0 * std::atan2(1.0, 2.0), 1e-9);
}

struct Vector {
  Eigen::Vector2d p_RP, p_RG;  // the rover's point to place, and where
  double heading_rad;
  ArcLimits limits;
  double first_m, first_rad, second_m, second_rad;
};

// An independent computation's optima of Eq. (14), in curvatures, to 9 digits.
TEST(CheapestPair, AgreesWithAnIndependentComputation) {
  const Travel fwd = Travel::kForward;
  const Vector vectors[] = {
      {{0.6, 0}, {2, 0.5}, 0.4, {}, 0.740801587, 0.164095153, 0.740801587, 0.235904847},
      {{0.6, 0}, {2, 0.5}, -0.9, {}, 1.150612339, 1.489537888, 1.150612339, -2.389537888},
      {{0, 0}, {0.2, 0.6}, 0.3, {}, 0.391213094, 2.343596328, 0.391213094, -2.043596328},
      {{0, 0}, {0.2, 0.6}, 0.3, {0.5}, -0.911220623, 1.822441246, 1.547932295, -1.522441246},
      {{0, 0}, {1.5, -0.6}, 1.2, {0.4, fwd}, 0.999700053, -1.298192890, 0.999700053, 2.498192890},
      {{0, 0}, {-1, 0.3}, 0.5, {}, -0.553824680, -0.827156398, -0.553824680, 1.327156398},
      {{0.6, 0.1}, {3, -1}, 2.5, {0.4}, 2.707236662, -1.959834012, -2.707236662, -1.823351295},
  };
  for (const Vector& v : vectors) {
    const Pose2 turn{0, 0, v.heading_rad};
    const Eigen::Vector2d axle = v.p_RG - turn * v.p_RP;
    const auto pair = CheapestPair({axle.x(), axle.y(), v.heading_rad}, v.limits);
    ASSERT_TRUE(pair);
    EXPECT_NEAR((*pair)[0].length_m, v.first_m, 1e-8);
    EXPECT_NEAR((*pair)[0].turn_rad, v.first_rad, 1e-8);
    EXPECT_NEAR((*pair)[1].length_m, v.second_m, 1e-8);
    EXPECT_NEAR((*pair)[1].turn_rad, v.second_rad, 1e-8);
  }
}

TEST(CheapestPair, HasNoneWhereForwardArcsWithinTheRadiusDoNotLead) {
  EXPECT_FALSE(CheapestPair({0.3, 0.2, 0.0}, {0.5, Travel::kForward}));
}

// The least cost over 2 000 even splits and ever finer ones about the best.
double Searched(const Pose2& goal, const ArcLimits& limits) {
  double least = std::numeric_limits<double>::infinity(), best = 0.0;
  const auto Try = [&](double split) {
    const auto pair = PairOfSplit(goal, split);
    if (!pair || !Keeps(*pair, limits) || PairCost(*pair) >= least) return;
    least = PairCost(*pair);
    best = split;
  };
  constexpr int kSplits = 2000;
  for (int i = 0; i < kSplits; ++i) Try(kPi * i / kSplits);
  double gap = kPi / kSplits;
  for (int zoom = 0; std::isfinite(least) && zoom < 12; ++zoom, gap *= 0.1) {
    const double middle = best;
    for (int i = -20; i <= 20; ++i) Try(middle + 0.05 * i * gap);
  }
  return least;
}

// A twentieth of the goals lies on a circle, one straight ahead or behind. The search's pairs keep
// the limits to 1e-9 m, as ours, so its cost may be less by what that much of an arc is worth.
TEST(CheapestPair, CostsNoMoreThanABruteSearchOf10000Goals) {
  RandomStream random(StreamKey(2, "brute search"));
  int feasible = 0;
  for (int i = 0; i < 10'000; ++i) {
    Pose2 goal = AnyGoal(random);
    if (i % 20 == 0) goal.heading = WrapPi(2.0 * std::atan2(goal.y, goal.x));
    if (i % 20 == 1) goal.y = goal.heading = 0.0;
    const Travel travel = i % 4 == 0   ? Travel::kForward
                          : i % 4 == 1 ? Travel::kBackward
                                       : Travel::kEither;
    ArcLimits limits{i % 3 == 0 ? 0.0 : random.Uniform(0.3, 0.8), travel};
    if (i % 6 == 1) limits.pivot_radius_m = random.Uniform(0.0, 0.1);
    const auto pair = CheapestPair(goal, limits);
    const double searched = Searched(goal, limits);
    if (!pair) {
      EXPECT_FALSE(std::isfinite(searched)) << goal.x << " " << goal.y << " " << goal.heading;
      continue;
    }
    ++feasible;
    EXPECT_LE(PairCost(*pair), searched * (1.0 + 1e-9) + 5e-8);
    EXPECT_LT(Miss(EndOf(*pair), goal), 1e-9);
    EXPECT_TRUE(Keeps(*pair, limits));
  }
  EXPECT_GT(feasible, 8300);
}

}  // namespace
}  // namespace dockyard
