#include "sim/raposa/outcome.h"

#include <gtest/gtest.h>

#include <string>

namespace dockyard::raposa {
namespace {

/// The guide this far outside of its seat, doors this far open.
Truth At(double time_s, double outside_m, double doors_m) {
  Truth truth;
  truth.time_s = time_s;
  truth.p_SP_R = {-outside_m, 0.0, 0.0};
  truth.left_door_m = truth.right_door_m = doors_m;
  return truth;
}

void Hold(OutcomeJudge& judge, Truth truth, double seconds) {
  for (const double end = truth.time_s + seconds; truth.time_s <= end; truth.time_s += 0.1) {
    judge.Observe(truth);
  }
}

const Trial kFollows{true, 0.001}, kComesLoose{true, 0.2};

TEST(RaposaOutcome, ClaimHoldsWhenTheGuideFollowsItAway) {
  OutcomeJudge judge{OutcomeLimits{}};
  Hold(judge, At(30.0, 0.001, 0.006), 1.0);
  EXPECT_TRUE(judge.holds());
  EXPECT_EQ(judge.Conclude(Verdict::kDone, kFollows).outcome, Outcome::kDocked);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, kComesLoose).outcome, Outcome::kFalseDocked);
}

TEST(RaposaOutcome, OpenDoorsOrAGuideOutsideHoldNothing) {
  for (const Truth& truth : {At(30.0, 0.001, 0.03), At(30.0, 0.02, 0.006)}) {
    OutcomeJudge judge{OutcomeLimits{}};
    Hold(judge, truth, 1.0);
    EXPECT_FALSE(judge.holds());
    EXPECT_EQ(judge.Conclude(Verdict::kDone, {}).outcome, Outcome::kFalseDocked);
  }
}

TEST(RaposaOutcome, IsNeverDockedWithoutAClaim) {
  OutcomeJudge judge{OutcomeLimits{}};
  Hold(judge, At(30.0, 0.001, 0.006), 1.0);
  EXPECT_NE(judge.Conclude(Verdict::kUnderWay, kFollows).outcome, Outcome::kDocked);
  EXPECT_NE(judge.Conclude(Verdict::kGivenUp, kFollows).outcome, Outcome::kDocked);
}

TEST(RaposaOutcome, PyramidOnItsSideEndsTheRunAndNamesIt) {
  OutcomeJudge judge{OutcomeLimits{}};
  Truth truth = At(10.0, 0.5, 0.03);
  truth.pyramid_tilt_rad = Radians(80.0);
  Hold(judge, truth, 1.0);
  EXPECT_FALSE(judge.fatal()) << "it may still come back";
  truth.time_s = 11.1;
  Hold(judge, truth, 2.0);
  EXPECT_TRUE(judge.fatal());
  EXPECT_EQ(judge.Conclude(Verdict::kUnderWay, {}).outcome, Outcome::kTippedPyramid);
}

TEST(RaposaOutcome, GivingUpWithoutASearchIsNoSearchLimit) {
  OutcomeJudge judge{OutcomeLimits{}};
  Hold(judge, At(1.0, 0.6, 0.03), 1.0);
  EXPECT_EQ(judge.Conclude(Verdict::kGivenUp, {}, true).outcome, Outcome::kSearchLimit);
  EXPECT_EQ(judge.Conclude(Verdict::kGivenUp, {}, false).outcome, Outcome::kGaveUp);
  EXPECT_EQ(judge.Conclude(Verdict::kUnderWay, {}, false).outcome, Outcome::kTimeout);
}

TEST(RaposaOutcome, FailureIsNamedByWhatTheTruthShows) {
  const auto outcome = [](const Truth& truth, Verdict verdict = Verdict::kUnderWay) {
    OutcomeJudge judge{OutcomeLimits{}};
    Hold(judge, truth, 6.0);
    return judge.Conclude(verdict, {}).outcome;
  };
  EXPECT_EQ(outcome(At(10.0, 0.6, 0.03)), Outcome::kTimeout);
  EXPECT_EQ(outcome(At(10.0, 0.6, 0.03), Verdict::kGivenUp), Outcome::kSearchLimit);
  EXPECT_EQ(outcome(At(10.0, 0.03, 0.03)), Outcome::kJammed);
  Truth pushed = At(10.0, 0.2, 0.03);
  pushed.pyramid_shift_m = 0.08;
  EXPECT_EQ(outcome(pushed), Outcome::kPushedAway);
  Truth touched = At(10.0, 0.2, 0.03);
  touched.contact_n = 3.0;
  EXPECT_EQ(outcome(touched), Outcome::kMissedSocket);
}

double MarginOf(const OutcomeJudge& judge, Verdict claimed, const Trial& trial,
                const std::string& name) {
  for (const JudgedLimit& each : judge.Limits(claimed, trial)) {
    if (each.name == name) return each.margin();
  }
  ADD_FAILURE() << name;
  return 0.0;
}

TEST(RaposaOutcome, AClaimIsJudgedByGuideAndDoorsAndElseByThePyramid) {
  OutcomeJudge judge{OutcomeLimits{}};
  Truth truth = At(30.0, 0.001, 0.006);
  truth.pyramid_shift_m = 0.06;  // pushed, and docked
  Hold(judge, truth, 6.0);
  ASSERT_EQ(judge.Conclude(Verdict::kDone, kFollows).outcome, Outcome::kDocked);
  for (const JudgedLimit& each : judge.Limits(Verdict::kDone, kFollows)) {
    EXPECT_FALSE(each.margin() < 0.0) << each.name;
  }
  EXPECT_NEAR(MarginOf(judge, Verdict::kDone, kFollows, "trial_seat_m"), 0.004, 1e-12);
  EXPECT_NEAR(MarginOf(judge, Verdict::kDone, kComesLoose, "trial_seat_m"), -0.195, 1e-12);
  EXPECT_NEAR(MarginOf(judge, Verdict::kGivenUp, {}, "pyramid_shift_m"), -0.01, 1e-12);
  EXPECT_LT(MarginOf(judge, Verdict::kGivenUp, {}, "jam_s"), 0.0);
}

TEST(RaposaOutcome, AFalseClaimNamesTheLimitThatItMissed) {
  OutcomeJudge judge{OutcomeLimits{}};
  Hold(judge, At(30.0, 0.001, 0.03), 1.0);
  EXPECT_EQ(
      judge.Conclude(Verdict::kDone, {}).note,
      "claimed docked; door 30 mm (at most 12 mm); guide 1 mm outside of its seat, 0 mm aside "
      "and 0 mm above it");
}

TEST(RaposaOutcome, OnlyDockedIsASuccess) {
  for (const OutcomeName& name : OutcomeNames()) EXPECT_EQ(name.success, name.name == "docked");
}

}  // namespace
}  // namespace dockyard::raposa
