#include "sim/rocky7/outcome.h"

#include <gtest/gtest.h>

#include "controller/geometry/pose.h"

namespace dockyard::rocky7 {
namespace {

Outcome Of(Verdict claimed, double point_off_m, double estimate_off_m, bool on_stone = false) {
  EndOfRun end;
  end.claimed = claimed;
  end.point_off_m = point_off_m;
  end.estimate_off_m = estimate_off_m;
  end.on_stone = on_stone;
  return JudgeEnd(end, {}).outcome;
}

TEST(Rocky7Outcome, TheTruthDecidesNotTheClaim) {
  EXPECT_EQ(Of(Verdict::kDone, 0.009, 0.0), Outcome::kOnTarget);
  EXPECT_EQ(Of(Verdict::kDone, 0.011, 0.0), Outcome::kNearTarget);
  EXPECT_EQ(Of(Verdict::kDone, 0.031, 0.0), Outcome::kWrongLock);
  EXPECT_EQ(Of(Verdict::kGivenUp, 0.005, 0.0), Outcome::kUnstable);
  EXPECT_EQ(Of(Verdict::kGivenUp, 0.005, 0.04), Outcome::kLostTarget);
  EXPECT_EQ(Of(Verdict::kUnderWay, 0.005, 0.0), Outcome::kTimeout);
}

TEST(Rocky7Outcome, ATargetIsLostWhereItsLastDetectionIsFurtherOffThanTheBound) {
  EndOfRun end;
  end.claimed = Verdict::kGivenUp;
  end.estimate_off_m = 0.04;
  EXPECT_EQ(JudgeEnd(end, {}).outcome, Outcome::kLostTarget);
  EXPECT_EQ(JudgeEnd(end, {.lost_m = 0.041}).outcome, Outcome::kUnstable);
  EXPECT_EQ(JudgeEnd(end, {.lost_m = 0.039}).outcome, Outcome::kLostTarget);
}

TEST(Rocky7Outcome, GivingUpWithoutASightingIsSaidToBeThat) {
  EndOfRun end;
  end.claimed = Verdict::kGivenUp;
  end.point_off_m = 1.5;
  end.sighted = false;
  const Judged judged = JudgeEnd(end, {});
  EXPECT_EQ(judged.outcome, Outcome::kGaveUp);
  EXPECT_EQ(judged.note, "gave up; the target was not sighted, the point 1500 mm off the target");
}

TEST(Rocky7Outcome, ARoverOnAStoneHasLeftTheModel) {
  EXPECT_EQ(Of(Verdict::kDone, 0.001, 0.0, true), Outcome::kOnStone);
  EXPECT_EQ(Of(Verdict::kUnderWay, 1.0, 0.0, true), Outcome::kOnStone);
}

Outcome AfterGrasp(Verdict claimed, bool lifted, bool held, double point_off_m = 0.005) {
  EndOfRun end;
  end.claimed = claimed;
  end.grasps = true;
  end.tried = 1;
  end.lifted = lifted;
  end.rise_m = held ? 0.15 : 0.0;
  end.point_off_m = point_off_m;
  return JudgeEnd(end, {}).outcome;
}

TEST(Rocky7Outcome, AGraspIsCountedWhenTheStoneIsHeldNotWhenTheScoopsAreClosed) {
  EXPECT_EQ(AfterGrasp(Verdict::kDone, true, true), Outcome::kGrasped);
  EXPECT_EQ(AfterGrasp(Verdict::kDone, true, false), Outcome::kLostGrip);
  EXPECT_EQ(AfterGrasp(Verdict::kGivenUp, true, false), Outcome::kLostGrip);
  EXPECT_EQ(AfterGrasp(Verdict::kDone, false, false), Outcome::kFalseGrasp);
  EXPECT_EQ(AfterGrasp(Verdict::kGivenUp, false, false), Outcome::kMissedGrasp);
  EXPECT_EQ(AfterGrasp(Verdict::kDone, false, false, 0.05), Outcome::kWrongLock);
  EXPECT_EQ(AfterGrasp(Verdict::kGivenUp, false, false, 0.02), Outcome::kOffTarget);
  EXPECT_EQ(AfterGrasp(Verdict::kGivenUp, false, false, 0.05), Outcome::kWrongLock);
}

EndOfRun Touched(double off_m, double tilt_deg, double most_n) {
  EndOfRun end;
  end.claimed = Verdict::kDone;
  end.places = end.touched = true;
  end.point_off_m = off_m;
  end.tilt_rad = Radians(tilt_deg);
  end.most_n = most_n;
  return end;
}

TEST(Rocky7Outcome, APlacementIsJudgedByItsContact) {
  const OutcomeLimits limits{.reach_m = 0.02};
  const auto of = [&](const EndOfRun& end) { return JudgeEnd(end, limits).outcome; };
  EXPECT_EQ(of(Touched(0.019, 4.9, 9.9)), Outcome::kPlaced);
  EXPECT_EQ(of(Touched(0.021, 4.9, 9.9)), Outcome::kMisplaced);
  EXPECT_EQ(of(Touched(0.019, 5.1, 9.9)), Outcome::kTilted);
  EXPECT_EQ(of(Touched(0.019, 4.9, 10.1)), Outcome::kPressed);
  EXPECT_EQ(
      JudgeEnd(Touched(0.019, 5.1, 9.9), limits).note,
      "touched 19 mm off the target, 5.1 deg off its normal, by 9.9 N; tilt 5.1 deg (at most 5 "
      "deg)");
  EndOfRun none = Touched(0.019, 4.9, 0.0);
  none.touched = false;
  EXPECT_EQ(of(none), Outcome::kFalsePlace);
  EndOfRun unsaid = Touched(0.019, 4.9, 5.0);
  unsaid.claimed = Verdict::kUnderWay;
  EXPECT_EQ(of(unsaid), Outcome::kTimeout);
}

/// Whether all limits that are judged are kept.
bool AllKept(const EndOfRun& end, const OutcomeLimits& limits) {
  int judged = 0;
  for (const JudgedLimit& each : LimitsOf(end, limits)) {
    if (each.margin() < 0.0) return false;
    judged += each.margin() >= 0.0;
  }
  return judged > 0;
}

TEST(Rocky7Outcome, AClaimSucceedsExactlyWhereAllMarginsArePositive) {
  const OutcomeLimits limits{.reach_m = 0.02};
  for (const double off_m : {0.019, 0.021}) {
    for (const double tilt_deg : {4.9, 5.1}) {
      for (const double most_n : {9.9, 10.1}) {
        const EndOfRun end = Touched(off_m, tilt_deg, most_n);
        EXPECT_EQ(JudgeEnd(end, limits).outcome == Outcome::kPlaced, AllKept(end, limits));
      }
    }
    EndOfRun reach;
    reach.claimed = Verdict::kDone;
    reach.point_off_m = off_m;
    EXPECT_EQ(JudgeEnd(reach, limits).outcome == Outcome::kOnTarget, AllKept(reach, limits));
  }
  for (const double rise_m : {0.019, 0.021}) {
    EndOfRun grasp;
    grasp.claimed = Verdict::kDone;
    grasp.tried = 1;
    grasp.lifted = true;
    grasp.rise_m = rise_m;
    grasp.point_off_m = 0.1;  // is no limit of a grasp
    EXPECT_EQ(JudgeEnd(grasp, limits).outcome == Outcome::kGrasped, AllKept(grasp, limits));
  }
}

TEST(Rocky7Outcome, EachTaskAsksForASuccess) {
  for (const Task task : {Task::kReach, Task::kGrasp, Task::kPlace}) {
    EXPECT_TRUE(OutcomeNames()[static_cast<std::size_t>(SuccessOf(task))].success);
  }
  EXPECT_STREQ(Name(SuccessOf(Task::kGrasp)), "grasped");
}

TEST(Rocky7Outcome, NamesThreeSuccesses) {
  int successes = 0;
  for (const OutcomeName& name : OutcomeNames()) successes += name.success;
  EXPECT_EQ(successes, 3);
  EXPECT_STREQ(Name(Outcome::kOnTarget), "on_target");
  EXPECT_STREQ(Name(Outcome::kTimeout), "timeout");
}

}  // namespace
}  // namespace dockyard::rocky7
