// Rocky 7's images under a sun that moves.
#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/sim/test_scenario.h"
#include "sim/plant/sun_motion.h"
#include "sim/rocky7/rocky7_plant.h"

namespace dockyard::rocky7 {
namespace {

Scenario UnderSun(bool moving) {
  Scenario scenario = OnGravel("{}", 1.3, 4.0);
  scenario.light = Light::kHardShadow;
  scenario.sun.moving = moving;
  return scenario;
}

TEST(Rocky7Sun, OfASceneIsThatOfTheTruthsTime) {
  const Scenario scenario = UnderSun(true);
  const BuiltRun built = BuildRun(scenario, LoadModels(scenario));
  const World world(built.world);
  const SceneBuilder builder(built, world.rover(), scenario.seed);
  Truth truth = world.truth();
  const SunAndSky start = builder.Make(truth, world.ground()).light;
  EXPECT_EQ(start.to_sun_W, built.lighting.sun_and_sky.to_sun_W);
  truth.time_s = 3600.0;
  const SunAndSky later = builder.Make(truth, world.ground()).light;
  EXPECT_EQ(later.to_sun_W, LightAt(built.lighting, 3600.0).to_sun_W);
  EXPECT_LT(later.to_sun_W.dot(start.to_sun_W), std::cos(Radians(10.0)));
}

GrayImage FrontLeftAfter(const Scenario& scenario, double seconds) {
  Rocky7Plant plant(scenario, BuildRun(scenario, LoadModels(scenario)),
                    std::make_shared<KeptRenderer>());
  Commands braked;
  braked.motors.resize(plant.built().nominal.motors.size());
  for (int i = 0; i < seconds / (kControlPeriod * kTickSeconds); ++i) plant.Advance(braked);
  plant.RefreshTruth();
  return std::get<GrayImage>(plant.TakeImages({kFrontLeft}, 0.0).at(0).pixels);
}

TEST(Rocky7Sun, AnImageTakenLaterHasTheLightOfItsTime) {
  EXPECT_EQ(FrontLeftAfter(UnderSun(true), 0.0), FrontLeftAfter(UnderSun(false), 0.0));
  EXPECT_NE(FrontLeftAfter(UnderSun(true), 10.5), FrontLeftAfter(UnderSun(false), 10.5));
}

}  // namespace
}  // namespace dockyard::rocky7
