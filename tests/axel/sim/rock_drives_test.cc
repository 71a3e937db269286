// The rover in a world with soil and rocks: how it starts on one, drives over it, and that the
// outcome depends neither on the step nor on the side.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "axel/sim/product.h"
#include "axel/sim/rock_block.h"
#include "sim/rigid/rocks.h"

namespace dockyard::axel {
namespace {

constexpr double kG = 9.81;

/// A rover whose left wheel starts on an 8 cm rock, or drives over it from 0.5 m before.
WorldSetup WithRock(double ahead_m, double height_m = 0.08, double side = 1.0) {
  WorldSetup setup = TestSetup(CompactGravel(), {3.5, 0.0, kPi});
  setup.slack_start_m = 0.05;
  // The rover heads to -x, so that its left is at -y.
  setup.rocks.rocks = {Pose3::Translation(3.5 - ahead_m, -0.425 * side, 0.0) *
                       RockShape({0.25, height_m}, 0.3, 0.0, 5)};
  return setup;
}

/// Of the axle against the level, left side up. The body's roll is larger where it is pitched.
double AxleTilt(const Truth& truth) { return std::asin(truth.X_WR.R(2, 1)); }

TEST(Rocks, AWheelThatStartsOnOneRollsTheRoverByItsHeight) {
  for (const double height_m : {0.04, 0.08}) {
    World world(WithRock(0.0, height_m));
    const Truth truth = world.truth();
    // Against level ground: the other wheel sinks by some millimetres, and a paddle's tip may
    // stand where its neighbours' chord does not.
    const double sag_m = 0.3 * (1.0 - std::cos(kPi / 12.0));
    const double roll = AxleTilt(truth), expected = std::asin(height_m / 0.85);
    std::printf("on a rock of %.0f mm: roll %.2f deg, by geometry %.2f deg\n", 1e3 * height_m,
                Degrees(roll), Degrees(expected));
    EXPECT_NEAR(roll, expected, (sag_m + 0.004) / 0.85);
    // It stands: the rock carries that wheel.
    EXPECT_GT(truth.rock_force_n, 0.35 * Axel().mass_kg() * kG);
    EXPECT_LT(truth.left_wheel_load_n, 5.0);
    EXPECT_GT(truth.right_wheel_load_n, 0.35 * Axel().mass_kg() * kG);
    // A wheel rolls off a paddle's tip by half a pitch at most. On a rock putting the rover down
    // twice does not undo it: moved aside, the wheel stands on another place of the rock.
    EXPECT_NEAR(truth.X_DR.p.x(), 3.5, 0.3 * kPi / 12.0);
  }
}

TEST(Rocks, ASmoothWheelThatStartsOnOneRollsTheRoverExactly) {
  WorldSetup setup = WithRock(0.0);
  setup.rocks.rocks = {Block({3.0, -0.6}, {4.0, -0.3}, 0.08)};
  for (WheelModel* wheel : {&setup.rover.left_wheel_soil, &setup.rover.right_wheel_soil}) {
    *wheel = {.rim_radius_m = 0.3, .width_m = 0.15};
  }
  const Truth truth = World(setup).truth();
  // The left wheel stands on a level top, the right one in its rut.
  const double roll = AxleTilt(truth);
  const double expected = std::asin((0.08 + truth.right_sinkage_m) / 0.85);
  std::printf("smooth: roll %.3f deg, by geometry %.3f deg\n", Degrees(roll), Degrees(expected));
  EXPECT_NEAR(roll, expected, Radians(0.2));
}

TEST(Rocks, ShareTheWeightWithTheSoil) {
  World world(WithRock(0.0));
  const Truth truth = world.truth();
  const double weight = Axel().mass_kg() * kG;
  // What is missing stands on the arm's tip; its friction and the wheels' act along the ground.
  const double carried = truth.rock_force_n + truth.left_wheel_load_n + truth.right_wheel_load_n +
                         truth.tip_ground_force_n;
  std::printf("rock %.1f, soil %.1f and %.1f, tip %.1f: %.1f of %.1f N\n", truth.rock_force_n,
              truth.left_wheel_load_n, truth.right_wheel_load_n, truth.tip_ground_force_n, carried,
              weight);
  EXPECT_NEAR(carried, weight, 0.02 * weight);
}

Truth DriveOver(double step_s, double seconds, const WorldSetup& with = WithRock(0.45)) {
  WorldSetup setup = with;
  setup.step_s = step_s;
  World world(setup);
  Play(world, Drive(0.17, 0.0), seconds, step_s);
  return world.truth();
}

TEST(Rocks, AWheelClimbsOneOfEightCentimetresAndRollsOverItsTop) {
  World world(WithRock(0.45));
  double highest_m = 0.0;
  for (int i = 0; i < 250; ++i) {
    Play(world, Drive(0.17, 0.0), 0.1);
    highest_m = std::max(highest_m, world.truth().X_W_left_wheel.p.z());
  }
  const Truth truth = world.truth();
  std::printf("left wheel up to %.3f m, now at x %.2f m, largest force %.0f N\n", highest_m,
              truth.X_DR.p.x(), truth.rock_force_peak_n);
  EXPECT_NEAR(highest_m, 0.08 + 0.30, 5e-3);  // on a paddle's tip
  EXPECT_EQ(truth.rock_force_n, 0.0);
  EXPECT_NEAR(truth.X_W_left_wheel.p.z(), truth.X_W_right_wheel.p.z(), 0.015);
}

TEST(Rocks, TheWayOverOneIsTheSameAtEachStep) {
  const Truth coarse = DriveOver(2e-3, 12.0), middle = DriveOver(1e-3, 12.0),
              fine = DriveOver(0.5e-3, 12.0);
  for (const Truth* t : {&coarse, &middle, &fine}) {
    std::printf("x %.5f y %.5f m, heading %.3f deg, roll %.3f deg, peak %.1f N\n", t->X_DR.p.x(),
                t->X_DR.p.y(), Degrees(ToGround(t->X_DR).heading),
                Degrees(ToRollPitchYaw(t->X_WR.R).roll), t->rock_force_peak_n);
  }
  for (const Truth* t : {&coarse, &middle}) {
    EXPECT_NEAR(t->X_DR.p.x(), fine.X_DR.p.x(), 2e-3);
    EXPECT_NEAR(t->X_DR.p.y(), fine.X_DR.p.y(), 2e-3);
    EXPECT_NEAR(ToGround(t->X_DR).heading, ToGround(fine.X_DR).heading, Radians(0.3));
    EXPECT_NEAR(t->rock_force_peak_n, fine.rock_force_peak_n, 0.02 * fine.rock_force_peak_n);
  }
}

TEST(Rocks, SameCallsGiveTheSameBits) {
  const WorldSetup setup = WithRock(0.45);
  World a(setup), b(setup);
  Play(a, Drive(0.17, 0.0), 10.0);
  Play(b, Drive(0.17, 0.0), 10.0);
  EXPECT_GT(a.truth().rock_force_peak_n, 50.0);
  EXPECT_EQ(a.StateHash(1), b.StateHash(1));
}

TEST(Rocks, MirroredOnesMirrorTheMotion) {
  WorldSetup setup = WithRock(0.45);
  setup.rover.left_wheel_soil.phase_rad = 0.1;
  setup.rover.right_wheel_soil.phase_rad = 0.23;
  WorldSetup mirrored = setup;
  std::swap(mirrored.rover.left_wheel_soil.phase_rad, mirrored.rover.right_wheel_soil.phase_rad);
  mirrored.add_right_side_first = true;
  for (Eigen::Vector3d& p : mirrored.rocks.rocks[0].vertices) p.y() = -p.y();
  mirrored.rocks.rocks[0] = HullOf(mirrored.rocks.rocks[0].vertices);
  World a(setup), b(mirrored);
  double apart_m = 0.0;
  for (int i = 0; i < 12; ++i) {
    Play(a, Drive(0.17, 0.0), 1.0);
    Play(b, Drive(0.17, 0.0), 1.0);
    const Truth left = a.truth(), right = b.truth();
    apart_m = std::max(apart_m, std::abs(left.X_DR.p.y() + right.X_DR.p.y()));
    EXPECT_NEAR(left.X_DR.p.x(), right.X_DR.p.x(), 1e-4) << i;
    EXPECT_NEAR(left.X_DR.p.y(), -right.X_DR.p.y(), 1e-4) << i;
    EXPECT_NEAR(ToRollPitchYaw(left.X_WR.R).roll, -ToRollPitchYaw(right.X_WR.R).roll, 1e-4) << i;
  }
  std::printf("mirrored: %.1e m apart\n", apart_m);
  EXPECT_GT(a.truth().rock_force_peak_n, 50.0);
}

TEST(Rocks, CarryTheArmsTip) {
  WorldSetup setup = TestSetup(CompactGravel(), {3.5, 0.0, kPi});
  setup.rocks.rocks = {Block({3.5 - 1.1, -0.2}, {3.5 - 0.8, 0.2}, 0.15)};
  World world(setup);
  Play(world, AllBraked(), 1.0);
  const Truth truth = world.truth();
  EXPECT_EQ(truth.tip_ground_force_n, 0.0);
  // The net nose-down moment of 10.2 N m about the axle (axel.urdf) over the metre to the tip, less
  // what the braked wheels hold on the soil.
  EXPECT_GT(truth.rock_force_n, 5.0);
  EXPECT_LT(truth.rock_force_n, 10.2);
  const Eigen::Vector3d tip_W = truth.X_WA * Eigen::Vector3d(setup.rover.arm_length_m, 0.0, 0.0);
  EXPECT_NEAR(tip_W.z(), 0.15 + setup.rover.tip.radius_m, 0.01);
}

TEST(Rocks, FarAwayChangeNothing) {
  WorldSetup setup = TestSetup(CompactGravel(), {3.5, 0.0, kPi}), with = setup;
  with.rocks.rocks = {Pose3::Translation(6.0, 2.0, 0.0) * RockShape({0.25, 0.1}, 0.3, 0.0, 5)};
  World a(setup), b(with);
  Play(a, Drive(0.17, 0.0), 3.0);
  Play(b, Drive(0.17, 0.0), 3.0);
  EXPECT_EQ(a.StateHash(1), b.StateHash(1));
}

}  // namespace
}  // namespace dockyard::axel
