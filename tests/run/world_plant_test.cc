// Plants whose world is computed step by step.
#include "sim/run/world_plant.h"

#include <gmock/gmock.h>

#include "run/cart.h"

namespace dockyard::cart {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

CartPlant PlantAt(double speed_m_s, double step_s = 1e-3) {
  Scenario scenario;
  scenario.physics_step_s = step_s;
  return {scenario, {{speed_m_s}, {}}, std::make_shared<KeptRenderer>()};
}

Commands Braked(std::size_t motors) {
  Commands commands;
  commands.motors.resize(motors);
  return commands;
}

TEST(WorldPlant, TakesTheNearestNumberOfStepsInAPeriod) {
  EXPECT_EQ(PlantAt(0.0, 1e-3).StepsIn(20), 20);
  EXPECT_EQ(PlantAt(0.0, 5e-4).StepsIn(20), 40);
  EXPECT_EQ(PlantAt(0.0, 1e-4).StepsIn(20), 200);
  EXPECT_EQ(PlantAt(0.0, 3e-3).StepsIn(20), 7);  // 6.67
  EXPECT_EQ(PlantAt(0.0, 3e-3).StepsIn(10), 3);  // 3.33
}

TEST(WorldPlant, KeepsTheTruthOfTheLastReadingUntilTheNext) {
  CartPlant plant = PlantAt(0.5);
  const auto channels = [&] {
    std::vector<double> values{7.0};  // of somebody else
    plant.AppendChannels(values);
    return values;
  };
  plant.Advance(Braked(1));
  plant.Advance(Braked(1));
  EXPECT_EQ(plant.tick(), 40);
  EXPECT_THAT(channels(), ElementsAre(7.0, 0.0, 0.0));
  plant.Sense();
  EXPECT_THAT(channels(), ElementsAre(7.0, DoubleEq(0.04), DoubleEq(0.5 * 0.04)));
}

TEST(WorldPlant, HasTheGroundInItsLastFingerprintAlone) {
  CartPlant level = PlantAt(0.5), same = PlantAt(0.5), pressed = PlantAt(0.5), other = PlantAt(0.5);
  pressed.world().Press(1, 1e-9);
  other.world().Press(2, 1e-9);
  EXPECT_EQ(level.FinalHash(1), same.FinalHash(1));
  EXPECT_EQ(level.StateHash(1), pressed.StateHash(1));
  EXPECT_NE(level.FinalHash(1), pressed.FinalHash(1));
  EXPECT_NE(level.FinalHash(1), other.FinalHash(1));
  EXPECT_NE(pressed.FinalHash(1), other.FinalHash(1));
  EXPECT_NE(level.FinalHash(1), level.FinalHash(2));
  same.Advance(Braked(1));
  EXPECT_NE(level.FinalHash(1), same.FinalHash(1));  // it has the world's state too
}

TEST(WorldPlant, ShowsItsGroundWhereTheYardIs) {
  CartPlant plant = PlantAt(0.0);
  plant.world().Press(3, 0.25);
  const Pose3 X_WG{RotZ(0.3), Eigen::Vector3d(1.0, 2.0, 3.0)},
      X_WD{RotZ(-0.2), Eigen::Vector3d(4.0, 5.0, 6.0)};
  const Stage stage = plant.StageOn(X_WG, X_WD, {0.1, 0.2, 0.3});
  EXPECT_EQ(stage.X_WD.p, X_WD.p);
  EXPECT_EQ(stage.X_WD.R, X_WD.R);
  EXPECT_EQ(stage.ground.X_WG.p, X_WG.p);
  EXPECT_EQ(stage.ground.X_WG.R, X_WG.R);
  EXPECT_EQ(stage.ground.x0_m, -1.0);
  EXPECT_EQ(stage.ground.y0_m, -2.0);
  EXPECT_EQ(stage.ground.cell_m, 0.5);
  EXPECT_EQ(stage.ground.revision, 1u);
  EXPECT_EQ(stage.ground.rgb, Eigen::Vector3d(0.1, 0.2, 0.3));
  ASSERT_EQ(stage.ground.nx * stage.ground.ny, 4);
  EXPECT_EQ(stage.ground.heights_m[2], 2.0);
  EXPECT_EQ(stage.ground.heights_m[3], 2.75);
}

TEST(WorldPlant, TakesACommandForEachOfItsMotorsAndNoOther) {
  CartPlant plant = PlantAt(0.0);
  Commands commands = Braked(1);
  commands.motors[0].target = 0.7;
  plant.Advance(commands);
  EXPECT_EQ(plant.motor(), commands.motors[0]);
  EXPECT_DEATH(plant.Advance(Braked(0)), "check failed");
  EXPECT_DEATH(plant.Advance(Braked(2)), "check failed");
}

}  // namespace
}  // namespace dockyard::cart
