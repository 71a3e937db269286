// The check of a start against the yard, and the ground that the run is then given.
#include <gtest/gtest.h>

#include <string>

#include "axel/sim/scenarios.h"
#include "models/read/config_error.h"

namespace dockyard::axel {
namespace {

Scenario At(double r_m) {
  return TypicalScenario({"yard={length_m: 8, cell_m: 0.05}", "start.alpha_deg=0",
                          "start.r_m=" + std::to_string(r_m)});
}

TEST(Yard, TakesStartsToOneMetreBeforeTheEndOfItsGround) {
  const HeightGrid ground = Build(At(3.0)).world.ground;
  EXPECT_DOUBLE_EQ(ground.x0_m, -kYardBehind_m);
  const double end = ground.x0_m + (ground.nx - 1) * ground.cell_m;
  EXPECT_NO_THROW(At(end - 1.001));
  EXPECT_THROW(At(end - 0.999), ConfigError);
}

}  // namespace
}  // namespace dockyard::axel
