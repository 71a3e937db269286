#include "sim/axel/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "axel/sim/product.h"

namespace dockyard::axel {
namespace {

/// Arm's elevation, tip up positive, beyond 90 deg when it has gone over the top.
double ArmUp(const Truth& truth) {
  const Eigen::Vector3d tip_D = truth.X_DR.R * RotY(truth.arm_rad).col(0);
  return std::atan2(tip_D.z(), -tip_D.x());
}

TEST(World, BrakedRoverAndStationStayWhereTheyAre) {
  WorldSetup setup = TestSetup(LooseSand(), {2.5, 0.3, 3.0});
  setup.slack_start_m = 0.1;
  World world(setup);
  const Truth before = world.truth();
  Play(world, AllBraked(), 5.0);
  const Truth after = world.truth();
  // The rover rocks on the soil by some tenths of a millimetre; the station has nothing to move it.
  EXPECT_LT((after.X_WR.p - before.X_WR.p).norm(), 2e-3);
  EXPECT_LT((after.X_WS.p - before.X_WS.p).norm(), 1e-7);
}

TEST(World, BrakedRoverThatWasPushedComesToRest) {
  for (const SoilModel& soil : {LooseSand(), CompactGravel()}) {
    WorldSetup setup = TestSetup(soil, {3.5, 0.0, kPi});
    setup.slack_start_m = 0.3;
    World world(setup);
    MotorCommands push = AllBraked();
    At(push, Motor::kLeftWheel) = At(push, Motor::kRightWheel) = Velocity(0.05, 2.8);
    Play(world, push, 0.2);
    EXPECT_GT(world.truth().v_MT.norm(), 5e-3) << soil.name;
    Play(world, AllBraked(), 5.0);
    const Truth rest = world.truth();
    EXPECT_LT(rest.v_WR_W.norm(), 1e-4) << soil.name;
    EXPECT_LT(rest.v_MT.norm(), 1e-3) << soil.name;
    Play(world, AllBraked(), 5.0);
    EXPECT_LT((world.truth().X_WR.p - rest.X_WR.p).norm(), 2e-4) << soil.name;
  }
}

TEST(World, StartsWhereItIsTold) {
  const Truth truth = World(TestSetup(CompactGravel(), {3.0, 0.4, 2.9})).truth();
  EXPECT_NEAR(truth.X_DR.p.x(), 3.0, 0.01);
  EXPECT_NEAR(truth.X_DR.p.y(), 0.4, 0.01);
  EXPECT_NEAR(ToGround(truth.X_DR).heading, 2.9, 0.005);
  EXPECT_EQ(truth.time_s, 0.0);
  for (double angle : truth.motor_angle_rad) EXPECT_EQ(angle, 0.0);
}

TEST(World, SlackIsTheLengthBeyondTheWay) {
  WorldSetup setup = TestSetup(LooseSand(), {3.0, 0.0, kPi});
  setup.slack_start_m = 0.2;
  World world(setup);
  world.Step(AllBraked());
  const Truth truth = world.truth();
  EXPECT_NEAR(truth.tether_free_m - truth.tether_path_m, 0.2, 1e-5);
  EXPECT_EQ(truth.tether_tension_n, 0.0);
}

TEST(World, SameCallsGiveTheSameBits) {
  const WorldSetup setup = TestSetup(CompactGravel(), {1.3, 0.1, 3.1});
  World a(setup), b(setup);
  Play(a, Reel(200.0), 6.0);  // into the cone
  Play(b, Reel(200.0), 6.0);
  EXPECT_GT(a.truth().cone_force_n + a.truth().tether_tension_n, 0.0);
  EXPECT_EQ(a.StateHash(1), b.StateHash(1));
}

TEST(World, HashTellsStatesApart) {
  World world(TestSetup(LooseSand(), {2.5, 0.0, kPi}));
  const std::uint64_t before = world.StateHash(1);
  world.Step(AllBraked());
  EXPECT_NE(world.StateHash(1), before);
}

TEST(World, MovesTheSameWhereverItLies) {
  WorldSetup setup = TestSetup(LooseSand(), {2.5, 0.2, 3.0});
  World here(setup);
  setup.X_WG = {120.0, -35.0, 2.1};
  World there(setup);
  Play(here, Drive(0.2, 45.0), 2.0);
  Play(there, Drive(0.2, 45.0), 2.0);
  const Pose3 moved = FromGround(setup.X_WG, 0.0) * here.truth().X_WR;
  EXPECT_LT((moved.p - there.truth().X_WR.p).norm(), 1e-6);
  EXPECT_LT((moved.R - there.truth().X_WR.R).norm(), 1e-6);
  EXPECT_LT((here.truth().X_DR.p - there.truth().X_DR.p).norm(), 1e-6);
}

TEST(World, DockElsewhereInTheYardMovesTheSame) {
  WorldSetup setup = TestSetup(LooseSand(), {2.5, 0.2, 3.0});
  World here(setup);
  setup.X_GD = {2.0, 0.0, 0.0};  // a whole number of cells
  World there(setup);
  Play(here, Drive(0.2, 45.0), 2.0);
  Play(there, Drive(0.2, 45.0), 2.0);
  EXPECT_LT((here.truth().X_DR.p - there.truth().X_DR.p).norm(), 1e-6);
}

TEST(World, MirroredCommandsMirrorTheMotion) {
  WorldSetup setup = TestSetup(CompactGravel(), {3.0, 0.4, 3.0});
  setup.rover.left_wheel_soil.phase_rad = 0.1;
  setup.rover.right_wheel_soil.phase_rad = 0.23;
  WorldSetup mirrored = setup;
  mirrored.X_DR_start = {3.0, -0.4, -3.0};
  std::swap(mirrored.rover.left_wheel_soil.phase_rad, mirrored.rover.right_wheel_soil.phase_rad);
  mirrored.add_right_side_first = true;
  World a(setup), b(mirrored);
  MotorCommands commands = Drive(0.2, 45.0), swapped = commands;
  At(commands, Motor::kLeftWheel) = Velocity(0.12, 2.8);
  At(swapped, Motor::kRightWheel) = Velocity(0.12, 2.8);
  for (int i = 0; i < 6; ++i) {
    Play(a, commands, 1.0);
    Play(b, swapped, 1.0);
    const Truth left = a.truth(), right = b.truth();
    EXPECT_NEAR(left.X_DR.p.x(), right.X_DR.p.x(), 1e-9);
    EXPECT_NEAR(left.X_DR.p.y(), -right.X_DR.p.y(), 1e-9);
    EXPECT_NEAR(left.X_DR.p.z(), right.X_DR.p.z(), 1e-9);
    EXPECT_NEAR(left.motor_angle_rad[0], right.motor_angle_rad[1], 1e-9);
    EXPECT_NEAR(left.tether_tension_n, right.tether_tension_n, 1e-5);
    EXPECT_NEAR(ToRollPitchYaw(left.X_WR.R).roll, -ToRollPitchYaw(right.X_WR.R).roll, 1e-9);
  }
  EXPECT_GT(std::abs(a.truth().X_DR.p.y() - 0.4), 0.01);
}

TEST(World, RoverRollsOverItsPaddlesTipsOnFirmGround) {
  World world(TestSetup(CompactGravel(), {4.0, 0.0, kPi}));
  const MotorCommands commands = Drive(-0.2, 5.0);  // away, paying out
  Play(world, commands, 3.0);                       // until the arm lies on the ground
  const Truth start = world.truth();
  Play(world, commands, 9.0);
  const Truth truth = world.truth();
  // Twelve tips on 0.30 m: a polygon's way per turn; wheels turn as their motors and the body do.
  const double radius = 0.30 * 12.0 / kPi * std::sin(kPi / 12.0);
  const double turned = truth.motor_angle_rad[0] - start.motor_angle_rad[0] +
                        ToRollPitchYaw(truth.X_DR.R).pitch - ToRollPitchYaw(start.X_DR.R).pitch;
  const double way = truth.X_DR.p.x() - start.X_DR.p.x();
  EXPECT_GT(way, 0.4);
  // It slips by up to a tenth, as its arm drags and the spool holds back 5 to 30 N.
  EXPECT_NEAR(way, -radius * turned, 0.10 * way);
  EXPECT_LT(way, -radius * turned);
  EXPECT_NEAR(truth.X_DR.p.y(), 0.0, 0.02);
}

// Tsai et al., V-F: "a loose tether results in changing the rover's pitch without making forward
// progress". The wheels turn the body about the axle until it weighs as much as they need.
TEST(World, SlackTetherLetsTheBodyPitchInsteadOfAdvancing) {
  for (const SoilModel& soil : {LooseSand(), CompactGravel()}) {
    WorldSetup setup = TestSetup(soil, {4.0, 0.0, kPi});
    setup.slack_start_m = 2.0;
    World world(setup);
    const double start = Degrees(ArmUp(world.truth()));
    double pitched = 0.0;  // before it has gone 2 cm
    for (int i = 0; i < 80 && 4.0 - world.truth().X_DR.p.x() < 0.02; ++i) {
      Play(world, Drive(0.05 / 0.3, 0.0), 0.1);
      pitched = Degrees(ArmUp(world.truth())) - start;
    }
    // Rolling takes more than the 10 N m with which body and arm weigh the tip down.
    EXPECT_GT(pitched, 60.0) << soil.name;
  }
}

TEST(World, TautTetherHoldsTheArmAndTheRoverAdvances) {
  World world(TestSetup(LooseSand(), {4.0, 0.0, kPi}));
  double highest = 0.0;
  for (int i = 0; i < 8; ++i) {
    Play(world, Drive(0.05 / 0.3, 60.0), 1.0);
    highest = std::max(highest, Degrees(ArmUp(world.truth())));
  }
  EXPECT_LT(highest, 20.0);
  EXPECT_GT(4.0 - world.truth().X_DR.p.x(), 0.25);
}

TEST(World, FreeWheelsAndSpoolDockAStraightRover) {
  World world(TestSetup(LooseSand(), {1.4, 0.0, kPi}));
  Play(world, Reel(290.0), 15.0);
  const Truth truth = world.truth();
  EXPECT_LT(truth.p_MT.x(), -0.2);
  EXPECT_LT(std::hypot(truth.p_MT.y(), truth.p_MT.z()), 5e-3);  // socket's clearance 2.5 mm
  EXPECT_LT(truth.station_shift_m, 5e-3);
}

TEST(World, SpoolsWorkIsTheTethersAndWhatItsGearsLose) {
  // Reeling over sand from rest to rest of the drum: motor = tension x tether + Coulomb friction +
  // the quarter that the loaded teeth take.
  World world(TestSetup(LooseSand(), {3.0, 0.0, kPi}));
  const RoverModel rover = Axel();
  double motor = 0.0, tether = 0.0, turned = 0.0;
  const auto Account = [&](const MotorCommands& commands, double seconds) {
    Truth before = world.truth();
    for (long i = 0; i < std::lround(seconds * 1e3); ++i) {
      world.Step(commands);
      const Truth after = world.truth();
      const double turn = after.motor_angle_rad[3] - before.motor_angle_rad[3];
      motor += after.motor_torque_nm[3] * turn;
      tether += after.tether_tension_n * rover.tether.drum_radius_m * turn;
      turned += std::abs(turn);
      before = after;
    }
  };
  MotorCommands stop = Reel(200.0);
  At(stop, Motor::kSpool) = Velocity(0.0, 2.0);
  Account(Reel(200.0), 8.0);
  Account(stop, 1.0);
  const double lost = rover.motors[3].gear_friction_nm * turned + 0.25 * motor;
  EXPECT_GT(motor, 20.0);
  EXPECT_NEAR(motor, tether + lost, 1e-3 * motor);
}

TEST(World, SocketFloorSeatsTheTipWhereTheModelHasIt) {
  WorldSetup setup = TestSetup(LooseSand(), {1.15, 0.0, kPi});
  setup.station.cone.stop_depth_m = 0.22;
  World world(setup);
  Play(world, Reel(200.0), 9.0);
  const Truth truth = world.truth();
  // Pressed in by the pull less what the wheels hold back: below 200 N at 2e5 N/m, 1 mm.
  EXPECT_NEAR(-truth.p_MT.x(), 0.22, 1e-3 + 1e-3 * 0.5);
  EXPECT_GT(truth.tether_tension_n, 100.0);
  EXPECT_GT(truth.cone_force_n, 20.0);
}

TEST(World, TipThatArrivesTooLowIsCaughtOnTheFlatFace) {
  WorldSetup setup = TestSetup(LooseSand(), {1.1, 0.0, kPi});
  setup.station.tip_angle_rad = 0.0;
  setup.station.mouth_height_m = 0.48;
  setup.station.cone.mouth_radius_m = 0.10;
  setup.station.cone.funnel_length_m = 0.15;
  World world(setup);
  Play(world, Reel(290.0), 6.0);
  const Truth truth = world.truth();
  EXPECT_GT(truth.face_force_n, 50.0);
  EXPECT_GT(truth.p_MT.x(), -0.01);
  EXPECT_NEAR(truth.face_force_n, truth.cone_force_n, 1e-9);
}

struct Blow {
  double held_n = 0.0;  // largest mean over 10 ms
  double peak_n = 0.0;
  double speed_m_s = 0.0;  // of the tip, before it touches
};
Blow BlowInTheFunnel(double step_s) {
  // The spool draws the tip onto the funnel's upper half and along it.
  WorldSetup setup = TestSetup(LooseSand(), {1.1, 0.0, kPi});
  setup.station.tip_angle_rad = 0.0;
  setup.station.mouth_height_m = 0.48;
  setup.step_s = step_s;
  World world(setup);
  Blow blow;
  double sum = 0.0;
  const int window = static_cast<int>(std::lround(10e-3 / step_s));
  for (int i = 0; i < std::lround(8.0 / step_s); ++i) {
    const double speed = world.truth().v_MT.norm();
    world.Step(Reel(290.0));
    const double force = world.truth().cone_force_n;
    if (blow.peak_n == 0.0) blow.speed_m_s = speed;
    blow.peak_n = std::max(blow.peak_n, force);
    sum += force / window;
    if ((i + 1) % window != 0) continue;
    blow.held_n = std::max(blow.held_n, sum);
    sum = 0.0;
  }
  std::printf("funnel, %.1f ms: touches at %.3f m/s, peak %.1f N, over 10 ms %.1f N\n",
              1e3 * step_s, blow.speed_m_s, blow.peak_n, blow.held_n);
  return blow;
}

TEST(World, ForceInTheFunnelDoesNotDependOnTheStep) {
  const Blow coarse = BlowInTheFunnel(2e-3), middle = BlowInTheFunnel(1e-3),
             fine = BlowInTheFunnel(0.5e-3);
  EXPECT_GT(fine.held_n, 25.0);
  EXPECT_NEAR(middle.held_n, fine.held_n, 0.03 * fine.held_n);
  EXPECT_NEAR(coarse.held_n, fine.held_n, 0.03 * fine.held_n);
  // The first touch is the damper's: c v within one step, gone after 2 ms. A step of 1 ms shows the
  // half of it, and no step more than all, the spring's part beside it.
  const double touch = Station().cone.contact_damping_ns_per_m * fine.speed_m_s;
  for (const Blow& blow : {coarse, middle, fine}) EXPECT_LT(blow.peak_n, touch + fine.held_n);
}

TEST(World, LightSlipperyStationIsTowed) {
  WorldSetup setup = TestSetup(LooseSand(), {2.0, 0.0, kPi});
  setup.station.module.mass_kg = 15.0;
  setup.station.foot_friction = 0.2;
  World world(setup);
  Play(world, Reel(290.0), 4.0);
  EXPECT_GT(world.truth().station_shift_m, 0.05);
}

TEST(World, RefusesATetherShorterThanItsWay) {
  WorldSetup setup = TestSetup(LooseSand(), {2.0, 0.0, kPi});
  setup.slack_start_m = -0.1;
  EXPECT_DEATH(World{setup}, "check failed");
}

}  // namespace
}  // namespace dockyard::axel
