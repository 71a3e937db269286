#include "controller/motion/three_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/random.h"

namespace dockyard {
namespace {

double Miss(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) + std::abs(WrapPi(a.heading - b.heading));
}

bool Any(const Arc&) { return true; }

double WayOf(const ArcTriple& arcs) { return Length({arcs.begin(), arcs.end()}); }

// The shortest way by three arcs, infinite where none keeps the limits.
double ShortestTriple(const Pose2& goal, const ArcLimits& limits) {
  double shortest = std::numeric_limits<double>::infinity();
  ForEachTriple(goal, FirstArcs(limits, 0.25, 2.0, 2), limits, 24, Any,
                [&](const ArcTriple& arcs) { shortest = std::min(shortest, WayOf(arcs)); });
  return shortest;
}

TEST(FirstArcs, AreNoneAndThoseWithinTheLimits) {
  const ArcLimits limits{0.8, Travel::kBackward};
  const auto firsts = FirstArcs(limits, 0.5, 1.0, 2);
  EXPECT_EQ(firsts.front(), Arc{});
  // Two lengths, straight and by two curvatures to either side.
  EXPECT_EQ(firsts.size(), 1U + 2 * (1 + 2 * 2));
  for (const Arc& arc : firsts) {
    EXPECT_TRUE(Keeps(arc, limits));
    EXPECT_LE(arc.length_m, 0.0);
  }
}

TEST(Triples, EndAtTheGoalTo1e9WhateverTheFirstArc) {
  RandomStream random(StreamKey(1, "triples"));
  const ArcLimits limits{0.5};
  double worst = 0.0;
  int found = 0;
  for (int i = 0; i < 10'000; ++i) {
    Pose2 goal{random.Uniform(-3, 3), random.Uniform(-3, 3), random.Uniform(-kPi, kPi)};
    if (i % 20 == 0) goal.heading = WrapPi(2.0 * std::atan2(goal.y, goal.x));
    if (i % 20 == 10) goal = {0.0, 0.0, goal.heading};  // a turn at the rover's own place
    const Arc first{random.Uniform(-2, 2), random.Uniform(-1, 1)};
    ForEachTriple(goal, {first}, limits, 6, Any, [&](const ArcTriple& arcs) {
      ++found;
      EXPECT_EQ(arcs[0], first);
      EXPECT_TRUE(Keeps(arcs[1], limits) && Keeps(arcs[2], limits));
      worst = std::max(worst, Miss(Advance({}, {arcs.begin(), arcs.end()}), goal));
    });
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_GT(found, 30'000);
}

TEST(Triples, ArePairsWhereTheFirstArcIsNone) {
  const Pose2 goal{2.0, 1.0, 0.4};
  double pairs = 0.0, triples = 0.0;
  ForEachPair(goal, {}, 12, [&](const ArcPair& pair) { pairs += PairCost(pair); });
  ForEachTriple(goal, {{}}, {}, 12, Any, [&](const ArcTriple& arcs) {
    triples += PairCost({arcs[1], arcs[2]});
  });
  EXPECT_EQ(pairs, triples);
}

TEST(Triples, SkipFirstArcsThatAreNotWanted) {
  int seen = 0;
  ForEachTriple(
      {2.0, 1.0, 0.4}, FirstArcs({}, 0.5, 1.0, 0), {}, 12,
      [](const Arc& arc) { return arc.length_m < -0.75; },
      [&](const ArcTriple& arcs) {
        ++seen;
        EXPECT_EQ(arcs[0].length_m, -1.0);
      });
  EXPECT_GT(seen, 0);
}

TEST(Triples, TurnTheCourseOnceBehindAWayBackwards) {
  const Pose2 goal{2.0, 1.0, 0.4}, turned{0.0, 0.0, 0.2};
  const Arc back{-0.5, 0.1}, on{0.5, 0.1};
  const auto Misses = [&](const Arc& first, const Pose2& between, double cusp_turn_rad) {
    double worst = 0.0;
    ForEachTriple(
        goal, {first}, {}, 12, Any,
        [&](const ArcTriple& arcs) {
          const Pose2 end = Advance({}, first) * between;
          worst = std::max(worst, Miss(Advance(end, {arcs[1], arcs[2]}), goal));
        },
        cusp_turn_rad);
    return worst;
  };
  EXPECT_LT(Misses(back, turned, 0.2), 1e-9);
  EXPECT_LT(Misses(on, {}, 0.2), 1e-9);
  EXPECT_GT(Misses(back, {}, 0.2), 0.1);
}

// Two arcs of a least radius miss a fifth of the poses near by; a turn at one place they never do.
TEST(Triples, ReachWhatPairsMiss) {
  RandomStream random(StreamKey(2, "near goals"));
  const ArcLimits limits{0.5};
  int missed = 0;
  for (int i = 0; i < 100; ++i) {
    const Pose2 goal{random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-kPi, kPi)};
    if (!CheapestPair(goal, limits)) ++missed;
    EXPECT_TRUE(std::isfinite(ShortestTriple(goal, limits)));
  }
  EXPECT_GT(missed, 10);
  EXPECT_TRUE(std::isfinite(ShortestTriple({0.0, 0.0, 1.0}, limits)));
}

}  // namespace
}  // namespace dockyard
