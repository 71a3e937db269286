// Faults of the station that a scenario gives: carried aside under way, marks under dust.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "axel/sim/scenarios.h"
#include "sim/axel/world.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

constexpr double kAt = 2.0;

WorldSetup Moved(const std::string& soil) {
  const Scenario scenario =
      TypicalScenario({"axel.station_moved={at_s: 2, forward_m: 0.08, left_m: -0.06, turn_deg: 3}",
                       "soil=" + SourceFile("models/soils/" + soil + ".yaml")});
  return Build(scenario).world;
}

void PlayUntil(World& world, double seconds) {
  while (world.tick() * kTickSeconds < seconds) world.Step({});
}

Pose3 MouthOf(const World& world, const WorldSetup& setup) {
  return world.truth().X_WS * MouthInStation(setup.station);
}

class StationMoved : public testing::TestWithParam<const char*> {};

TEST_P(StationMoved, StandsWhereItWasCarried) {
  const WorldSetup setup = Moved(GetParam());
  World world(setup);
  const Pose3 before = MouthOf(world, setup);
  PlayUntil(world, kAt);
  EXPECT_LT((MouthOf(world, setup).p - before.p).norm(), 1e-4);
  PlayUntil(world, kAt + 6.0);
  // In the dock's own axes: its x is the way that the station faces, level.
  const Pose3 moved = Inverse(Pose3{RotZ(setup.X_GD.heading), before.p}) * MouthOf(world, setup);
  EXPECT_NEAR(moved.p.x(), 0.08, 0.004);
  EXPECT_NEAR(moved.p.y(), -0.06, 0.004);
  const Eigen::Matrix3d turn = MouthOf(world, setup).R * before.R.transpose();
  EXPECT_NEAR(std::atan2(turn(1, 0), turn(0, 0)), Radians(3.0), Radians(0.2));
}

// The shift is what the rover pushed, not what the hand did.
TEST_P(StationMoved, IsNotPushed) {
  World world(Moved(GetParam()));
  PlayUntil(world, kAt + 6.0);
  EXPECT_LT(world.truth().station_shift_m, 0.005);
}

INSTANTIATE_TEST_SUITE_P(On, StationMoved, testing::Values("loose_sand", "compact_gravel"));

TEST(StationStays, WithoutAMove) {
  const WorldSetup setup = Build(TypicalScenario()).world;
  World world(setup);
  const Pose3 before = MouthOf(world, setup);
  PlayUntil(world, 8.0);
  EXPECT_LT((MouthOf(world, setup).p - before.p).norm(), 1e-3);
}

TEST(DirtyMarks, AreAsManyAsAskedEachAnotherAndOthersWithAnotherSeed) {
  std::set<std::set<std::pair<double, double>>> choices;
  for (int seed = 1; seed <= 12; ++seed) {
    const BuiltRun run =
        Build(TypicalScenario({"axel.dirty_marks.count=3", "seed=" + std::to_string(seed)}));
    std::set<std::pair<double, double>> places;
    for (const DustySpot& spot : run.lighting.dusty_spots) {
      places.insert({spot.p_B.x(), spot.p_B.y()});
      EXPECT_EQ(spot.cover, 0.8);
    }
    EXPECT_EQ(places.size(), 3u);
    choices.insert(places);
  }
  EXPECT_GT(choices.size(), 6u);  // of 56; 12 draws of them have 10.9 different ones on average
}

TEST(DirtyMarks, AreNoneUnlessAskedFor) {
  EXPECT_TRUE(Build(TypicalScenario()).lighting.dusty_spots.empty());
}

}  // namespace
}  // namespace dockyard::axel
