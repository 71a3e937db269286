#include "controller/axel/planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/grid.h"
#include "axel/controller/kinematic_rover.h"
#include "controller/axel/leg.h"

namespace dockyard::axel {
namespace {

using testing::DoubleNear;

class Planner : public testing::Test {
 protected:
  const Nominal nominal_ = TestNominal();
  const PlanGeometry geometry_ = PlanGeometryOf(nominal_);
  const AxelOptions options_{};
};

Pose2 At(double r, double alpha_deg, double h_deg) {
  return FromDockingCoords({r, Radians(alpha_deg), Radians(h_deg)});
}

TEST_F(Planner, KnowsTheLens) {
  // Half a pixel on either side of 1024 spread over 90 deg.
  EXPECT_THAT(Degrees(geometry_.half_view_rad), DoubleNear(45.0, 0.1));
}

TEST_F(Planner, TipLeadsByTheArm) {
  const TipPlace tip = TipOf(geometry_, {1.3, 0.1, kPi});
  EXPECT_THAT(tip.gap_m, DoubleNear(0.3, 1e-12));
  EXPECT_THAT(tip.offset_m, DoubleNear(0.1, 1e-12));
}

TEST_F(Planner, BoardLiesAtAlphaLessHeading) {
  EXPECT_THAT(Degrees(BoardBearing(geometry_, At(5.0, 20.0, 5.0))), DoubleNear(15.0, 0.3));
}

TEST_F(Planner, SeesTheBoardOfTheTypicalRun) {
  EXPECT_TRUE(SeesBoard(geometry_, options_.look, At(4.0, 15.0, 0.0)));
}

TEST_F(Planner, LosesTheBoardBeyondTheLens) {
  EXPECT_FALSE(SeesBoard(geometry_, options_.look, At(4.0, 40.0, -10.0)));
}

TEST_F(Planner, EveryGridStartHasAPlanToTheAxis) {
  for (const GridStart& start : MarsYardGrid()) {
    const Pose2 X_DR = FromDockingCoords(start.at);
    const Pose2 end = Advance(X_DR, PlanToAxis(geometry_, options_, X_DR).arcs);
    EXPECT_THAT(end.x, DoubleNear(geometry_.arm_m + options_.plan.align_gap_m, 1e-5)) << start.run;
    EXPECT_THAT(end.y, DoubleNear(0.0, 1e-5)) << start.run;
    EXPECT_THAT(WrapPi(end.heading - kPi), DoubleNear(0.0, 1e-5)) << start.run;
  }
}

TEST_F(Planner, GoesForwardsOnlyWhenThereIsRoom) {
  const auto plan = PlanToAxis(geometry_, options_, At(4.0, 15.0, 0.0)).arcs;
  for (const Arc& arc : plan) EXPECT_GE(arc.length_m, 0.0);
}

TEST_F(Planner, BacksOffFirstWhenTooNearForTheAngle) {
  EXPECT_LT(PlanToAxis(geometry_, options_, At(2.0, 40.0, 0.0)).arcs.front().length_m, 0.0);
}

// A way back may begin with a sharp turn.
TEST_F(Planner, KeepsANewPlanToWiderArcsThanItsRest) {
  for (const GridStart& start : MarsYardGrid()) {
    const Pose2 X_DR = FromDockingCoords(start.at);
    for (const Arc& arc : PlanToAxis(geometry_, options_, X_DR).arcs) {
      const bool back = arc.length_m < 0.0;
      const double most = back ? options_.plan.max_recover_curvature : options_.plan.max_curvature;
      EXPECT_LE(std::abs(arc.turn_rad), most * std::abs(arc.length_m) + 1e-9);
    }
  }
}

// The belief is 5 cm aside at the end of a leg on sand, in the median.
TEST_F(Planner, GoesOnForwardsFromFiveCentimetresAsideAfterAnyFirstLegOfTheGrid) {
  for (const GridStart& start : MarsYardGrid()) {
    for (const double aside_m : {-0.05, 0.05}) {
      const Pose2 X_DR = FromDockingCoords(start.at);
      const Decision first = Decide(geometry_, options_, X_DR);
      const Pose2 then = Advance(X_DR, first.leg) * Pose2{0.0, aside_m, 0.0};
      const Decision second = Decide(geometry_, options_, then, {.under_way = true});
      EXPECT_NE(second.event, Event::kGoBackOff) << start.run;
    }
  }
}

TEST_F(Planner, BacksOffFurtherEachTime) {
  const Pose2 X_DR = At(2.0, 40.0, 0.0);
  double last_m = 0.0;
  for (int back_offs = 0; back_offs < 4; ++back_offs) {
    const auto plan = PlanToAxis(geometry_, options_, X_DR, {.back_offs = back_offs}).arcs;
    const double back_m = Length(WayBack(plan));
    EXPECT_GE(back_m, options_.plan.back_step_m * (0.5 + back_offs));
    EXPECT_GE(back_m, last_m);
    last_m = back_m;
  }
}

TEST_F(Planner, NeverBacksOffToTheSamePlaceTwice) {
  for (const Pose2& X_DR : {At(2.0, 40.0, 0.0), At(2.5, -35.0, 20.0), At(1.8, 10.0, -25.0)}) {
    PlanHistory history;
    for (int i = 0; i < 3; ++i) {
      const auto plan = PlanToAxis(geometry_, options_, X_DR, history);
      if (plan.arcs.front().length_m >= 0.0) break;
      const Pose2 end = Advance(plan.start, WayBack(plan.arcs));
      EXPECT_FALSE(history.BackedTo(end)) << i;
      history.backed_to.push_back(end);
      ++history.back_offs;
    }
  }
}

// The leg's end 5 cm to a side, ten times the filter's error, at every stop of a run. One rest of
// them brings the tether too far abeam.
TEST_F(Planner, GoesOnForwardsFromFiveCentimetresAsideAtTheEndOfEveryLegOfTheGrid) {
  int back_offs = 0, stops = 0;
  for (const GridStart& start : MarsYardGrid()) {
    for (const double aside_m : {-0.05, 0.05}) {
      Pose2 X_DR = FromDockingCoords(start.at);
      PlanHistory history;
      for (int leg = 0; leg < 12; ++leg) {
        const Decision decision = Decide(geometry_, options_, X_DR, history);
        if (decision.event == Event::kGoMate || decision.event == Event::kGoRecover) break;
        if (leg > 0) ++stops;
        if (history.under_way && decision.event == Event::kGoBackOff) {
          ++back_offs;
          const double beyond_m = PlanOn(geometry_, options_, X_DR).beyond_m;
          EXPECT_GT(beyond_m, options_.plan.rest_beyond_m) << start.run;
        }
        X_DR = Advance(decision.plan.start, decision.leg) * Pose2{0.0, aside_m, 0.0};
        history.under_way = true;
      }
    }
  }
  EXPECT_GT(stops, 80);
  EXPECT_LE(back_offs, 1);
}

TEST_F(Planner, SeesTheBoardAtTheEndOfEveryLegOfTheGrid) {
  for (const GridStart& start : MarsYardGrid()) {
    const Pose2 X_DR = FromDockingCoords(start.at);
    const Decision decision = Decide(geometry_, options_, X_DR);
    EXPECT_TRUE(SeesBoard(geometry_, options_.look, Advance(X_DR, decision.leg))) << start.run;
  }
}

TEST_F(Planner, LegsAreTheBeginningOfThePlan) {
  const Pose2 X_DR = At(5.0, 10.0, 0.0);
  const Decision decision = Decide(geometry_, options_, X_DR);
  EXPECT_LT(Length(decision.leg), Length(decision.plan.arcs));
  EXPECT_EQ(Truncate(decision.plan.arcs, Length(decision.leg)), decision.leg);
}

TEST_F(Planner, MatesFromTheAlignmentGoal) {
  EXPECT_EQ(Decide(geometry_, options_, {1.3, 0.0, kPi}).event, Event::kGoMate);
}

// 6 cm before the mouth 9 cm of way are left: nearly what it has then, it enters with.
TEST_F(Planner, RecoversWhenTheHeadingAtTheMouthIsBeyondFiveDegrees) {
  EXPECT_EQ(Decide(geometry_, options_, {1.06, 0.0, kPi + Radians(7.0)}).event, Event::kGoRecover);
  EXPECT_EQ(Decide(geometry_, options_, {1.06, 0.0, kPi - Radians(7.0)}).event, Event::kGoRecover);
}

TEST_F(Planner, RecoversWhenItCannotSteerBackOnTheWayThatIsLeft) {
  EXPECT_EQ(Decide(geometry_, options_, At(1.3, 0.0, 5.5)).event, Event::kGoMate);
  EXPECT_EQ(Decide(geometry_, options_, At(1.15, 0.0, 20.0)).event, Event::kGoRecover);
  EXPECT_EQ(Decide(geometry_, options_, At(1.15, 0.0, -20.0)).event, Event::kGoRecover);
}

TEST_F(Planner, AcceptsTheHeadingWithinFiveDegreesIfTheTipMeetsTheMouth) {
  // Heading 4 deg with the axle where the arm points into the mouth.
  EXPECT_EQ(Decide(geometry_, options_, At(1.3, 3.0, 3.0)).event, Event::kGoMate);
}

// Beside the station, facing as it should: nothing went wrong on the way there.
TEST_F(Planner, BacksOffRatherThanRecoversFarBesideTheMouth) {
  EXPECT_EQ(Decide(geometry_, options_, {1.33, 1.22, WrapPi(kPi + Radians(17.0))}).event,
            Event::kGoBackOff);
}

TEST_F(Planner, RecoversWhenTheTipWouldMissTheMouth) {
  EXPECT_EQ(Decide(geometry_, options_, {1.3, 0.12, kPi}).event, Event::kGoRecover);
}

TEST_F(Planner, RecoveryEndsOnTheAxisAtTheRecoveryGoalFartherOutEachTime) {
  const Pose2 X_DR{1.28, 0.11, WrapPi(kPi + Radians(7.0))};
  for (int before = 0; before < 4; ++before) {
    const auto plan = PlanRecovery(geometry_, options_, X_DR, {.recoveries = before});
    const Pose2 end = Advance(plan.start, plan.arcs);
    const double gap_m = options_.plan.recover_gap_m + before * options_.plan.recover_step_m;
    EXPECT_THAT(end.x, DoubleNear(1.0 + gap_m, 1e-9));
    EXPECT_THAT(end.y, DoubleNear(0.0, 1e-9));
    for (const Arc& arc : plan.arcs) EXPECT_LE(arc.length_m, 0.0);
  }
}

TEST_F(Planner, RecoveryFromFartherOutThanItsGoalGoesBackByAStep) {
  const Pose2 X_DR{3.0, 0.02, kPi};
  for (int before = 0; before < 4; ++before) {
    const auto plan = PlanRecovery(geometry_, options_, X_DR, {.recoveries = before});
    const double way_m = options_.plan.back_step_m + before * options_.plan.recover_step_m;
    EXPECT_THAT(Advance(plan.start, plan.arcs).x, DoubleNear(X_DR.x + way_m, 1e-9));
    EXPECT_THAT(Length(plan.arcs), DoubleNear(way_m, 0.01));
  }
}

// Backwards it keeps its course with the nose on the other side of it than forwards.
TEST_F(Planner, RecoveryOfARoverThatDriftsEndsSquareToTheStation) {
  const Drift drift{-0.06, -0.08};
  const AxisPlan plan = PlanRecovery(geometry_, options_, {1.2, 0.02, kPi}, {}, drift);
  const Pose2 end = Advance(plan.start, plan.arcs);
  EXPECT_THAT(WrapPi(end.heading + std::atan(drift.at_dock) - kPi), DoubleNear(0.0, 1e-9));
  const Pose2 line = MouthLineAt(geometry_, options_.mate, end.x, drift.at_dock);
  EXPECT_THAT(end.y, DoubleNear(line.y, 1e-9));
}

TEST_F(Planner, RecoveryFromTheConeComesOutStraightFirst) {
  const auto plan = PlanRecovery(geometry_, options_, {0.9, 0.02, kPi}).arcs;
  EXPECT_EQ(plan.front().turn_rad, 0.0);
  EXPECT_THAT(plan.front().length_m, DoubleNear(-0.25, 1e-9));
}

TEST_F(Planner, SocketAngleIsATrailersAngleAfterTheDepth) {
  // psi' = -sin(psi)/L for a tip on the axis and an axle that does not scrub: exp(-0.25) = 0.78.
  double psi = std::asin(0.08);
  const double step = 1e-5;
  for (double s = 0.0; s < 0.25; s += step) psi -= std::sin(psi) * step;
  EXPECT_THAT(SocketAngle(geometry_, 0.08), DoubleNear(psi, 1e-4));
}

TEST_F(Planner, MirroredStartHasTheMirroredPlan) {
  const auto left = PlanToAxis(geometry_, options_, At(3.3, 32.0, 7.0)).arcs;
  const auto right = PlanToAxis(geometry_, options_, At(3.3, -32.0, -7.0)).arcs;
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_THAT(left[i].length_m, DoubleNear(right[i].length_m, 1e-9));
    EXPECT_THAT(left[i].turn_rad, DoubleNear(-right[i].turn_rad, 1e-9));
  }
}

// At its last legs a plan may end with the axle aside, yet so that the arm will seat.
TEST_F(Planner, RestsEndWhereTheRoverCanMate) {
  int plans = 0;
  for (double y_m = 0.1; y_m < 0.5; y_m += 0.02) {
    for (double heading_deg = 10.0; heading_deg < 60.0; heading_deg += 5.0) {
      const Pose2 X_DR{1.75, y_m, WrapPi(kPi + Radians(heading_deg))};
      const AxisPlan on = PlanOn(geometry_, options_, X_DR);
      if (on.arcs.empty()) continue;
      ++plans;
      const Pose2 end = Advance(on.start, on.arcs);
      EXPECT_TRUE(CanMate(geometry_, options_, end, 0.0)) << y_m << " " << heading_deg;
    }
  }
  EXPECT_GT(plans, 30);
}

// Facing the station squarely, pushed aside by a tenth of the way.
TEST_F(Planner, MouthLineIsTheWayOfARoverThatDrifts) {
  for (const double drift : {-0.1, 0.0, 0.1}) {
    Pose2 at = MouthLineAt(geometry_, options_.mate, 1.3, drift);
    at.heading = kPi;
    for (int i = 0; i < 330; ++i)
      at = Advance(at, Arc{0.001, 0.0}) * Pose2{0.0, 0.001 * drift, 0.0};
    EXPECT_THAT(at.x, DoubleNear(1.0 + options_.mate.enter_gap_m, 1e-9));
    EXPECT_THAT(at.y, DoubleNear(0.0, 1e-9));
  }
}

// It drifts more on the last 0.45 m.
TEST_F(Planner, MouthLineIsTheWayOfARoverThatHasLearnedItsDriftThere) {
  PlanGeometry geometry = geometry_;
  for (const double learned : {-0.1, 0.1}) {
    geometry.mouth_drift = learned;
    for (const double from_m : {1.3, 1.8}) {
      Pose2 at = MouthLineAt(geometry, options_.mate, from_m, 0.05);
      at.heading = kPi;
      const double end_m = 1.0 + options_.mate.enter_gap_m;
      while (at.x > end_m + 1e-9) {
        const bool last = at.x - end_m <= options_.mate.learned_way_m + 1e-9;
        const double drift = 0.05 + (last ? learned : 0.0);
        at = Advance(at, Arc{0.001, 0.0}) * Pose2{0.0, 0.001 * drift, 0.0};
      }
      EXPECT_THAT(at.y, DoubleNear(0.0, 1e-9)) << from_m << " " << learned;
    }
  }
}

TEST_F(Planner, RoverThatLearnedItsDriftReckonsWithIt) {
  PlanGeometry geometry = geometry_;
  const Pose2 X_DR{1.4, 0.03, kPi};
  const double without_m = AfterMouthLine(geometry, options_, X_DR, 0.0).y;
  geometry.mouth_drift = 0.1;
  EXPECT_LT(AfterMouthLine(geometry, options_, X_DR, 0.0).y, without_m - 0.02);
}

// Without slip the tip's offset dies out as exp(-l/s), whatever the axle's heading and drift.
TEST_F(Planner, TipIsSteeredToTheAxis) {
  const Steering steering{.settle_m = 0.15, .max_turn_rad_s = 1.0};
  const double speed_m_s = 0.03, step_m = 1e-5;
  for (const double drift : {-0.1, 0.0, 0.1}) {
    for (const double heading_deg : {-6.0, 0.0, 4.0}) {
      Pose2 at{1.4, 0.03, WrapPi(kPi + Radians(heading_deg))};
      const double before_m = TipOf(geometry_, at).offset_m;
      for (int i = 0; i < 30'000; ++i) {
        const double turn = TurnForTip(1.0, at, speed_m_s, drift, steering);
        at = Advance(at, Arc{step_m, turn * step_m / speed_m_s}) * Pose2{0.0, drift * step_m, 0.0};
      }
      EXPECT_THAT(TipOf(geometry_, at).offset_m, DoubleNear(before_m * std::exp(-2.0), 2e-5))
          << drift << " " << heading_deg;
    }
  }
}

// A tip on the axis stays there, and the axle follows it as a trailer: psi' = -sin(psi) / L.
TEST_F(Planner, AxleFollowsTheTipLikeATrailer) {
  const double psi = Radians(4.0);
  const Pose2 start{1.4 * std::cos(psi), std::sin(psi), WrapPi(kPi + psi)};
  ASSERT_THAT(TipOf(geometry_, start).offset_m, DoubleNear(0.0, 1e-12));
  Pose2 at = start;
  const Steering steering{.settle_m = 0.15, .max_turn_rad_s = 1.0};
  for (int i = 0; i < 30'000; ++i)
    at = Advance(at, Arc{1e-5, TurnForTip(1.0, at, 0.03, 0.0, steering) * 1e-5 / 0.03});
  EXPECT_THAT(WrapPi(at.heading - kPi), DoubleNear(psi * std::exp(-0.3), 1e-4));
}

// The most thrust on the way forwards, over the weight: rolling and climbing less the tether's
// pull.
double MostThrust(const AxisPlan& plan, const PlanGeometry& geometry, const AxelOptions& options,
                  double downhill_y) {
  Pose2 at = plan.start;
  double most = -1.0;
  for (const Arc& arc : plan.arcs) {
    for (int i = 1; i <= 50 && arc.length_m > 0.0; ++i) {
      const Pose2 here = Advance(at, Part(arc, i / 50.0));
      const double aside = std::abs(TetherAngle(geometry, here));
      const double pull_n = TensionAside(options.tether, aside) * std::cos(aside);
      most = std::max(most, 0.05 - downhill_y * std::sin(here.heading) - pull_n / 390.0);
    }
    at = Advance(at, arc);
  }
  return most;
}

// Arm 4 kg at 0.5 m, 12 deg below the level, body 24 kg 0.04 m behind the axle, wheels of 0.3 m,
// 40 kg in all: 0.083 of the weight lifts the arm.
TEST_F(Planner, KeepsTheArmDownOnTheWayUphill) {
  const double lifts = (4.0 * 0.5 * std::cos(Radians(12.0)) - 24.0 * 0.04) / 0.3 / 40.0;
  const double downhill_y = std::sin(Radians(4.5));
  for (const Pose2& X_DR : {Pose2{1.85, 1.41, Radians(-149.0)}, Pose2{2.54, 1.75, Radians(-157.0)},
                            Pose2{3.0, 2.0, Radians(-150.0)}}) {
    const AxisPlan level = PlanToAxis(geometry_, options_, X_DR);
    const AxisPlan uphill =
        PlanToAxis(geometry_, options_, X_DR, {}, {.here = 0.0, .downhill_y = downhill_y});
    EXPECT_GT(MostThrust(level, geometry_, options_, downhill_y), lifts);
    EXPECT_LT(MostThrust(uphill, geometry_, options_, downhill_y), 0.85 * lifts);
  }
}

// From nearly the same place, as the way forwards would lift the arm.
TEST_F(Planner, GoesUphillBackwards) {
  const Pose2 X_DR{1.85, 1.41, Radians(-149.0)};
  const AxisPlan plan = PlanToAxis(geometry_, options_, X_DR, {},
                                   {.here = 0.0, .downhill_y = std::sin(Radians(4.5))});
  const std::vector<Arc> back = WayBack(plan.arcs);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[1].turn_rad, 0.0);
  EXPECT_LT(Advance(plan.start, back).y, X_DR.y - 0.5);
}

TEST_F(Planner, MouthLineIsKeptByARoverThatDriftsAsTold) {
  const double drift = -0.08;
  Pose2 at = MouthLineAt(geometry_, options_.mate, 1.3, drift);
  at.heading = kPi;
  const Pose2 end = AfterMouthLine(geometry_, options_, at, drift);
  EXPECT_THAT(end.y, DoubleNear(0.0, 0.002));
  EXPECT_THAT(WrapPi(end.heading - kPi), DoubleNear(0.0, 0.005));
}

TEST_F(Planner, PlansForTheCourseNotTheHeadingOfARoverThatDrifts) {
  const Pose2 X_DR = At(4.0, 15.0, 0.0);
  const AxisPlan plan = PlanToAxis(geometry_, options_, X_DR, {}, {.here = 0.1, .at_dock = -0.05});
  EXPECT_THAT(WrapPi(plan.start.heading - X_DR.heading), DoubleNear(std::atan(0.1), 1e-12));
  const Pose2 end = Advance(plan.start, plan.arcs),
              goal = MouthLineAt(geometry_, options_.mate,
                                 geometry_.arm_m + options_.plan.align_gap_m, -0.05);
  EXPECT_THAT(std::hypot(end.x - goal.x, end.y - goal.y), DoubleNear(0.0, 1e-9));
  EXPECT_THAT(WrapPi(end.heading - goal.heading), DoubleNear(0.0, 1e-9));
}

}  // namespace
}  // namespace dockyard::axel
