// Rover and station at the start of a run: at rest, and where they were told to be.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "axel/sim/product.h"
#include "axel/sim/scenarios.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

/// The typical start on this soil; the seed sets the ground and which paddles the wheels stand on.
WorldSetup SetupOf(const std::string& soil, int seed) {
  WorldSetup setup = Build(TypicalScenario({"soil=" + SourceFile("models/soils/" + soil + ".yaml"),
                                            "seed=" + std::to_string(seed)}))
                         .world;
  setup.slack_start_m = 0.2;  // the tether holds nothing
  return setup;
}

// A wheel that stands on a paddle's tip on firm ground creeps off it for seconds, whenever the
// settling ends: among these starts, one does.
TEST(Settling, EndsWhereASecondMoreOfItLeavesRoverAndStation) {
  int moved_on = 0;
  for (const char* soil : {"loose_sand", "compact_gravel"}) {
    for (int seed = 1; seed <= 6; ++seed) {
      World world(SetupOf(soil, seed));
      const Truth start = world.truth();
      Play(world, AllBraked(), 1.0);
      const Truth later = world.truth();
      const Pose3 moved = Inverse(start.X_WR) * later.X_WR;
      const double turned_rad = Eigen::AngleAxisd(moved.R).angle();
      if (moved.p.norm() > 1e-4 || turned_rad > 1e-4) ++moved_on;
      EXPECT_LT(moved.p.norm(), 1e-3) << soil << " " << seed;
      EXPECT_LT(turned_rad, 1e-3) << soil << " " << seed;
      EXPECT_LT(std::fabs(later.arm_rad - start.arm_rad), 1e-5) << soil << " " << seed;
      EXPECT_LT((later.X_WS.p - start.X_WS.p).norm(), 1e-7) << soil << " " << seed;
    }
  }
  EXPECT_LE(moved_on, 1);
}

TEST(Settling, LeavesTheRoverWithinMillimetresOfWhereItIsTold) {
  for (const char* soil : {"loose_sand", "compact_gravel"}) {
    for (int seed = 1; seed <= 6; ++seed) {
      const WorldSetup setup = SetupOf(soil, seed);
      const Pose2 is = ToGround(World(setup).truth().X_DR), &told = setup.X_DR_start;
      EXPECT_LT(std::hypot(is.x - told.x, is.y - told.y), 2e-3) << soil << " " << seed;
      EXPECT_NEAR(std::remainder(is.heading - told.heading, 2.0 * kPi), 0.0, 2e-3);
    }
  }
}

/// The feet's balance in closed form leaves nothing to settle, on a slope but their friction's
/// bend.
TEST(Settling, PutsTheStationDownAtRest) {
  for (const double slope_deg : {0.0, 8.0}) {
    WorldSetup setup = SetupOf("compact_gravel", 1);
    setup.slope = {Radians(slope_deg), Radians(40.0)};
    setup.X_DR_start.x += 3.0;
    World world(setup);
    const Pose3 X_DS = Inverse(SiteInWorld(setup.X_WG, setup.slope) * FromGround(setup.X_GD, 0.0)) *
                       world.truth().X_WS;
    const double bend_m = setup.station.module.mass_kg * 9.81 * std::sin(Radians(slope_deg)) /
                          (4.0 * setup.station.foot_stiffness_n_per_m);
    EXPECT_NEAR(X_DS.p.head<2>().norm(), bend_m, 0.1 * bend_m + 1e-5);
  }
}

}  // namespace
}  // namespace dockyard::axel
