#include "controller/custom/drive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "custom/controller/test_robot.h"

namespace dockyard::custom {
namespace {

using ::testing::HasSubstr;

/// Velocity of the rim against the robot where it touches the ground, by the cross product.
Eigen::Vector3d RimAtGround(const RobotWheel& wheel, double wheel_rad_s) {
  return (wheel_rad_s * wheel.axle_R).cross(Eigen::Vector3d(0.0, 0.0, -wheel.radius_m));
}

/// Whether each wheel rolls without slip along x at the twist: the ground's speed under it is that
/// of its rim.
void ExpectRolling(const Nominal& nominal, const Twist& twist) {
  const auto drive = FindDrive(nominal);
  ASSERT_TRUE(drive) << drive.error().reason;
  const Commands commands = RunAt(*drive, nominal, twist);
  for (const RobotWheel& wheel : nominal.wheels) {
    if (wheel.drive < 0) continue;
    const auto i = static_cast<std::size_t>(wheel.drive);
    const MotorCommand& motor = commands.motors[i];
    EXPECT_EQ(motor.mode, MotorMode::kVelocity);
    const double x_m_s = twist.speed_m_s - twist.turn_rad_s * wheel.p_RK.y();
    EXPECT_NEAR(RimAtGround(wheel, motor.target * nominal.motors[i].travel_per_rad).x() + x_m_s,
                0.0, 1e-12)
        << wheel.link;
  }
}

TEST(Drive, RollsBothWheelsWithoutSlipWhateverAxlesAndGearsPointTo) {
  for (const double axle : {1.0, -1.0}) {
    for (const double gear : {1.0, -0.5}) {
      TestRobot robot;
      robot.left_axle = axle;
      robot.left_travel_per_rad = gear;
      robot.axle_x_m = 0.1;
      for (const Twist& twist :
           {Twist{0.2, 0.0}, Twist{-0.1, 0.0}, Twist{0.0, 0.5}, Twist{0.1, -0.3}})
        ExpectRolling(NominalOf(robot), twist);
    }
  }
}

TEST(Drive, KeepsTheCurvatureWhereAMotorIsTooSlow) {
  const Nominal nominal = NominalOf();
  const Drive drive = *FindDrive(nominal);
  const Commands commands = RunAt(drive, nominal, {2.0, 4.0});
  const double left = 0.08 * commands.motors[0].target, right = 0.08 * commands.motors[1].target;
  EXPECT_NEAR(commands.motors[1].target, 10.0, 1e-12);
  EXPECT_NEAR((right - left) / 0.4 / (0.5 * (left + right)), 2.0, 1e-12);
}

TEST(Drive, OfFourOrSixWheelsRunsThoseOfASideAlike) {
  for (const int per_side : {2, 3}) {
    Nominal nominal = NominalOf();
    const RobotWheel left = nominal.wheels[0], right = nominal.wheels[1];
    const JointDrive motor = nominal.motors[0];
    nominal.wheels.clear();
    nominal.motors.clear();
    for (int i = 0; i < per_side; ++i) {
      for (RobotWheel wheel : {left, right}) {
        wheel.p_RK.x() = 0.2 * i;
        wheel.drive = static_cast<int>(nominal.motors.size());
        nominal.motors.push_back(motor);
        nominal.wheels.push_back(wheel);
      }
    }
    const auto drive = FindDrive(nominal);
    ASSERT_TRUE(drive) << drive.error().reason;
    EXPECT_NEAR(drive->X_RA.x, 0.1 * (per_side - 1), 1e-12);
    EXPECT_NEAR(drive->gauge_m, 0.4, 1e-12);
    const Commands commands = RunAt(*drive, nominal, {0.1, 0.2});
    for (std::size_t i = 2; i < nominal.motors.size(); ++i)
      EXPECT_DOUBLE_EQ(commands.motors[i].target, commands.motors[i - 2].target);
  }
}

TEST(Drive, BrakesMotorsOfNoWheel) {
  Nominal nominal = NominalOf();
  nominal.motors.push_back(nominal.motors[0]);
  EXPECT_EQ(RunAt(*FindDrive(nominal), nominal, {0.1, 0.0}).motors[2].mode, MotorMode::kBrake);
}

void ExpectRefused(const Nominal& nominal, const std::string& why) {
  const auto drive = FindDrive(nominal);
  ASSERT_FALSE(drive);
  EXPECT_THAT(drive.error().reason, HasSubstr(why));
}

TEST(Drive, RefusesWhatItCannotDriveAndNamesIt) {
  Nominal steered = NominalOf();
  steered.wheels[1].steering = 1;
  ExpectRefused(steered, "wheel right wheel: it is steered");
  Nominal none = NominalOf();
  none.wheels[0].drive = none.wheels[1].drive = -1;
  ExpectRefused(none, "there are 0, expected 2, 4 or 6");
  Nominal one_side = NominalOf();
  one_side.wheels[1].p_RK.y() = one_side.wheels[0].p_RK.y();
  ExpectRefused(one_side, "same number on each side");
  Nominal sideways = NominalOf();
  sideways.wheels[0].axle_R = {1.0, 0.0, 0.0};
  ExpectRefused(sideways, "its axle points elsewhere");
  Nominal apart = NominalOf();
  apart.wheels[0].p_RK.x() = 0.1;
  ExpectRefused(apart, "same x");
  Nominal fixed = NominalOf();
  fixed.wheels[2].swivels = false;
  ExpectRefused(fixed, "wheel caster: fixed and not driven");
  Nominal shared = NominalOf();
  shared.wheels[1].drive = 0;
  ExpectRefused(shared, "its motor drives an unlike wheel");
  Nominal stuck = NominalOf();
  stuck.motors[0].travel_per_rad = 0.0;
  ExpectRefused(stuck, "its motor does not move its joint");
}

}  // namespace
}  // namespace dockyard::custom
