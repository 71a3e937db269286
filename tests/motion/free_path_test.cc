#include "controller/motion/free_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "controller/motion/extreme_arcs.h"
#include "controller/motion/steering.h"
#include "motion/rover_sample.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

double Miss(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) + std::abs(WrapPi(a.heading - b.heading));
}

struct Problem {
  Pose2 goal;
  PathDemands demands;
};

// Discs strewn before the rover, none at the start or the goal.
Problem AnyProblem(RandomStream& random, int discs) {
  Problem problem{{random.Uniform(0.5, 3), random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5)},
                  {}};
  problem.demands.margin_m = 0.02;
  std::vector<Disc>& placed = problem.demands.obstacles.discs;
  while (static_cast<int>(placed.size()) < discs) {
    const Disc disc{{random.Uniform(-1, 4), random.Uniform(-2, 2)}, random.Uniform(0.05, 0.2)};
    if (disc.centre.norm() < 0.8 || (Inverse(problem.goal) * disc.centre).norm() < 0.8) continue;
    placed.push_back(disc);
  }
  return problem;
}

double Searched(const RoverPlan& rover, const Problem& problem, const ArcLimits& limits) {
  double least = std::numeric_limits<double>::infinity();
  constexpr int kSplits = 1000;
  for (int i = 0; i < kSplits; ++i) {
    const auto pair = PairOfSplit(problem.goal, kPi * i / kSplits);
    if (!pair || !Keeps(*pair, limits) || PairCost(*pair) >= least) continue;
    if (MissingOf(rover, problem.demands, {pair->begin(), pair->end()}) == 0.0) {
      least = PairCost(*pair);
    }
  }
  return least;
}

TEST(CheapestFreePair, IsFoundWhereABruteSearchFindsOneAndCostsNoMore) {
  RandomStream random(StreamKey(1, "free pairs"));
  const RoverPlan rover = RockySample();
  const ArcLimits limits = LimitsOf(rover.wheels, Travel::kEither);
  int found = 0, otherwise = 0;
  for (int i = 0; i < 40; ++i) {
    const Problem problem = AnyProblem(random, i % 2 == 0 ? 12 : 5);
    const auto pair = CheapestFreePair(rover, problem.goal, limits, problem.demands);
    const double searched = Searched(rover, problem, limits);
    if (!pair) {
      EXPECT_FALSE(std::isfinite(searched));
      continue;
    }
    ++found;
    EXPECT_LE(PairCost(*pair), searched * (1.0 + 1e-9));
    EXPECT_LT(Miss(Advance({}, {pair->begin(), pair->end()}), problem.goal), 1e-9);
    EXPECT_TRUE(Keeps(*pair, limits));
    EXPECT_EQ(MissingOf(rover, problem.demands, {pair->begin(), pair->end()}), 0.0);
    if (PairCost(*pair) > PairCost(*CheapestPair(problem.goal, limits)) + 1e-9) ++otherwise;
  }
  EXPECT_GT(found, 15);
  EXPECT_GT(otherwise, 6);  // it went round something
}

TEST(CheapestFreePair, KeepsATargetInView) {
  const RoverPlan rover = RockySample();
  const ArcLimits limits = LimitsOf(rover.wheels, Travel::kEither);
  const Pose2 goal{1.5, 0.8, 0.3};
  PathDemands demands;
  demands.p_AT = goal * Eigen::Vector2d(0.9, 0.0);
  const auto free = CheapestPair(goal, limits);
  const auto pair = CheapestFreePair(rover, goal, limits, demands);
  ASSERT_TRUE(free && pair);
  EXPECT_EQ(MissingOf(rover, demands, {pair->begin(), pair->end()}), 0.0);
  demands.p_AT = Eigen::Vector2d(-1.0, 0.0);  // behind
  EXPECT_FALSE(CheapestFreePair(rover, goal, limits, demands));
}

TEST(ExtremeTriples, EndAtTheGoalWithinTheLimits) {
  RandomStream random(StreamKey(2, "extreme"));
  int words = 0;
  for (int i = 0; i < 3000; ++i) {
    const Pose2 goal{random.Uniform(-3, 3), random.Uniform(-3, 3), random.Uniform(-kPi, kPi)};
    const ArcLimits limits{i % 5 == 0 ? 0.0 : 0.5, i % 3 == 0   ? Travel::kForward
                                                   : i % 3 == 1 ? Travel::kBackward
                                                                : Travel::kEither};
    for (const ArcTriple& arcs : ExtremeTriples(goal, limits.least_radius_m, limits.travel)) {
      ++words;
      EXPECT_LT(Miss(Advance({}, {arcs.begin(), arcs.end()}), goal), 1e-9);
      for (const Arc& arc : arcs) EXPECT_TRUE(Keeps(arc, limits));
    }
  }
  EXPECT_GT(words, 10'000);
}

double LengthOf(const ArcTriple& arcs) { return Length({arcs.begin(), arcs.end()}); }

// The shortest ways of Reeds and Shepp, computed with OMPL 1.5.2 for a radius of 0.5 m.
TEST(ShortestFreeTriple, IsAsShortAsReedsAndSheppsWhereThatHasThreePieces) {
  const struct {
    Pose2 goal;
    double length_m;
  } rows[] = {{{-0.307, 0.154, -2.347}, 0.5 * (1.143 + 0.713 + 0.490)},
              {{0.135, 0.031, -1.359}, 0.5 * (0.596 + 0.561 + 0.202)},
              {{-0.049, 0.028, -0.401}, 0.5 * (0.008 + 0.146 + 0.247)},
              {{-0.340, 0.288, 2.413}, 0.5 * (0.254 + 0.924 + 1.235)}};
  for (const auto& row : rows) {
    const auto arcs = ShortestFreeTriple({}, row.goal, {0.5}, {});
    ASSERT_TRUE(arcs);
    EXPECT_NEAR(LengthOf(*arcs), row.length_m, 2e-3);
    EXPECT_LT(Miss(Advance({}, {arcs->begin(), arcs->end()}), row.goal), 1e-9);
  }
}

TEST(ShortestFreeTriple, GoesRoundWhatTwoArcsCannot) {
  RandomStream random(StreamKey(3, "free triples"));
  const RoverPlan rover = RockySample();
  const ArcLimits limits = LimitsOf(rover.wheels, Travel::kEither);
  int blocked = 0, solved = 0;
  for (int i = 0; i < 40 && blocked < 4; ++i) {
    const Problem problem = AnyProblem(random, 12);
    if (CheapestFreePair(rover, problem.goal, limits, problem.demands)) continue;
    ++blocked;
    const auto arcs = ShortestFreeTriple(rover, problem.goal, limits, problem.demands);
    if (!arcs) continue;
    ++solved;
    EXPECT_EQ(MissingOf(rover, problem.demands, {arcs->begin(), arcs->end()}), 0.0);
    EXPECT_LT(Miss(Advance({}, {arcs->begin(), arcs->end()}), problem.goal), 1e-9);
  }
  EXPECT_GT(solved, 0);
}

}  // namespace
}  // namespace dockyard
