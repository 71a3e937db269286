// Plans among rocks that the controller was told of.
#include "controller/axel/rock_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/planner.h"

namespace dockyard::axel {
namespace {

const RockLimits kLimits{};

PlanGeometry With(const std::vector<MappedRock>& rocks) {
  Nominal nominal = TestNominal();
  nominal.rock_map = {rocks, 0.0};
  return PlanGeometryOf(nominal);
}

Pose2 At(double r, double alpha_deg, double h_deg) {
  return FromDockingCoords({r, Radians(alpha_deg), Radians(h_deg)});
}

// Least distance of the disc from the wheels' chords at its height, sampled along the plan.
double WheelsFrom(const AxisPlan& plan, double half_track_m, const MappedRock& rock) {
  const double radius_m = TestNominal().wheel_radius_m, above_m = radius_m - rock.height_m;
  const double half_m = std::sqrt(radius_m * radius_m - above_m * above_m);
  double least = 1e9;
  Pose2 at = plan.start;
  for (const Arc& arc : plan.arcs) {
    for (int i = 0; i <= 200; ++i) {
      const Pose2 here = Advance(at, Part(arc, i / 200.0));
      for (const double y : {-half_track_m, half_track_m}) {
        for (int j = -10; j <= 10; ++j) {
          const Eigen::Vector2d wheel = here * Eigen::Vector2d(0.1 * j * half_m, y);
          least = std::min(least, std::hypot(wheel.x() - rock.x_m, wheel.y() - rock.y_m));
        }
      }
    }
    at = Advance(at, arc);
    if (arc.length_m < 0.0) at = at * Pose2{0.0, 0.0, plan.cusp_turn_rad};
  }
  return least - rock.radius_m;
}

TEST(RockCheck, LowRocksBarNothing) {
  const Pose2 start{4.0, 0.0, kPi};
  const RockCheck low(With({{3.0, 0.4, 0.15, 0.9 * kLimits.body_clears_m}}), start);
  const RockCheck high(With({{3.0, 0.4, 0.15, 1.1 * kLimits.wheel_climbs_m}}), start);
  EXPECT_EQ(low.Cost(start, Arc{2.0, 0.0}), 0.0);
  EXPECT_TRUE(low.empty());
  EXPECT_GE(high.Cost(start, Arc{2.0, 0.0}), kRockCost_m);
}

TEST(RockCheck, WheelsStraddleARockThatTheBodyClears) {
  const Pose2 start{4.0, 0.0, kPi};
  const RockCheck passes(With({{2.5, 0.0, 0.1, 0.9 * kLimits.body_clears_m}}), start);
  const RockCheck bars(With({{2.5, 0.0, 0.1, 1.1 * kLimits.body_clears_m}}), start);
  EXPECT_EQ(passes.Cost(start, Arc{2.0, 0.0}), 0.0);
  EXPECT_GE(bars.Cost(start, Arc{2.0, 0.0}), kRockCost_m);
}

TEST(RockCheck, AWheelMayRollOverTheMiddleOfARockThatTheBodyMayNotPass) {
  const Pose2 start{4.0, 0.0, kPi};
  const double half_track_m = 0.5 * TestNominal().track_m;
  const auto bars = [&](double left_m) {
    const MappedRock rock{2.5, -left_m, 0.1, 0.9 * kLimits.wheel_climbs_m};
    return RockCheck(With({rock}), start).Cost(start, Arc{2.0, 0.0}) > 0.0;
  };
  EXPECT_FALSE(bars(half_track_m));
  EXPECT_FALSE(bars(-half_track_m));
  EXPECT_TRUE(bars(half_track_m - kLimits.half_wheel_m));
  EXPECT_TRUE(bars(0.2));
  EXPECT_TRUE(bars(0.0));
}

TEST(RockCheck, LegsEndWhereTheBodyIsOverNoRock) {
  const AxelOptions options{};
  const Pose2 start = At(4.0, 0.0, 0.0);
  const AxisPlan free = PlanToAxis(With({}), options, start);
  const Pose2 end = Advance(free.start, FirstLeg(With({}), options, free));
  const auto geometry = With({{end.x, end.y + 0.2, 0.1, 0.9 * kLimits.wheel_climbs_m}});
  EXPECT_TRUE(BodyNearRock(geometry, end));
  EXPECT_FALSE(BodyNearRock(geometry, Advance(free.start, FirstLeg(geometry, options, free))));
}

TEST(RockCheck, TetherGoesOverALowRockAndNotOverAHighOne) {
  // Half way from the tip to the mouth, 2 m of way that neither wheel nor arm comes to.
  const Pose2 start{4.0, 1.5, kPi + 0.3};
  const Arc still_turn{0.05, -0.3};
  const Pose2 there = Advance(start, still_turn);
  const Eigen::Vector2d tip = there * Eigen::Vector2d(1.0, 0.0), middle = 0.5 * tip;
  const auto cost = [&](double height_m) {
    return RockCheck(With({{middle.x(), middle.y(), 0.05, height_m}}), start)
        .Cost(start, still_turn);
  };
  EXPECT_EQ(cost(0.20), 0.0);
  EXPECT_GE(cost(0.35), kRockCost_m);
}

TEST(RockCheck, ARockThatIsTooNearAtTheStartDoesNotBarTheWayFromIt) {
  const Pose2 start{4.0, 0.0, kPi};
  // 2 cm beside the left wheel, which is on the side of -y.
  const double y_m = -0.5 * TestNominal().track_m - kLimits.half_wheel_m - 0.12;
  const RockCheck check(With({{4.0, y_m, 0.10, 0.3}}), start);
  EXPECT_EQ(check.Cost(start, Arc{1.0, 0.0}), 0.0);
}

TEST(RockCheck, PlansKeepClearOfARockOnTheirWay) {
  const AxelOptions options{};
  int barred = 0, clear = 0;
  for (const double alpha_deg : {-15.0, 0.0, 15.0}) {
    const Pose2 start = At(4.0, alpha_deg, 0.0);
    const double half_track_m = 0.5 * TestNominal().track_m;
    const AxisPlan free = PlanToAxis(With({}), options, start);
    for (const double share : {0.45, 0.6}) {
      const Pose2 on = Advance(free.start, Truncate(free.arcs, share * Length(free.arcs)));
      const Eigen::Vector2d wheel = on * Eigen::Vector2d(0.0, half_track_m);
      const MappedRock rock{wheel.x(), wheel.y(), 0.15, 0.14};
      if (WheelsFrom(free, half_track_m, rock) > kLimits.half_wheel_m) continue;
      ++barred;
      const AxisPlan plan = PlanToAxis(With({rock}), options, start);
      const bool near =
          WheelsFrom(plan, half_track_m, rock) < kLimits.half_wheel_m + kLimits.beside_m - 0.01;
      EXPECT_EQ(plan.over_rock, near) << alpha_deg << " " << share;
      if (!near) ++clear;
    }
  }
  EXPECT_EQ(barred, 6);
  // The others lie within 1.3 m of the goal, or where the way bends: the body may not straddle
  // them, and no arc of the search goes round them.
  EXPECT_EQ(clear, 2);
}

TEST(RockCheck, TellsOfAPlanThatMustCrossARock) {
  std::vector<MappedRock> wall;
  for (double y = -4.0; y <= 4.0; y += 0.4) wall.push_back({2.2, y, 0.2, 0.3});
  const AxisPlan plan = PlanToAxis(With(wall), AxelOptions{}, At(4.0, 0.0, 0.0));
  EXPECT_TRUE(plan.over_rock);
  EXPECT_FALSE(plan.arcs.empty());
  EXPECT_TRUE(PlanOn(With(wall), AxelOptions{}, At(4.0, 0.0, 0.0)).arcs.empty());
}

TEST(RockCheck, RecoveriesTellWhetherTheyCrossARockBehind) {
  const AxelOptions options{};
  const Pose2 start{1.3, 0.15, kPi};
  const double half_track_m = 0.5 * TestNominal().track_m;
  const AxisPlan free = PlanRecovery(With({}), options, start);
  const Pose2 end = Advance(free.start, free.arcs);
  const Eigen::Vector2d wheel = end * Eigen::Vector2d(0.0, -half_track_m - 0.1);
  const MappedRock rock{wheel.x(), wheel.y(), 0.1, 0.14};
  ASSERT_LT(WheelsFrom(free, half_track_m, rock), kLimits.half_wheel_m);
  const AxisPlan plan = PlanRecovery(With({rock}), options, start);
  EXPECT_EQ(plan.over_rock,
            WheelsFrom(plan, half_track_m, rock) < kLimits.half_wheel_m + kLimits.beside_m - 0.01);
}

}  // namespace
}  // namespace dockyard::axel
