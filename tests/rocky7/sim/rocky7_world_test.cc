#include "sim/rocky7/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/read/load_soil.h"
#include "models/rocky7/load_robot.h"
#include "sim/rigid/rocks.h"
#include "sim/vehicles/boulder.h"
#include "support/bad_files.h"

namespace dockyard::rocky7 {
namespace {

WorldSetup AtStart(const std::string& soil = "compact_gravel") {
  WorldSetup setup;
  setup.robot = LoadRobot(SourceFile("models/rocky7/rocky7.yaml"));
  setup.soil = LoadSoil(SourceFile("models/soils/" + soil + ".yaml"));
  setup.ground = LevelGrid(-1.5, 4.0, 4.0, 0.01);
  setup.X_GR_start = {1.2, 0.0, kPi};
  return setup;
}

std::vector<MotorCommand> Ahead(const World& world, double rad_s) {
  std::vector<MotorCommand> commands(static_cast<std::size_t>(world.rover().motor_count()));
  for (std::size_t i = 0; i < 6; ++i) {
    commands[i] = {MotorMode::kVelocity, rad_s, 0.0, 1.5, 2.0};
  }
  return commands;
}

TEST(Rocky7World, StandsStillUnderItsBrakes) {
  World world(AtStart());
  const Truth before = world.truth();
  const std::vector<MotorCommand> braked(static_cast<std::size_t>(world.rover().motor_count()));
  for (int i = 0; i < 2000; ++i) world.Step(braked);
  const Truth after = world.truth();
  EXPECT_LT((after.X_WR.p - before.X_WR.p).norm(), 2e-5);
  EXPECT_NEAR(before.p_GP.x(), 1.2 - 0.61, 1e-3);
  EXPECT_NEAR(before.p_GP.z(), 0.0, 0.01);
}

TEST(Rocky7World, SameCallsGiveTheSameBits) {
  World a(AtStart("loose_sand")), b(AtStart("loose_sand"));
  const auto commands = Ahead(a, 0.5);
  for (int i = 0; i < 1500; ++i) {
    a.Step(commands);
    b.Step(commands);
  }
  EXPECT_EQ(a.StateHash(1), b.StateHash(1));
  EXPECT_LT(a.truth().X_GR.x, 1.19);
}

// The stone lies before the left wheels, 15 cm ahead of the front one.
WorldSetup WithStone(const std::string& soil, double height_m) {
  WorldSetup setup = AtStart(soil);
  const ConvexBody stone = RockShape({2.0 * height_m, height_m}, 0.1, 0.0, 3);
  setup.stones = {Pose3::Translation(1.2 - 0.409 - 0.15, -0.2, 0.0) * stone};
  return setup;
}

// Its front wheel's climb of 2 cm pitches the left rocker by asin(0.02 / 0.409) about the bogie,
// and the body by half of that.
TEST(Rocky7World, ClimbsAStoneOnGravel) {
  World world(WithStone("compact_gravel", 0.02));
  const double before = std::asin(world.truth().X_WR.R(2, 0));
  const auto commands = Ahead(world, 0.7);
  double most = 0.0;
  for (int i = 0; i < 6000; ++i) {
    world.Step(commands);
    most = std::max(most, std::asin(world.truth().X_WR.R(2, 0)) - before);
  }
  EXPECT_NEAR(most, 0.5 * std::asin(0.02 / 0.409), 0.006);
  EXPECT_LT(world.truth().X_GR.x, 1.2 - 0.2);
  EXPECT_FALSE(world.truth().on_stone);
}

TEST(Rocky7World, PressesTheSameStoneIntoSand) {
  World gravel(WithStone("compact_gravel", 0.02)), sand(WithStone("loose_sand", 0.02));
  const auto commands = Ahead(gravel, 0.7);
  for (int i = 0; i < 6000; ++i) {
    gravel.Step(commands);
    sand.Step(commands);
  }
  EXPECT_GT(sand.truth().sunk_m[0], 3.0 * gravel.truth().sunk_m[0]);
  EXPECT_GT(sand.truth().sunk_m[0], 0.003);
}

// The wheel that climbs a bedded stone pushes a loose one out of its bed.
TEST(Rocky7World, PushesALooseStoneAside) {
  WorldSetup setup = WithStone("compact_gravel", 0.04);
  std::swap(setup.loose_stones, setup.stones);
  World world(setup);
  const Pose3 before = world.truth().X_GS.at(0);
  const auto commands = Ahead(world, 0.7);
  for (int i = 0; i < 6000; ++i) world.Step(commands);
  const Truth after = world.truth();
  EXPECT_GT((after.X_GS.at(0).p - before.p).norm(), 5e-3);
  EXPECT_LT(after.X_GR.x, 1.2 - 0.2);
}

TEST(Rocky7World, NoticesAStoneUnderTheBody) {
  WorldSetup setup = AtStart();
  setup.stones = {Pose3::Translation(1.2 - 0.6, 0.0, 0.0) * RockShape({0.2, 0.19}, 0.1, 0.0, 3)};
  World world(setup);
  const auto commands = Ahead(world, 0.7);
  for (int i = 0; i < 9000 && !world.truth().on_stone; ++i) world.Step(commands);
  EXPECT_TRUE(world.truth().on_stone);
}

// A boulder whose face points along x, and the rover before it, so that its tool, level, is aimed
// at the face's middle 0.45 m up: shoulder 11.5 deg up, elbow as much down.
WorldSetup BeforeBoulder(double stand_off_m) {
  WorldSetup setup = AtStart();
  const BoulderShape shape{.target_up_m = 0.45, .face_up_rad = 0.0, .roughness_m = 0.0};
  setup.boulder = MakeBoulder(shape, 3);
  setup.target_G = {0.0, 0.0, 0.45};
  setup.X_GR_start = {0.05 + stand_off_m, 0.0, kPi};
  return setup;
}

std::vector<MotorCommand> MastTo(const World& world, double shoulder_rad, double elbow_rad) {
  std::vector<MotorCommand> commands(static_cast<std::size_t>(world.rover().motor_count()));
  const double targets[] = {0.0, shoulder_rad, elbow_rad};
  for (std::size_t i = 0; i < 3; ++i) {
    commands[commands.size() - 3 + i] = {MotorMode::kPosition, targets[i], 0.3, 0.5, 2.0};
  }
  return commands;
}

TEST(Rocky7World, TheInstrumentTouchesTheFaceWhereTheMastBringsIt) {
  const double a = std::asin(0.1 / 0.5), reach_m = 0.5 * std::cos(a) + 0.5;
  for (const bool touches : {false, true}) {
    World world(BeforeBoulder(reach_m + (touches ? -0.012 : 0.02)));
    const auto commands = MastTo(world, -a, a);
    for (int i = 0; i < 9000; ++i) world.Step(commands);
    const Truth truth = world.truth();
    EXPECT_FALSE(truth.on_stone);
    EXPECT_NEAR(truth.p_GF.z(), 0.45, 0.02);
    EXPECT_EQ(truth.face_n > 0.0, touches);
    if (touches) {
      // The mast bends by 500 N/m, the body and its wheels a little.
      EXPECT_TRUE(truth.closed[0] || truth.closed[1] || truth.closed[2]);
      EXPECT_NEAR(truth.face_n, 5.0, 2.0);
      EXPECT_LT(truth.most_face_n, 10.0);
    }
  }
}

// The boulder bears: its wheels turn, but the rover comes no nearer.
TEST(Rocky7World, BoulderStopsTheWheelThatMeetsIt) {
  World world(BeforeBoulder(0.75));
  const auto commands = Ahead(world, 0.7);
  for (int i = 0; i < 9000; ++i) world.Step(commands);
  const double there_m = world.truth().X_GR.x;
  for (int i = 0; i < 4000; ++i) world.Step(commands);
  EXPECT_GT(there_m, 0.4);
  EXPECT_NEAR(world.truth().X_GR.x, there_m, 0.002);
  EXPECT_FALSE(world.truth().on_stone);
}

}  // namespace
}  // namespace dockyard::rocky7
