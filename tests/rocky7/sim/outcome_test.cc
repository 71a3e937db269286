#include "sim/rocky7/outcome.h"

#include <gtest/gtest.h>

namespace dockyard::rocky7 {
namespace {

Outcome Of(Verdict claimed, double point_off_m, double estimate_off_m, bool on_stone = false) {
  return JudgeEnd({claimed, point_off_m, estimate_off_m, on_stone}, {}).outcome;
}

TEST(Rocky7Outcome, TheTruthDecidesNotTheClaim) {
  EXPECT_EQ(Of(Verdict::kDocked, 0.009, 0.0), Outcome::kOnTarget);
  EXPECT_EQ(Of(Verdict::kDocked, 0.011, 0.0), Outcome::kOffTarget);
  EXPECT_EQ(Of(Verdict::kDocked, 0.031, 0.0), Outcome::kWrongLock);
  EXPECT_EQ(Of(Verdict::kGivenUp, 0.005, 0.0), Outcome::kUnstable);
  EXPECT_EQ(Of(Verdict::kGivenUp, 0.005, 0.04), Outcome::kLostTarget);
  EXPECT_EQ(Of(Verdict::kUnderWay, 0.005, 0.0), Outcome::kTimeout);
}

TEST(Rocky7Outcome, ARoverOnAStoneHasLeftTheModel) {
  EXPECT_EQ(Of(Verdict::kDocked, 0.001, 0.0, true), Outcome::kOnStone);
  EXPECT_EQ(Of(Verdict::kUnderWay, 1.0, 0.0, true), Outcome::kOnStone);
}

TEST(Rocky7Outcome, NamesOneSuccess) {
  int successes = 0;
  for (const OutcomeName& name : OutcomeNames()) successes += name.success;
  EXPECT_EQ(successes, 1);
  EXPECT_STREQ(Name(Outcome::kOnTarget), "on_target");
  EXPECT_STREQ(Name(Outcome::kTimeout), "timeout");
}

}  // namespace
}  // namespace dockyard::rocky7
