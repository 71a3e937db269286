// Which of a yard's stones are loose, and the gravel that cameras detect.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rocky7/sim/test_scenario.h"
#include "sim/rigid/rocks.h"
#include "sim/rocky7/build_run.h"
#include "sim/rocky7/load_models.h"

namespace dockyard::rocky7 {
namespace {

BuiltRun DenseYard(const std::string& keys, std::uint64_t seed) {
  Scenario scenario = OnGravel(keys, 1.6, 5.0);
  scenario.rocks.cover = 0.1;
  scenario.rocks.least_m = 0.02;
  scenario.rocks.largest_m = 0.15;
  scenario.rocks.clear_m = 0.0;
  scenario.seed = seed;
  return BuildRun(scenario, LoadModels(scenario));
}

// Mean of length and width, as the law of sizes counts it.
double Diameter_m(const ConvexBody& stone) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : stone.vertices) box.extend(p);
  return 0.5 * box.sizes().head<2>().sum();
}

TEST(StonesAboutTheTarget, SmallOnesNearItAreLooseAndNoOthers) {
  const BuiltRun run = DenseYard("{task: grasp, loose_below_m: 0.06, loose_within_m: 0.8}", 3);
  EXPECT_GE(run.world.loose_stones.size(), 5u);
  // A stone is turned about the vertical: its box is up to a third wider than its mean diameter.
  for (const ConvexBody& stone : run.world.loose_stones) {
    EXPECT_LT(Diameter_m(stone), 0.06 * 1.35);
    EXPECT_LT(stone.centre.head<2>().norm(), 0.8 + 0.06);
  }
  for (const ConvexBody& stone : run.world.stones) {
    const bool is_small = Diameter_m(stone) < 0.06 / 1.35;
    EXPECT_FALSE(is_small && stone.centre.head<2>().norm() < 0.75);
  }
}

// In a mean of several yards as many as Golombek and Rapp's law has between the two sizes.
TEST(StonesAboutTheTarget, GravelIsAsDenseAsTheLawOfTheField) {
  constexpr int kYards = 4;
  double count = 0.0;
  for (int seed = 1; seed <= kYards; ++seed) {
    const BuiltRun run =
        DenseYard("{task: grasp, gravel_within_m: 1}", static_cast<std::uint64_t>(seed));
    for (const ConvexBody& pebble : run.gravel) {
      EXPECT_GT(Diameter_m(pebble), 0.005 / 1.35);
      EXPECT_LT(Diameter_m(pebble), 0.02 * 1.35);
      EXPECT_GT(pebble.centre.head<2>().norm(), 0.02);  // not in the target
    }
    count += static_cast<double>(run.gravel.size());
  }
  const double mean = kYards * kPi * RocksPerArea(0.1, 0.005, 0.02);
  // Larger stones cover a tenth of the ground.
  EXPECT_NEAR(count, 0.9 * mean, 4.0 * std::sqrt(mean));
}

TEST(StonesAboutTheTarget, AreNotMovedWhereNoneIsAskedFor) {
  const BuiltRun run = DenseYard("{task: grasp, loose_within_m: 0, gravel_within_m: 0}", 3);
  EXPECT_TRUE(run.world.loose_stones.empty());
  EXPECT_TRUE(run.gravel.empty());
}

}  // namespace
}  // namespace dockyard::rocky7
