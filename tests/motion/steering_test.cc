#include "controller/motion/steering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/rover_sample.h"

namespace dockyard {
namespace {

struct Row {
  double radius_m, inner_deg, outer_deg, slip_inner_deg, slip_outer_deg;
  double front_inner, front_outer, back_inner, back_outer;  // ways, of the reference point's
};

// delta = atan2(L, r -+ w), tandem slip atan(0.069 / (r -+ w)), to the digits of the reference.
TEST(OnArc, GivesTheSteeringTableOfRocky7) {
  const Row rows[] = {
      {0.40, 63.9, 34.3, 19.0, 6.6, 1.14, 1.82, 0.53, 1.51},
      {0.50, 53.7, 30.3, 13.0, 5.6, 1.01, 1.62, 0.62, 1.41},
      {0.75, 36.6, 23.3, 7.2, 4.2, 0.91, 1.38, 0.74, 1.27},
      {1.50, 17.5, 13.5, 3.0, 2.3, 0.91, 1.17, 0.87, 1.13},
  };
  const RoverPlan rover = RockySample();  // front, middle, back left; then right
  for (const Row& row : rows) {
    const Arc left{row.radius_m, 1.0};
    const WheelOnArc inner = OnArc(rover.wheels[0], left), outer = OnArc(rover.wheels[3], left);
    EXPECT_NEAR(Degrees(inner.steer_rad), row.inner_deg, 0.06) << row.radius_m;
    EXPECT_NEAR(Degrees(outer.steer_rad), row.outer_deg, 0.06) << row.radius_m;
    EXPECT_NEAR(inner.way_m / row.radius_m, row.front_inner, 0.006);
    EXPECT_NEAR(outer.way_m / row.radius_m, row.front_outer, 0.006);
    const WheelOnArc back_inner = OnArc(rover.wheels[2], left);
    const WheelOnArc back_outer = OnArc(rover.wheels[5], left);
    EXPECT_NEAR(Degrees(std::abs(back_inner.side_slip_rad)), row.slip_inner_deg, 0.06);
    EXPECT_NEAR(Degrees(std::abs(back_outer.side_slip_rad)), row.slip_outer_deg, 0.06);
    // The table counts a tandem wheel's whole way, ours what it rolls.
    EXPECT_NEAR(std::hypot(back_inner.way_m, 0.069) / row.radius_m, row.back_inner, 0.006);
    EXPECT_NEAR(std::hypot(back_outer.way_m, 0.069) / row.radius_m, row.back_outer, 0.006);
  }
}

TEST(OnArc, SteersBothFrontWheelsInwardsToTurnInPlace) {
  const RoverPlan rover = RockySample();
  const Arc in_place{0.0, 1.0};
  EXPECT_NEAR(Degrees(OnArc(rover.wheels[0], in_place).steer_rad), -63.9, 0.06);
  EXPECT_NEAR(Degrees(OnArc(rover.wheels[3], in_place).steer_rad), 63.9, 0.06);
  EXPECT_LT(OnArc(rover.wheels[0], in_place).way_m, 0.0);
  EXPECT_GT(OnArc(rover.wheels[3], in_place).way_m, 0.0);
}

TEST(OnArc, SteersAlikeForwardsAndBackwardsOnOneCircle) {
  const WheelPlan wheel{"front", {0.4, 0.2}, 1.2};
  const WheelOnArc on = OnArc(wheel, {0.5, 1.0}), back = OnArc(wheel, {-0.5, -1.0});
  EXPECT_DOUBLE_EQ(on.steer_rad, back.steer_rad);
  EXPECT_DOUBLE_EQ(on.way_m, -back.way_m);
}

// A wheel's centre goes where the wheel points, and as far as it rolls: the arc driven in steps.
TEST(OnArc, AgreesWithTheWayOfTheWheelsCentre) {
  const WheelPlan wheel{"corner", {-0.3, 0.25}, 1.5};
  const Arc arc{0.8, 0.7};
  const WheelOnArc on = OnArc(wheel, arc);
  constexpr int kSteps = 2000;
  double way = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const Pose2 from = Advance({}, Part(arc, 1.0 * i / kSteps));
    const Pose2 to = Advance({}, Part(arc, (i + 1.0) / kSteps));
    const Eigen::Vector2d step = to * wheel.p_RW - from * wheel.p_RW;
    way += step.norm();
    const double heading = std::atan2(step.y(), step.x()) - 0.5 * (from.heading + to.heading);
    EXPECT_NEAR(WrapPi(heading), on.steer_rad, 1e-3);
  }
  EXPECT_NEAR(way, on.way_m, 1e-6);
}

TEST(TurningLine, IsHalfWayBetweenTheAxlesOfATandemPair) {
  EXPECT_NEAR(*TurningLine_m(RockySample().wheels), 0.0, 1e-15);
  EXPECT_FALSE(TurningLine_m({{"front", {0.4, 0.2}, 1.0}}));
}

// r >= w + L / tan d, or r <= w - L / tan d.
TEST(LimitsOf, AreThoseOfTheSteeringLimit) {
  RoverPlan rover = RockySample();
  const struct {
    double limit_deg, least_m, pivot_m;
  } rows[] = {{60, 0.436, -1}, {64, 0.399, 0.001}, {70, 0.349, 0.051}, {75, 0.310, 0.090}};
  for (const auto& row : rows) {
    for (WheelPlan& wheel : rover.wheels) {
      if (wheel.steer_limit_rad != 0.0) wheel.steer_limit_rad = Radians(row.limit_deg);
    }
    const ArcLimits limits = LimitsOf(rover.wheels, Travel::kEither);
    EXPECT_NEAR(limits.least_radius_m, row.least_m, 6e-4);
    EXPECT_EQ(limits.pivot_radius_m.has_value(), row.pivot_m >= 0.0);
    EXPECT_NEAR(limits.pivot_radius_m.value_or(-1.0), row.pivot_m, 6e-4);
  }
}

TEST(LimitsOf, AreNoneWhereAllWheelsAreFixed) {
  EXPECT_EQ(LimitsOf({{"left", {0.2, 0.2}, 0.0}}, Travel::kEither).least_radius_m, 0.0);
}

}  // namespace
}  // namespace dockyard
