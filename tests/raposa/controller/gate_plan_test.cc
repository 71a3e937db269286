#include "controller/raposa/gate_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raposa/controller/drawn_marks.h"

namespace dockyard::raposa {
namespace {

/// Its pyramid reaches from 0.025 m before the guide's middle to 0.145 m behind it.
Nominal RobotNominal() {
  Nominal nominal = TestNominal();
  nominal.grey_boxes = {{{-0.145, -0.04, -0.045}, {-0.05, 0.04, 0.03}}};
  return nominal;
}

/// The smallest distance of a straight way from the pyramid's middle, by sampling.
double Nearest(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  double nearest = 1e9;
  for (int i = 0; i <= 400; ++i) {
    nearest = std::min(nearest, (a + i / 400.0 * (b - a) - Eigen::Vector2d(-0.06, 0.0)).norm());
  }
  return nearest;
}

TEST(GatePlan, EveryWayEndsOnTheAxisAndKeepsItsDistance) {
  const Nominal nominal = RobotNominal();
  const DockyardOptions options;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> range(0.4, 4.3), angle(-2.6, 2.6), heading(-kPi, kPi);
  for (int i = 0; i < 5000; ++i) {
    const double r = range(random), alpha = angle(random);
    const Pose2 X_DN{r * std::cos(alpha), r * std::sin(alpha), heading(random)};
    const Eigen::Vector2d start(X_DN.x, X_DN.y);
    if ((start - Eigen::Vector2d(-0.06, 0.0)).norm() < options.turn_room_m) continue;
    const GatePlan plan = PlanToGate(X_DN, nominal, options);
    ASSERT_FALSE(plan.legs.empty()) << r << " m, " << Degrees(alpha) << " deg";
    Eigen::Vector2d at = start;
    for (const Leg& leg : plan.legs) {
      EXPECT_GE(Nearest(at, leg.p_D_end), std::min(options.keep_out_m, Nearest(at, at)) - 1e-3);
      // It turns where a leg ends.
      EXPECT_GE(Nearest(leg.p_D_end, leg.p_D_end), options.turn_room_m);
      const Eigen::Vector2d along(std::cos(leg.heading_rad), std::sin(leg.heading_rad));
      EXPECT_LT((at + leg.length_m * along - leg.p_D_end).norm(), 1e-9);
      at = leg.p_D_end;
    }
    EXPECT_NEAR(at.y(), 0.0, 1e-12);
    EXPECT_GE(at.x(), options.gate_m - 1e-12);
    EXPECT_LE(at.x(), options.far_gate_m + 1e-12);
  }
}

TEST(GatePlan, RobotTooNearToTurnDrivesAwayFirst) {
  const Nominal nominal = RobotNominal();
  const DockyardOptions options;
  const double alpha = Radians(60.0);
  const Pose2 X_DN{0.40 * std::cos(alpha), 0.40 * std::sin(alpha), WrapPi(alpha + kPi)};
  const GatePlan plan = PlanToGate(X_DN, nominal, options);
  ASSERT_GE(plan.legs.size(), 2u);
  EXPECT_LT(plan.legs.front().length_m, 0.0);
  EXPECT_DOUBLE_EQ(plan.legs.front().heading_rad, X_DN.heading);
}

TEST(GatePlan, RobotTooNearDrivesAwayWhicheverWayItFaces) {
  const Nominal nominal = RobotNominal();
  const DockyardOptions options;
  const Eigen::Vector2d middle(-0.06, 0.0);
  for (int i = 0; i < 72; ++i) {
    const Pose2 X_DN{0.30, 0.20, WrapPi(Radians(5.0 * i))};
    const Eigen::Vector2d start(X_DN.x, X_DN.y);
    const GatePlan plan = PlanToGate(X_DN, nominal, options);
    ASSERT_GE(plan.legs.size(), 2u);
    const Leg& away = plan.legs.front();
    EXPECT_GE((away.p_D_end - middle).norm(), options.turn_room_m);
    // It comes nearer by no more than a way square to the pyramid does.
    EXPECT_GE(Nearest(start, away.p_D_end), (start - middle).norm() - 1e-3);
  }
}

TEST(GatePlan, LegAcrossKeepsTheRangeAndGoesTowardsTheGate) {
  const DockyardOptions options;
  for (const double alpha_deg : {-100.0, -40.0, 20.0, 75.0}) {
    const double alpha = Radians(alpha_deg);
    const Eigen::Vector2d at(1.4 * std::cos(alpha), 1.4 * std::sin(alpha));
    const Pose2 X_DN{at.x(), at.y(), WrapPi(alpha + kPi + 0.1)};
    const Leg leg = AcrossSight(X_DN, 0.15, options);
    EXPECT_NEAR((leg.p_D_end - at).norm(), 0.15, 1e-12);
    EXPECT_NEAR((leg.p_D_end - at).dot(at), 0.0, 1e-12);
    const Eigen::Vector2d gate(options.gate_m, 0.0);
    EXPECT_LT((leg.p_D_end - gate).norm(), (at - gate).norm()) << alpha_deg;
    // No turn beyond a right angle: it may drive backwards.
    EXPECT_LE(std::abs(WrapPi(leg.heading_rad - X_DN.heading)), kPi / 2 + 1e-12);
    const Eigen::Vector2d along(std::cos(leg.heading_rad), std::sin(leg.heading_rad));
    EXPECT_NEAR((at + leg.length_m * along - leg.p_D_end).norm(), 0.0, 1e-12);
  }
}

TEST(GatePlan, ConeHoldsTheAxisAndNotItsSides) {
  const Nominal nominal = RobotNominal();
  const DockyardOptions options;
  EXPECT_TRUE(InCone({1.0, 0.0, kPi}, options));
  EXPECT_TRUE(InCone({1.0, 0.045, Radians(-175.0)}, options));
  EXPECT_FALSE(InCone({1.0, 0.05, Radians(175.0)}, options));  // away from the axis
  EXPECT_FALSE(InCone({1.0, 0.2, kPi}, options));
  EXPECT_FALSE(InCone({1.0, 0.0, Radians(160.0)}, options));
  EXPECT_FALSE(InCone({-1.0, 0.0, kPi}, options));
}

}  // namespace
}  // namespace dockyard::raposa
