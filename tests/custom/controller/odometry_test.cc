#include "controller/custom/odometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "custom/controller/test_robot.h"

namespace dockyard::custom {
namespace {

SensorFrame FrameAt(Tick tick, double left_rad, double right_rad, double yaw_rad) {
  SensorFrame frame;
  frame.tick = tick;
  frame.motors = {{.encoder_counts = std::llround(left_rad / 0.001)},
                  {.encoder_counts = std::llround(right_rad / 0.001)}};
  frame.imu.yaw_rad = yaw_rad;
  return frame;
}

TEST(Odometry, OfAQuarterCircleEndsOnIt) {
  for (const bool has_imu : {true, false}) {
    TestRobot robot;
    robot.right_axle = -1.0;
    robot.right_travel_per_rad = -1.0;  // both turn the sign: the encoder counts up forward
    Nominal nominal = NominalOf(robot);
    nominal.has_imu = has_imu;
    Odometry odometry(nominal, *FindDrive(nominal));
    const double radius = 1.0;
    for (int i = 0; i <= 1000; ++i) {
      const double turned = 0.5 * kPi * i / 1000.0;
      odometry.Read(FrameAt(20 * i, turned * (radius - 0.2) / 0.08, turned * (radius + 0.2) / 0.08,
                            has_imu ? turned : 0.0));
    }
    EXPECT_NEAR(odometry.X_OA().x, 1.0, 2e-3);
    EXPECT_NEAR(odometry.X_OA().y, 1.0, 2e-3);
    EXPECT_NEAR(odometry.X_OA().heading, 0.5 * kPi, 1e-3);
  }
}

TEST(Odometry, LearnsFromTheUnitWhichShareOfTheWheelsTurnsComesAbout) {
  const Nominal nominal = NominalOf();
  Odometry odometry(nominal, *FindDrive(nominal));
  EXPECT_DOUBLE_EQ(odometry.turn_share(), 1.0);
  for (int i = 0; i <= 500; ++i) {
    const double turned = 0.01 * i;  // by the wheels
    odometry.Read(FrameAt(20 * i, -turned * 0.2 / 0.08, turned * 0.2 / 0.08, 0.6 * turned));
  }
  EXPECT_NEAR(odometry.turn_share(), 0.6, 0.03);
}

}  // namespace
}  // namespace dockyard::custom
