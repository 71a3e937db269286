// The mating parts: disc, shaft and collar in throat and socket, drawn in by the spool alone.
#include <gtest/gtest.h>

#include <cmath>

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
  const Tick reeled = std::lround(seconds / kTickSeconds);
  while (world.tick() < reeled) world.Step(commands);
  while (world.tick() < reeled + 1000) world.Step({});
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
    const ShakeResult shake = Shake(world, built.world.rover, built.world.station);
    EXPECT_LT(Degrees(shake.turn_rad), 4.5) << soil;
    EXPECT_LT(shake.travel_m, 0.01) << soil;
  }
}

// The judge drives away with what it holds: a loose station comes along, one that
// does not slide stays.
TEST(Mating, DragOfTheShakeIsNoPushOfTheDocking) {
  for (const bool anchored : {false, true}) {
    BuiltRun built = Built("compact_gravel", 0.0);
    if (anchored) built.world.station.foot_friction = 3.0;
    World world(built.world);
    Reel(world, built.world.rover, 22.0);
    const Truth before = world.truth();
    Truth last;
    const ShakeResult shake =
        Shake(world, built.world.rover, built.world.station, [&](const Truth& now) {
          EXPECT_EQ(now.station_shift_m, before.station_shift_m);
          last = now;
        });
    const Eigen::Vector3d p_SM = MouthInStation(built.world.station).p;
    EXPECT_NEAR(last.station_shake_m, (world.truth().X_WS * p_SM - before.X_WS * p_SM).norm(),
                1e-12);
    EXPECT_GE(shake.station_m, last.station_shake_m);
    if (anchored) {
      EXPECT_LT(shake.station_m, 0.004);
    } else {
      EXPECT_GT(shake.station_m, 0.006);
    }
  }
}

// The judge's shake lasts as long and turns as far at every step of the physics.
TEST(Mating, ShakeTurnsTheSeatedArmAlikeAtEveryStep) {
  double fine_rad = 0.0;
  for (const double step_s : {0.5e-3, 1e-3, 2e-3}) {
    const BuiltRun built =
        Built("compact_gravel", 3.0, {"physics_step_s=" + std::to_string(step_s)});
    World world(built.world);
    Reel(world, built.world.rover, 22.0);
    const Tick start = world.tick();
    const ShakeResult shake = Shake(world, built.world.rover, built.world.station);
    EXPECT_EQ(world.tick() - start, 9680);
    if (fine_rad == 0.0) fine_rad = shake.turn_rad;
    EXPECT_NEAR(Degrees(shake.turn_rad), Degrees(fine_rad), 0.3) << step_s;
  }
}

}  // namespace
}  // namespace dockyard::axel
