// The tether as a cable with mass, in the rover's world.
#include <gtest/gtest.h>

#include <cmath>

#include "axel/sim/product.h"
#include "sim/axel/cable_tether.h"

namespace dockyard::axel {
namespace {

WorldSetup SetupWith(TetherLaw law, const Pose2& X_DR, double slack_m = 0.05) {
  WorldSetup setup = TestSetup(CompactGravel(), X_DR);
  setup.rover.tether.law = law;
  setup.slack_start_m = slack_m;
  return setup;
}

struct Docked {
  double depth_m = 0.0, aside_m = 0.0, time_s = 0.0, tension_n = 0.0;
};
Docked ReelIn(TetherLaw law, double mass_kg_per_m, double step_s = 1e-3) {
  WorldSetup setup = SetupWith(law, {1.5, 0.10, kPi + Radians(10.0)});
  setup.rover.tether.mass_kg_per_m = mass_kg_per_m;
  setup.step_s = step_s;
  World world(setup);
  Docked docked;
  for (double t = 0.0; t < 25.0; t += 0.02) {
    Play(world, Reel(200.0), 0.02, step_s);
    const Truth truth = world.truth();
    if (docked.time_s == 0.0 && truth.p_MT.x() < -0.2) docked.time_s = t;
    docked.depth_m = -truth.p_MT.x();
    docked.aside_m = std::hypot(truth.p_MT.y(), truth.p_MT.z());
    docked.tension_n = truth.tether_tension_n;
  }
  return docked;
}

TEST(CableTether, DocksTheRoverAsTheMasslessTetherDoes) {
  const Docked massless = ReelIn(TetherLaw::kMassless, 0.05);
  const Docked light = ReelIn(TetherLaw::kCable, 0.002), cord = ReelIn(TetherLaw::kCable, 0.05);
  ASSERT_GT(massless.depth_m, Station().cone.stop_depth_m - 1e-3);
  for (const Docked& cable : {light, cord}) {
    EXPECT_NEAR(cable.depth_m, massless.depth_m, 1e-3);
    EXPECT_NEAR(cable.aside_m, massless.aside_m, 1e-3);
    EXPECT_NEAR(cable.time_s, massless.time_s, 0.05 * massless.time_s + 0.02);
    EXPECT_NEAR(cable.tension_n, massless.tension_n, 0.02 * massless.tension_n);
  }
}

TEST(CableTether, DocksTheRoverAlikeAtEveryStep) {
  const Docked coarse = ReelIn(TetherLaw::kCable, 0.05, 2e-3);
  const Docked fine = ReelIn(TetherLaw::kCable, 0.05, 0.5e-3);
  const Docked middle = ReelIn(TetherLaw::kCable, 0.05);
  for (const Docked& other : {coarse, middle}) {
    EXPECT_NEAR(other.depth_m, fine.depth_m, 1e-3);
    EXPECT_NEAR(other.time_s, fine.time_s, 0.05 * fine.time_s + 0.02);
  }
}

TEST(CableTether, PullsAlikeOnAStandingRoverAsItsWeightVanishes) {
  // Drawn tight by the spool on braked wheels, 4 m from the mouth and to its side.
  const auto Pull = [](TetherLaw law, double mass_kg_per_m) {
    WorldSetup setup = SetupWith(law, {4.0, 1.0, kPi - 0.3});
    setup.rover.tether.mass_kg_per_m = mass_kg_per_m;
    World world(setup);
    MotorCommands commands = AllBraked();
    At(commands, Motor::kSpool) = Velocity(0.8, SpoolCurrent(60.0));
    Play(world, commands, 6.0);
    return world.truth();
  };
  const Truth massless = Pull(TetherLaw::kMassless, 0.05);
  const Truth light = Pull(TetherLaw::kCable, 0.002), cord = Pull(TetherLaw::kCable, 0.05);
  EXPECT_NEAR(light.tether_tension_n, massless.tether_tension_n, 0.01 * massless.tether_tension_n);
  EXPECT_NEAR(light.tether_path_m, massless.tether_path_m, 1e-3);
  // The cord's sag, w^2 L^3 / 24 T^2, is in its way.
  const double w = 0.05 * 9.81, L = 3.2, T = cord.tether_tension_n;
  EXPECT_NEAR(cord.tether_path_m - massless.tether_path_m, w * w * L * L * L / (24.0 * T * T),
              2e-3);
}

TEST(CableTether, LiesOnTheGroundWhenSlackAndComesToRest) {
  World world(SetupWith(TetherLaw::kCable, {4.0, 0.0, kPi}, 0.5));
  Play(world, AllBraked(), 3.0);
  const Truth truth = world.truth();
  int lying = 0;
  for (const Eigen::Vector3d& p : truth.tether_W) {
    EXPECT_GT(p.z(), 0.5 * 0.006 - 1e-4);
    if (p.z() < 0.004) ++lying;
  }
  EXPECT_GT(lying, 20);
  // What hangs at the mouth pulls along the ground until friction holds it: at the tip nothing.
  EXPECT_LT(truth.tether_tension_n, 0.2);
  Play(world, AllBraked(), 25.0);
  EXPECT_TRUE(world.at_rest());
}

TEST(CableTether, StaysOutsideOfTheWheelsOfARoverThatFacesAway) {
  WorldSetup setup = SetupWith(TetherLaw::kCable, {3.9, 1.0, Radians(-5.0)});
  World world(setup);
  const Pose2 before = ToGround(world.truth().X_DR);
  MotorCommands commands = Reel(150.0);
  At(commands, Motor::kArm) = Position(0.27, 0.3, 2.2);
  for (int i = 0; i < 600; ++i) {
    Play(world, commands, 0.02);
    const Truth truth = world.truth();
    ASSERT_LT(truth.tether_tension_n, 400.0) << i;
    for (const Pose3& X_WK : {truth.X_W_left_wheel, truth.X_W_right_wheel}) {
      for (const Eigen::Vector3d& p_W : truth.tether_W) {
        const Eigen::Vector3d p_K = Inverse(X_WK) * p_W;
        // The prism over the paddles' tips is 3.4 % narrower than its corners.
        const double radius = std::hypot(p_K.x(), p_K.z());
        const bool inside = radius < 0.93 * 0.30 && std::abs(p_K.y()) < 0.5 * 0.15 - 0.01;
        ASSERT_FALSE(inside) << i << " " << p_K.transpose();
      }
    }
  }
  // Pulled below its body and past a wheel, it turns.
  EXPECT_LT(ToGround(world.truth().X_DR).heading, before.heading - Radians(20.0));
}

TEST(CableTether, GivesRoverAndStationTheForcesThatItsOwnMomentumMisses) {
  // Before a rover that faces away: the tether lies along body, ground and lip.
  RoverModel model = Axel();
  model.tether.law = TetherLaw::kCable;
  RigidWorld rigid(Eigen::Vector3d::Zero());
  RoverBody rover(rigid, model, Pose3::Translation(3.0, 0.3, 0.284), 0.2, false);
  StationBody station(rigid, Station(), Pose3{});
  const HeightGrid ground = LevelGrid(-3.0, 12.0, 8.0, 0.05);
  const Eigen::Vector3d gravity(0.0, 0.0, -9.81);
  CableTether tether(model, Station(), {});
  double free = tether.TieUp(rover, station, ground, gravity, 0.05);
  int counted = 0;
  for (int i = 0; i < 400; ++i) {
    if (i < 200) free -= 5e-4;
    const Eigen::Vector3d before = tether.momentum_G();
    const int masses = tether.masses();
    tether.Step(ground, gravity, free, 0.0, 1e-3, rover, station);
    if (i < 201 || tether.masses() != masses) continue;  // one was drawn in
    ++counted;
    const Eigen::Vector3d gained = (tether.momentum_G() - before) / 1e-3;
    const Eigen::Vector3d on_cable = free * model.tether.mass_kg_per_m * gravity -
                                     tether.force_given_G() + tether.force_of_ground_G() +
                                     tether.force_of_air_G();
    ASSERT_LT((gained - on_cable).norm(), 1e-6) << i;
  }
  EXPECT_GT(counted, 150);
}

TEST(CableTether, LiesOverARockInItsWayWhateverTheFriction) {
  // A block of 0.8 m between rover and station, higher than the mouth, beside the straight way.
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {1.2, 1.7}) {
    for (const double y : {-0.1, 0.7}) {
      for (const double z : {-0.1, 0.7}) corners.emplace_back(x, y, z);
    }
  }
  const auto Pull = [&](double friction) {
    WorldSetup setup = SetupWith(TetherLaw::kCable, {4.0, 0.3, kPi});
    setup.rover.tether.friction_on_rock = friction;
    setup.rocks.rocks.push_back(HullOf(corners));
    World world(setup);
    MotorCommands commands = AllBraked();
    At(commands, Motor::kSpool) = Velocity(0.8, SpoolCurrent(40.0));
    Play(world, commands, 8.0);
    for (const Eigen::Vector3d& p : world.truth().tether_W) {
      EXPECT_GT(DistanceTo(setup.rocks.rocks[0], p).distance_m, -1e-3);
    }
    return world.truth();
  };
  const Truth slips = Pull(0.0), held = Pull(0.6);
  for (const Truth& truth : {slips, held}) {
    const double straight_m = (truth.tether_W.front() - truth.tether_W.back()).norm();
    EXPECT_GT(truth.tether_path_m, straight_m + 0.03);
    EXPECT_GT(truth.tether_tension_n, 20.0);
  }
}

TEST(CableTether, MovesTheSameToTheBitWhenRepeated) {
  const auto Run = [] {
    World world(SetupWith(TetherLaw::kCable, {3.0, 0.5, kPi - 0.4}));
    Play(world, Drive(0.15, 40.0), 3.0);
    return world.StateHash(1);
  };
  EXPECT_EQ(Run(), Run());
}

}  // namespace
}  // namespace dockyard::axel
