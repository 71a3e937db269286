// Robots from files where the ground yields: as deep as one of their wheels alone, and with the
// slip at which such a wheel pulls nothing.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "custom/charger_rig.h"
#include "custom/wheeled_kinds.h"
#include "models/parts/gravity.h"
#include "sim/custom/world.h"
#include "sim/soil/single_wheel.h"

namespace dockyard::custom {
namespace {

constexpr double kRadius_m = 0.098, kWidth_m = 0.04, kWheel_kg = 0.3;

/// Four wheels about the weight's middle, the rear ones off the ruts of the front ones.
RobotText FourWheelsInTracksOfTheirOwn() {
  return {Robot(BoxLink("base_link", 15.0, {0.6, 0.3, 0.18}, "0 0 0.08") +
                WheelOn("base_link", "front_left", "0.25 0.19 0", kRadius_m, kWidth_m) +
                WheelOn("base_link", "rear_left", "-0.25 0.29 0", kRadius_m, kWidth_m) +
                WheelOn("base_link", "front_right", "0.25 -0.19 0", kRadius_m, kWidth_m) +
                WheelOn("base_link", "rear_right", "-0.25 -0.29 0", kRadius_m, kWidth_m)),
          RobotYaml({"front_left", "rear_left", "front_right", "rear_right"}, "")};
}

SoilModel Soil() { return *LoadGround(SourceFile("models/soils/pavlov_90.yaml")).soil; }

/// Far from the dock, and away from it.
WorldSetup OnSoil() {
  const ScratchFolder folder;
  const RobotText text = FourWheelsInTracksOfTheirOwn();
  folder.Write("robot.urdf", text.urdf);
  folder.Write("robot.yaml", text.yaml);
  WorldSetup setup = ChargerWorld({"start={r_m: 3, alpha_deg: 0, heading_deg: 180}", "scenery=[]",
                                   "yard={length_m: 14, width_m: 8, undulation_rms_m: 0}"});
  setup.robot = LoadRobot((folder.path() / "robot.yaml").string());
  setup.robot_frame = "base_link";
  setup.soils = {Soil()};
  return setup;
}

std::vector<MotorCommand> Turning(const RobotModel& robot, double rim_m_s) {
  std::vector<MotorCommand> commands;
  for (const MotorFit& motor : robot.motors) {
    commands.push_back({.mode = MotorMode::kVelocity,
                        .target = rim_m_s / kRadius_m,
                        .speed_limit_rad_s = 0.0,
                        .accel_rad_s2 = motor.model.max_accel_rad_s2,
                        .current_limit_a = motor.model.max_current_a});
  }
  return commands;
}

double MiddleOf(const Truth& truth, const RobotModel& robot, std::size_t wheel) {
  return truth.X_WL[static_cast<std::size_t>(robot.wheels[wheel].link)].p.z();
}

// The world lets the robot down for a second. A wheel of a quarter of its weight does the same
// alone, as nothing turns the robot.
TEST(CustomOnSoil, RobotSinksAsOneOfItsWheelsDoesAlone) {
  const WorldSetup setup = OnSoil();
  const World world(setup);
  const Truth truth = world.truth();
  const double quarter_kg = 0.25 * setup.robot.tree.mass_kg();
  HeightGrid grid = setup.ground.heights;
  WheelSoil alone(setup.robot.wheels[0].on_soil, Soil());
  WheelMotion motion;
  motion.X_GK.p = Eigen::Vector3d(3.25, 0.19, kRadius_m);
  for (int i = 0; i < std::lround(1.0 / setup.step_s); ++i) {
    const WheelLoad load = alone.Step(grid, motion, setup.step_s);
    motion.v_GK_G.z() += setup.step_s * (load.force_G.z() / quarter_kg - kEarthGravity_m_s2);
    motion.X_GK.p.z() += setup.step_s * motion.v_GK_G.z();
  }
  const double sunk_m = kRadius_m - motion.X_GK.p.z();
  std::printf("sunk by %.3f mm alone\n", 1e3 * sunk_m);
  EXPECT_GT(sunk_m, 2e-3);
  double sum_n = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(kRadius_m - MiddleOf(truth, setup.robot, i), sunk_m, 0.02 * sunk_m) << i;
    sum_n += truth.wheel_load_n[i];
  }
  EXPECT_NEAR(sum_n, 4.0 * quarter_kg * kEarthGravity_m_s2, 0.01 * sum_n);
}

/// The slip at which a wheel in its rig pulls nothing.
double SlipWithoutPull(double load_n) {
  SingleWheelSetup rig;
  rig.wheel = {.rim_radius_m = kRadius_m, .width_m = kWidth_m};
  rig.soil = Soil();
  rig.load_n = load_n;
  rig.speed_m_s = 0.1;
  double low = 0.04, high = 0.12;
  for (int i = 0; i < 6; ++i) {
    rig.slip = 0.5 * (low + high);
    (RunSingleWheel(rig).ahead_n < 0.0 ? low : high) = rig.slip;
  }
  return 0.5 * (low + high);
}

// Level and at a steady speed its wheels pull nothing together. The soil's resistance loads the
// rear ones a tenth more than the front ones, which shifts the slip by a few percent.
TEST(CustomOnSoil, RobotSlipsAsAWheelThatPullsNothing) {
  const WorldSetup setup = OnSoil();
  World world(setup);
  const std::vector<MotorCommand> commands = Turning(setup.robot, 0.3);
  RunFor(world, 2.5, commands);  // out of the holes that it is let down into
  const Truth before = world.truth();
  RunFor(world, 1.5, commands);
  const Truth after = world.truth();
  const double rolled_m = kRadius_m * (after.motors[0].angle_rad - before.motors[0].angle_rad);
  const double slip = 1.0 - (after.X_DR.p - before.X_DR.p).norm() / rolled_m;
  const double wanted = SlipWithoutPull(0.25 * setup.robot.tree.mass_kg() * kEarthGravity_m_s2);
  std::printf("slip %.4f, alone %.4f\n", slip, wanted);
  EXPECT_NEAR(rolled_m, 0.45, 0.01);
  EXPECT_GT(wanted, 0.01);
  EXPECT_NEAR(slip, wanted, 0.1 * wanted);
  EXPECT_NEAR(after.X_DR.p.y(), before.X_DR.p.y(), 2e-3);
  // What the world says of its wheels, in the mean.
  ASSERT_EQ(after.wheel_slip.size(), 4u);
  EXPECT_NEAR(0.25 * (after.wheel_slip[0] + after.wheel_slip[1] + after.wheel_slip[2] +
                      after.wheel_slip[3]),
              slip, 0.1 * slip);
}

// Its wheels leave ruts as deep as they are sunk, less the soil's rebound.
TEST(CustomOnSoil, RobotLeavesRuts) {
  const WorldSetup setup = OnSoil();
  World world(setup);
  RunFor(world, 4.0, Turning(setup.robot, 0.15));
  const double sunk_m = kRadius_m - MiddleOf(world.truth(), setup.robot, 0);
  const double rut_m = -world.ground().Height(3.4, 0.19);  // passed by the front left wheel
  std::printf("sunk %.2f mm, rut %.2f mm\n", 1e3 * sunk_m, 1e3 * rut_m);
  EXPECT_LT(rut_m, sunk_m);
  EXPECT_GT(rut_m, 0.5 * sunk_m);
  EXPECT_EQ(world.ground().Height(3.4, -0.6), 0.0);
}

}  // namespace
}  // namespace dockyard::custom
