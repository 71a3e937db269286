#include "controller/custom/twist_limits.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard::custom {
namespace {

TEST(TwistLimits, ChangeNoFasterThanTheAccelerations) {
  const DockingOptions options{};
  TwistLimits limits(options);
  Twist last{};
  for (int i = 0; i < 100; ++i) {
    const Twist twist = limits.Step({i < 50 ? 0.25 : -0.25, i < 30 ? 0.7 : -0.7}, 0.02);
    EXPECT_LE(std::abs(twist.speed_m_s - last.speed_m_s), options.accel_m_s2 * 0.02 + 1e-12);
    EXPECT_LE(std::abs(twist.turn_rad_s - last.turn_rad_s), options.accel_rad_s2 * 0.02 + 1e-12);
    last = twist;
  }
  EXPECT_DOUBLE_EQ(last.speed_m_s, -0.25);
}

TEST(TwistLimits, RaiseASpeedWithinTheDeadBandButLeaveZero) {
  DockingOptions options{};
  options.dead_m_s = 0.02;
  options.dead_rad_s = 0.1;
  TwistLimits limits(options);
  EXPECT_DOUBLE_EQ(limits.Step({0.005, 0.0}, 0.02).speed_m_s, 0.02);
  EXPECT_DOUBLE_EQ(limits.Step({-0.005, 0.0}, 0.02).speed_m_s, -0.02);
  EXPECT_DOUBLE_EQ(TwistLimits(options).Step({0.0, -0.01}, 0.02).turn_rad_s, -0.1);
  EXPECT_DOUBLE_EQ(TwistLimits(options).Step({0.1, 0.01}, 0.02).turn_rad_s, 0.01);
  EXPECT_DOUBLE_EQ(TwistLimits(options).Step({0.0, 0.0}, 0.02).speed_m_s, 0.0);
}

TEST(BrakingSpeed, StopsWithinTheDistanceAtLessThanTheAcceleration) {
  // v^2 = end^2 + 2 a d.
  const double v = BrakingSpeed(0.5, 0.1, 0.4);
  EXPECT_LT((v * v - 0.01) / (2.0 * 0.5), 0.4);
  EXPECT_DOUBLE_EQ(BrakingSpeed(-0.1, 0.1, 0.4), 0.1);
}

TEST(TurnBy, TurnsToWhereItIsLeft) {
  EXPECT_GT(TurnBy(0.1, DockingOptions{}).turn_rad_s, 0.0);
  EXPECT_LT(TurnBy(-0.1, DockingOptions{}).turn_rad_s, 0.0);
  EXPECT_DOUBLE_EQ(TurnBy(3.0, DockingOptions{}).turn_rad_s, DockingOptions{}.most_rad_s);
}

}  // namespace
}  // namespace dockyard::custom
