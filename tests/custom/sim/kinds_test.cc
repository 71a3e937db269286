// Robots of several kinds drive from a URDF and a YAML file of 40 lines.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "custom/charger_rig.h"
#include "custom/wheeled_kinds.h"
#include "models/read/config_error.h"
#include "sim/custom/world.h"

namespace dockyard::custom {
namespace {

using ::testing::HasSubstr;

RobotModel Load(const RobotText& text) {
  const ScratchFolder folder;
  folder.Write("robot.urdf", text.urdf);
  folder.Write("robot.yaml", text.yaml);
  return LoadRobot((folder.path() / "robot.yaml").string());
}

/// Far from the dock, away from it, on the hard floor.
WorldSetup SetupOf(const RobotModel& robot) {
  WorldSetup setup = ChargerWorld({"start.r_m=3.0", "start.alpha_deg=0", "start.heading_deg=180",
                                   "yard.length_m=20", "yard.width_m=12"});
  setup.robot = robot;
  setup.robot_frame = "base_link";
  return setup;
}

/// Treads at these speeds, by the side of the wheel.
std::vector<MotorCommand> Drive(const RobotModel& robot, double left_m_s, double right_m_s) {
  std::vector<MotorCommand> commands;
  const std::vector<Pose3> X_RL = StartPoses(robot.tree);
  for (const MotorFit& motor : robot.motors) {
    const double speed =
        X_RL[static_cast<std::size_t>(motor.link)].p.y() > 0.0 ? left_m_s : right_m_s;
    commands.push_back({.mode = MotorMode::kVelocity,
                        .target = speed / robot.wheels[0].tyre.radius_m,
                        .speed_limit_rad_s = 0.0,
                        .accel_rad_s2 = motor.model.max_accel_rad_s2,
                        .current_limit_a = motor.model.max_current_a});
  }
  return commands;
}

struct Kind {
  const char* name;
  RobotText (*text)();
  double track_m;
  double least_turn;  // of the turn that wheels without slip would give; fixed ones scrub
};

class WheeledKind : public testing::TestWithParam<Kind> {};

TEST_P(WheeledKind, DrivesStraightAsFarAsItsWheelsRoll) {
  const RobotModel robot = Load(GetParam().text());
  World world(SetupOf(robot));
  RunFor(world, 1.0, Drive(robot, 0.3, 0.3));
  const Truth before = world.truth();
  RunFor(world, 3.0, Drive(robot, 0.3, 0.3));
  const Truth after = world.truth();
  const double rolled_m =
      (after.motors[0].angle_rad - before.motors[0].angle_rad) * robot.wheels[0].tyre.radius_m;
  EXPECT_NEAR(rolled_m, 0.9, 0.02);
  EXPECT_NEAR((after.X_DR.p - before.X_DR.p).norm(), rolled_m, 0.01 * rolled_m);
  EXPECT_NEAR(after.X_DR.p.y(), before.X_DR.p.y(), 0.01);
  EXPECT_LT(after.tilt_rad, Radians(3.0));
}

TEST_P(WheeledKind, TurnsOnTheSpot) {
  const Kind& kind = GetParam();
  const RobotModel robot = Load(kind.text());
  World world(SetupOf(robot));
  RunFor(world, 1.0, Drive(robot, -0.1, 0.1));
  const double before = ToGround(world.truth().X_GR).heading;
  const Eigen::Vector3d place = world.truth().X_GR.p;
  RunFor(world, 1.5, Drive(robot, -0.1, 0.1));
  const double turned = WrapPi(ToGround(world.truth().X_GR).heading - before);
  const double without_slip = 1.5 * 0.2 / kind.track_m;
  EXPECT_LT(turned, 1.02 * without_slip);
  EXPECT_GT(turned, kind.least_turn * without_slip);
  EXPECT_LT((world.truth().X_GR.p - place).norm(), 0.03);
}

TEST_P(WheeledKind, NeedsAFileOf40LinesAtMost) {
  const std::string yaml = GetParam().text().yaml;
  EXPECT_LE(std::count(yaml.begin(), yaml.end(), '\n'), 40);
}

INSTANTIATE_TEST_SUITE_P(All, WheeledKind,
                         testing::Values(Kind{"two_and_a_ball", TwoWheelsAndABall, 0.16, 0.93},
                                         Kind{"two_and_two_casters", TwoWheelsAndTwoCasters, 0.40,
                                              0.98},
                                         Kind{"four_fixed", FourFixedWheels, 0.38, 0.3},
                                         Kind{"six_fixed", SixFixedWheels, 0.50, 0.3}),
                         [](const auto& info) { return std::string(info.param.name); });

std::string Refusal(const RobotText& text) {
  try {
    Load(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(WheeledKinds, WhatIsNotSimulatedIsRefusedWithItsPlace) {
  RobotText floats = TwoWheelsAndABall();
  const std::string from = "name=\"left_wheel_joint\" type=\"continuous\"";
  floats.urdf.replace(floats.urdf.find(from), from.size(),
                      "name=\"left_wheel_joint\" type=\"planar\"");
  EXPECT_THAT(Refusal(floats), HasSubstr("a planar joint from 'base_link' to 'left_wheel'"));
  RobotText boxes = TwoWheelsAndABall();
  const std::string cylinder = "<cylinder radius=\"0.033\" length=\"0.018\"/>";
  boxes.urdf.replace(boxes.urdf.find(cylinder), cylinder.size(), "<box size=\"0.06 0.02 0.06\"/>");
  EXPECT_THAT(Refusal(boxes), HasSubstr("expected tyre.radius_m, or one cylinder"));
}

}  // namespace
}  // namespace dockyard::custom
