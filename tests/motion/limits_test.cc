#include "controller/motion/limits.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace dockyard {
namespace {

constexpr std::array<NominalMotor, 2> kMotors{
    NominalMotor{.max_current_a = 2.2, .max_speed_rad_s = 2.0, .max_accel_rad_s2 = 5.0},
    NominalMotor{.max_current_a = 1.0, .max_speed_rad_s = 0.5, .max_accel_rad_s2 = 1.0}};

MotorCommand Kept(const MotorCommand& command) {
  Commands commands{.motors = {command, {}}};
  KeepLimits(kMotors, &commands);
  return commands.motors[0];
}

TEST(Limits, BoundEverySpeedAccelerationAndCurrent) {
  EXPECT_EQ(Kept({MotorMode::kVelocity, -100.0, 9.0, 1e6, 50.0}),
            (MotorCommand{MotorMode::kVelocity, -2.0, 2.0, 5.0, 2.2}));
  EXPECT_EQ(Kept({MotorMode::kVelocity, 100.0, -9.0, -1.0, -50.0}),
            (MotorCommand{MotorMode::kVelocity, 2.0, 0.0, 0.0, 0.0}));
}

TEST(Limits, LeaveAPositionAndACommandWithinThem) {
  const MotorCommand turns{MotorMode::kPosition, 100.0, 1.0, 4.0, 2.0};
  EXPECT_EQ(Kept(turns), turns);
  EXPECT_EQ(Kept({}), MotorCommand{});
}

TEST(LimitsDeathTest, RefuseACommandThatIsNoNumberAndOneOfAnotherRobot) {
  EXPECT_DEATH(Kept({MotorMode::kFree, std::numeric_limits<double>::quiet_NaN()}), "check failed");
  Commands one{.motors = {{}}};
  EXPECT_DEATH(KeepLimits(kMotors, &one), "check failed");
}

}  // namespace
}  // namespace dockyard
