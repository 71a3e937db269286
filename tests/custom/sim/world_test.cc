// A robot and a dock by files against closed forms.
#include "sim/custom/world.h"

#include <gtest/gtest.h>

#include <cmath>

#include "custom/charger_rig.h"
#include "models/parts/gravity.h"
#include "sim/vehicles/spring_pins.h"

namespace dockyard::custom {
namespace {

std::vector<MotorCommand> Braked(const WorldSetup& setup) {
  return std::vector<MotorCommand>(setup.robot.motors.size());
}

TEST(CustomWorld, RobotDrivesAsFarAsItsWheelsRoll) {
  const WorldSetup setup =
      ChargerWorld({"start.r_m=2.5", "start.alpha_deg=0", "start.heading_deg=180"});
  World world(setup);
  const std::vector<MotorCommand> commands = DriveAt(setup, 0.2, 0.2);
  RunFor(world, 1.0, commands);
  const Truth before = world.truth();
  RunFor(world, 4.0, commands);
  const Truth after = world.truth();
  const double turned = after.motors[0].angle_rad - before.motors[0].angle_rad;
  EXPECT_NEAR((after.X_DR.p - before.X_DR.p).norm(), turned * 0.035, 1e-3 * turned * 0.035);
  EXPECT_NEAR(after.X_DR.p.y(), before.X_DR.p.y(), 1e-6);
}

// Both wheels on a circle about the same point.
TEST(CustomWorld, RobotTurnsAboutThePointThatItsWheelSpeedsGive) {
  const WorldSetup setup = ChargerWorld({"start.r_m=2.0"});
  World world(setup);
  const double left = 0.10, right = 0.20, base_m = 0.23;
  const std::vector<MotorCommand> commands = DriveAt(setup, left, right);
  RunFor(world, 2.0, commands);
  const Truth before = world.truth();
  const double rate = (right - left) / base_m;
  RunFor(world, 2.0, commands);
  const Truth after = world.truth();
  const double turned = WrapPi(ToGround(after.X_DR).heading - ToGround(before.X_DR).heading);
  EXPECT_NEAR(turned, 2.0 * rate, 0.02 * 2.0 * rate);
  const double radius_m = 0.5 * (left + right) / rate;
  const double chord_m = (after.X_DR.p - before.X_DR.p).norm();
  EXPECT_NEAR(chord_m, 2.0 * radius_m * std::sin(0.5 * turned), 0.02 * chord_m);
}

TEST(CustomWorld, PinsCloseWhereTheRobotIsDocked) {
  WorldSetup setup = ChargerWorld({"start.r_m=0.30", "start.alpha_deg=0", "start.heading_deg=0"});
  World world(setup);
  EXPECT_FALSE(world.truth().contacts.at(0).closed);
  const std::vector<MotorCommand> commands = DriveAt(setup, 0.05, 0.05);
  for (int i = 0; i < 6000 && world.truth().X_QP.p.x() < 0.0; ++i) world.Step(commands);
  RunFor(world, 1.0, Braked(setup));
  const Truth truth = world.truth();
  EXPECT_TRUE(truth.contacts.at(0).closed);
  EXPECT_NEAR(truth.X_QP.p.x(), 0.0, 2e-3);
  // Two pins on their line of force, at the depth that the frames say.
  const double pressed_m = 0.002 + truth.X_QP.p.x();
  EXPECT_NEAR(truth.contacts.at(0).force_n,
              2.0 * PinForce(setup.dock.electrical.pins[0], pressed_m), 0.1);
  EXPECT_NEAR(truth.contacts.at(0).voltage_v, 19.0 - 2.0 * (0.15 + 2.0 * 0.05), 1e-9);
}

TEST(CustomWorld, PinsStayOpenOffTheirPads) {
  const WorldSetup setup =
      ChargerWorld({"start.r_m=0.30", "start.alpha_deg=0", "start.heading_deg=0",
                    "as_built={dock: {place: {y_m: 0.012}}}"});
  World world(setup);
  const std::vector<MotorCommand> commands = DriveAt(setup, 0.05, 0.05);
  for (int i = 0; i < 6000 && world.truth().X_QP.p.x() < 0.0; ++i) world.Step(commands);
  RunFor(world, 0.5, Braked(setup));
  const Truth truth = world.truth();
  EXPECT_FALSE(truth.contacts.at(0).closed);
  EXPECT_NEAR(truth.contacts.at(0).offset_m, 0.012, 1e-3);
}

// Coulomb: the dock stays below mu m g and slides above.
TEST(CustomWorld, DockIsPushedAcrossTheFloorAboveItsFriction) {
  for (const double share : {0.8, 1.3}) {
    WorldSetup setup =
        ChargerWorld({"start.r_m=2.0", "start.alpha_deg=0", "start.heading_deg=180"});
    World world(setup);
    const double holds_n =
        0.7 * setup.dock.floor_grip * setup.dock.tree.mass_kg() * kEarthGravity_m_s2;
    const Tick until = world.tick() + 500;
    while (world.tick() < until) {
      world.PushDock({-share * holds_n, 0.0, 0.0});
      world.Step(Braked(setup));
    }
    const double moved_m = world.truth().dock_moved_m;
    if (share < 1.0) {
      EXPECT_LT(moved_m, 1e-3);
    } else {
      const double accel = (share - 1.0) * holds_n / setup.dock.tree.mass_kg();
      EXPECT_NEAR(moved_m, 0.5 * accel * 0.25, 0.05 * moved_m);
    }
  }
}

TEST(CustomWorld, FixedDockDoesNotMove) {
  const WorldSetup setup = ChargerWorld({"start.r_m=0.28", "start.alpha_deg=0",
                                         "start.heading_deg=0", "changes={dock: {fixed: true}}"});
  World world(setup);
  RunFor(world, 3.0, DriveAt(setup, 0.05, 0.05));
  EXPECT_EQ(world.truth().dock_moved_m, 0.0);
  EXPECT_GT(world.truth().peak_touch_n, 1.0);
}

TEST(CustomWorld, SameCallsGiveTheSameBits) {
  const WorldSetup setup = ChargerWorld({"start.r_m=0.5"});
  World a(setup), b(setup);
  for (World* world : {&a, &b}) RunFor(*world, 2.0, DriveAt(setup, 0.12, 0.10));
  EXPECT_EQ(a.StateHash(1), b.StateHash(1));
}

}  // namespace
}  // namespace dockyard::custom
