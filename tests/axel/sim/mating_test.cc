// The mating parts: disc, shaft and collar in throat and socket, drawn in by the spool alone.
#include <gtest/gtest.h>

#include "axel/sim/scenarios.h"
#include "sim/axel/build_run.h"
#include "sim/axel/shake.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

BuiltRun Built(const std::string& soil, double alpha_deg, std::vector<std::string> sets = {}) {
  sets.insert(sets.begin(),
              {"start={r_m: 1.4, alpha_deg: " + std::to_string(alpha_deg) + ", heading_deg: 0}",
               "soil=" + SourceFile("models/soils/" + soil + ".yaml")});
  return Build(TypicalScenario(sets));
}

/// Wheels free, the spool at its limit for so long; then all brakes for a second.
Truth Reel(World& world, const RoverModel& rover, double seconds) {
  std::array<MotorCommand, kMotorCount> commands{};
  commands[0].mode = commands[1].mode = MotorMode::kFree;
  const MotorModel& spool = rover.motors[static_cast<std::size_t>(Motor::kSpool)];
  commands[static_cast<std::size_t>(Motor::kSpool)] = {.mode = MotorMode::kVelocity,
                                                       .target = 0.05 / rover.tether.drum_radius_m,
                                                       .accel_rad_s2 = 2.0,
                                                       .current_limit_a = spool.max_current_a};
  for (int i = 0; i < static_cast<int>(1000 * seconds); ++i) world.Step(commands);
  for (int i = 0; i < 1000; ++i) world.Step({});
  return world.truth();
}

/// From contact the spool reels so much of the tether and is braked.
Truth ReelFromContact(World& world, const RoverModel& rover, double reel_m) {
  std::array<MotorCommand, kMotorCount> commands{};
  commands[0].mode = commands[1].mode = MotorMode::kFree;
  constexpr int kSpool = static_cast<int>(Motor::kSpool);
  commands[kSpool] = {.mode = MotorMode::kVelocity,
                      .target = 0.05 / rover.tether.drum_radius_m,
                      .accel_rad_s2 = 2.0,
                      .current_limit_a = rover.motors[kSpool].max_current_a};
  while (world.truth().p_MT.x() > 0.0) world.Step(commands);
  const double start_m = world.truth().tether_free_m;
  for (int i = 0; i < 8000 && start_m - world.truth().tether_free_m < reel_m; ++i) {
    world.Step(commands);
  }
  for (int i = 0; i < 2000; ++i) world.Step({});
  return world.truth();
}

TEST(Mating, ArmReeled25CmFromContactIsSeatedWithHalfACentimetreToSpare) {
  for (const char* soil : {"compact_gravel", "loose_sand"}) {
    for (double alpha_deg : {-1.0, 0.0, 1.0}) {
      for (double reel_m : {0.245, 0.25}) {  // 25 cm: Tsai et al., II
        const BuiltRun built = Built(soil, alpha_deg);
        World world(built.world);
        const Truth seated = ReelFromContact(world, built.world.rover, reel_m);
        EXPECT_NEAR(-seated.p_MT.x(), built.world.station.cone.stop_depth_m, 0.005)
            << soil << ", " << alpha_deg << " deg, " << reel_m << " m";
      }
    }
  }
}

TEST(Mating, ArmThatComesThreeDegreesAskewIsDrawnInAndHeld) {
  for (const char* soil : {"compact_gravel", "loose_sand"}) {
    const BuiltRun built = Built(soil, 3.0);
    World world(built.world);
    const Truth seated = Reel(world, built.world.rover, 22.0);
    EXPECT_NEAR(-seated.p_MT.x(), built.world.station.cone.stop_depth_m, 0.005) << soil;
    EXPECT_GT(seated.tether_tension_n, 5.0) << soil;
    const ShakeResult shake = Shake(world, built.world.rover);
    EXPECT_LT(Degrees(shake.turn_rad), 4.5) << soil;
    EXPECT_LT(shake.travel_m, 0.01) << soil;
  }
}

}  // namespace
}  // namespace dockyard::axel
