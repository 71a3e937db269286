// Two arcs against brute force as fine as the certificate asks for. Minutes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "controller/motion/free_path.h"
#include "controller/motion/steering.h"
#include "motion/rover_sample.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

constexpr int kSplits = 20'000;

// Calls look for all splits whose pairs keep the limits by more than rounding: Keeps lets 1e-9 m
// through, on which the search must not win.
template <class Look>
void ForEachSplit(const Pose2& goal, ArcLimits limits, const Look& look) {
  if (limits.least_radius_m > 0.0) limits.least_radius_m += 1e-9;
  if (limits.pivot_radius_m) *limits.pivot_radius_m = std::max(0.0, *limits.pivot_radius_m - 1e-9);
  for (int i = 0; i < kSplits; ++i) {
    const auto pair = PairOfSplit(goal, kPi * i / kSplits);
    if (pair && Keeps(*pair, limits)) look(*pair);
  }
}

Pose2 AnyGoal(RandomStream& random, int i) {
  Pose2 goal{random.Uniform(-3, 3), random.Uniform(-3, 3), random.Uniform(-kPi, kPi)};
  if (i % 20 == 0) goal.heading = WrapPi(2.0 * std::atan2(goal.y, goal.x));  // on a circle
  if (i % 20 == 1) goal.y = goal.heading = 0.0;                              // on a line
  return goal;
}

ArcLimits AnyLimits(RandomStream& random, int i) {
  ArcLimits limits{i % 3 == 0 ? 0.0 : random.Uniform(0.3, 0.8), i % 4 == 0   ? Travel::kForward
                                                                : i % 4 == 1 ? Travel::kBackward
                                                                             : Travel::kEither};
  if (i % 6 == 1) limits.pivot_radius_m = random.Uniform(0.0, 0.1);
  return limits;
}

TEST(CheapestPairSurvey, CostsNoMoreThanThe20000SplitsOfEachOf10000Goals) {
  RandomStream random(StreamKey(11, "pair survey"));
  int feasible = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Pose2 goal = AnyGoal(random, i);
    const ArcLimits limits = AnyLimits(random, i);
    double searched = std::numeric_limits<double>::infinity();
    ForEachSplit(goal, limits,
                 [&](const ArcPair& pair) { searched = std::min(searched, PairCost(pair)); });
    const auto pair = CheapestPair(goal, limits);
    feasible += pair.has_value();
    EXPECT_TRUE(pair || !std::isfinite(searched)) << i;
    if (pair) {
      EXPECT_LE(PairCost(*pair), searched * (1.0 + 1e-9)) << i;
    }
  }
  EXPECT_GT(feasible, 8300);
}

TEST(CheapestFreePairSurvey, IsFoundWhereThe20000SplitsHaveOneAndCostsNoMore) {
  RandomStream random(StreamKey(12, "free pair survey"));
  const RoverPlan rover = RockySample();
  const ArcLimits limits = LimitsOf(rover.wheels, Travel::kEither);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 goal{random.Uniform(0.5, 3), random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5)};
    const PathDemands demands = SampleDemands(random, goal, 30, i % 2 == 1);
    double searched = std::numeric_limits<double>::infinity();
    ForEachSplit(goal, limits, [&](const ArcPair& pair) {
      if (PairCost(pair) >= searched) return;
      if (MissingOf(rover, demands, {pair.begin(), pair.end()}) == 0.0) searched = PairCost(pair);
    });
    const auto pair = CheapestFreePair(rover, goal, limits, demands);
    found += pair.has_value();
    EXPECT_TRUE(pair || !std::isfinite(searched)) << i;
    if (pair) {
      EXPECT_LE(PairCost(*pair), searched * (1.0 + 1e-9)) << i;
    }
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace dockyard
