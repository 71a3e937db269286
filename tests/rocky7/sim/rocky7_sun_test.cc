// Rocky 7's images under a sun that moves.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/plant/sun_motion.h"
#include "sim/rocky7/rocky7_plant.h"
#include "support/bad_files.h"

namespace dockyard::rocky7 {
namespace {

Scenario UnderSun(bool moving) {
  Scenario scenario;
  scenario.name = "test";
  scenario.system = "rocky7";
  scenario.robot_file = SourceFile("models/rocky7/rocky7.yaml");
  scenario.soil_file = SourceFile("models/soils/compact_gravel.yaml");
  scenario.start = {1.3, 0.0, 0.0};
  scenario.yard.length_m = scenario.yard.width_m = 4.0;
  scenario.yard.cell_m = 0.01;
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
