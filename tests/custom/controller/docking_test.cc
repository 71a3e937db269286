#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "custom/controller/kinematic_world.h"
#include "custom/controller/test_robot.h"
#include "sim/base/random.h"

namespace dockyard::custom {
namespace {

/// Errors of a robot and its camera as they are to be expected.
KinematicWorld Real(std::uint64_t seed) {
  KinematicWorld world;
  world.seed = seed;
  RandomStream random(StreamKey(seed, "world"));
  world.left_scale = 1.0 + 0.02 * random.Uniform(-1.0, 1.0);
  world.right_scale = world.left_scale + 0.005 * random.Uniform(-1.0, 1.0);
  world.yaw_rad_per_sqrt_s = 0.0005;
  world.latency_s = 0.12;
  world.dropout = 0.2;
  // Place and heading of the start: r from the docked pose, at an angle to x of D, and turned from
  // the direction to the dock.
  const double r = random.Uniform(0.3, 2.5), alpha = Radians(random.Uniform(-45.0, 45.0));
  const double turned = Radians(random.Uniform(-45.0, 45.0));
  world.X_DR_start = {0.25 + r * std::cos(alpha), r * std::sin(alpha),
                      WrapPi(alpha + kPi + turned)};
  return world;
}

/// The same robot with two wheels on each side.
Nominal SkidSteered() {
  Nominal nominal = NominalOf();
  nominal.wheels.pop_back();
  for (int i = 0; i < 2; ++i) {
    RobotWheel wheel = nominal.wheels[static_cast<std::size_t>(i)];
    wheel.link += " behind";
    wheel.p_RK.x() = -0.2;
    wheel.drive = 2 + i;
    nominal.wheels.push_back(wheel);
    nominal.motors.push_back(nominal.motors[static_cast<std::size_t>(i)]);
  }
  return nominal;
}

struct Counted {
  int docked = 0, falsely = 0;
  double time_s = 0.0;  // in the mean
  std::string failures;
};

using Change = std::function<void(KinematicWorld*)>;

Counted CountDocked(const Nominal& nominal, int seeds, const Change& change = {}) {
  Counted counted;
  for (int seed = 1; seed <= seeds; ++seed) {
    KinematicWorld world = Real(static_cast<std::uint64_t>(seed));
    if (change) change(&world);
    const KinematicRun run = RunKinematic(nominal, world);
    const bool is_there = !nominal.contact.empty()
                              ? run.closed
                              : std::abs(run.along_m) < 0.03 && std::abs(run.aside_m) < 0.02;
    const bool done = run.verdict == Verdict::kDone;
    counted.docked += done && is_there;
    counted.falsely += done && !is_there;
    counted.time_s += run.time_s / seeds;
    if (!done || !is_there)
      counted.failures += std::to_string(seed) + " (" + run.belief.note + ", " +
                          std::to_string(run.along_m) + ", " + std::to_string(run.aside_m) + "); ";
  }
  return counted;
}

TEST(Docking, OfAHundredStartsSucceedsWithACameraAhead) {
  const Counted counted = CountDocked(NominalOf(), 100);
  EXPECT_GE(counted.docked, 98) << counted.failures;
  EXPECT_LT(counted.time_s, 25.0);
  EXPECT_EQ(counted.falsely, 0);
}

TEST(Docking, OfAHundredStartsSucceedsBackwardWithACameraAtTheRear) {
  TestRobot robot;
  robot.docks_backward = robot.rear_camera = true;
  const Counted counted = CountDocked(NominalOf(robot), 100);
  EXPECT_GE(counted.docked, 98) << counted.failures;
  EXPECT_EQ(counted.falsely, 0);
}

TEST(Docking, OfAHundredStartsSucceedsBackwardByDeadReckoning) {
  TestRobot robot;
  robot.docks_backward = true;
  const Counted counted = CountDocked(NominalOf(robot), 100);
  EXPECT_GE(counted.docked, 90) << counted.failures;
  EXPECT_EQ(counted.falsely, 0);
}

TEST(Docking, OfAHundredStartsSucceedsWithoutAContact) {
  TestRobot robot;
  robot.contact = false;
  const Counted counted = CountDocked(NominalOf(robot), 100);
  EXPECT_GE(counted.docked, 95) << counted.failures;
  EXPECT_EQ(counted.falsely, 0);
}

TEST(Docking, OfAHundredStartsSucceedsWithoutAnInertialUnit) {
  Nominal nominal = NominalOf();
  nominal.has_imu = false;
  const Counted counted = CountDocked(nominal, 100);
  EXPECT_GE(counted.docked, 95) << counted.failures;
  EXPECT_EQ(counted.falsely, 0);
}

TEST(Docking, OfAHundredStartsSucceedsWithWheelsThatScrub) {
  for (const double turn_share : {0.5, 0.9}) {
    const Counted counted = CountDocked(
        SkidSteered(), 50, [&](KinematicWorld* world) { world->turn_share = turn_share; });
    EXPECT_GE(counted.docked, 48) << counted.failures;
    EXPECT_EQ(counted.falsely, 0);
  }
}

TEST(Docking, OfAHundredStartsMostSucceedWithThriceTheErrorsAndHalfOfTheImages) {
  const Counted counted = CountDocked(NominalOf(), 100, [](KinematicWorld* world) {
    world->range_m = [](double r) { return 0.003 + 0.012 * r * r; };
    world->aside_m = [](double r) { return 0.003 + 0.003 * r; };
    world->turn_rad = [](double r) { return 0.03 + 0.06 * r; };
    world->dropout = 0.5;
    world->latency_s = 0.4;
  });
  EXPECT_GE(counted.docked, 90) << counted.failures;
  EXPECT_EQ(counted.falsely, 0);
}

TEST(Docking, OvercomesADeadBand) {
  Nominal nominal = NominalOf();
  nominal.docking.dead_m_s = 0.03;
  nominal.docking.dead_rad_s = 0.1;
  EXPECT_GE(CountDocked(nominal, 20).docked, 19);
}

TEST(Docking, BelievesWhereTheRobotIsWithinFourSigma) {
  // With no contact the run ends where the robot believes to be docked: no wheel has slipped.
  TestRobot robot;
  robot.contact = false;
  const Nominal nominal = NominalOf(robot);
  const Pose2 docked = ToGround(nominal.X_DR_docked());
  int within = 0, ended = 0;
  for (std::uint64_t seed = 201; seed <= 240; ++seed) {
    const KinematicRun run = RunKinematic(nominal, Real(seed));
    if (run.verdict != Verdict::kDone) continue;
    ++ended;
    const Pose2 truth = docked * Pose2{run.along_m, run.aside_m, run.off_rad};
    const Pose2 believed = run.belief.X_DR;
    if (std::abs(believed.x - truth.x) < 4.0 * ValueOf(run.belief, "dock_sigma_x_m", 0.0) &&
        std::abs(believed.y - truth.y) < 4.0 * ValueOf(run.belief, "dock_sigma_y_m", 0.0) &&
        std::abs(WrapPi(believed.heading - truth.heading)) <
            4.0 * Radians(ValueOf(run.belief, "dock_sigma_yaw_deg", 0.0)))
      ++within;
    EXPECT_EQ(ValueOf(run.belief, "tag_branches_open", 1.0), 0.0) << seed;
  }
  EXPECT_GE(ended, 38);
  EXPECT_GE(within, ended - 1);
}

}  // namespace
}  // namespace dockyard::custom
