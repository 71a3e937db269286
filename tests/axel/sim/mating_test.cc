// The mating parts: disc, shaft and collar in throat and socket, drawn in by the spool alone.
#include <gtest/gtest.h>

#include "axel/sim/scenarios.h"
#include "sim/axel/build_run.h"
#include "sim/axel/shake.h"

namespace dockyard::axel {
namespace {

std::string Source(const std::string& name) { return std::string(DOCKYARD_SOURCE_DIR "/") + name; }

BuiltRun Built(const std::string& soil, double alpha_deg, std::vector<std::string> sets = {}) {
  sets.insert(sets.begin(),
              {"start={r_m: 1.4, alpha_deg: " + std::to_string(alpha_deg) + ", heading_deg: 0}",
               "soil=" + Source("models/soils/" + soil + ".yaml")});
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

TEST(Mating, ArmThatComesThreeDegreesAskewIsDrawnInAndHeld) {
  for (const char* soil : {"compact_gravel", "loose_sand"}) {
    const BuiltRun built = Built(soil, 3.0);
    World world(built.world);
    const Truth seated = Reel(world, built.world.rover, 22.0);
    EXPECT_LT(seated.p_MT.x(), -0.22) << soil;
    EXPECT_GT(seated.tether_tension_n, 5.0) << soil;
    const ShakeResult shake = Shake(world, built.world.rover);
    EXPECT_LT(Degrees(shake.turn_rad), 3.0) << soil;
    EXPECT_LT(shake.travel_m, 0.01) << soil;
  }
}

}  // namespace
}  // namespace dockyard::axel
