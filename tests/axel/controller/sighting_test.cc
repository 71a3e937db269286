#include "controller/axel/sighting.h"

#include <gtest/gtest.h>

#include "axel/controller/kinematic_rover.h"

namespace dockyard::axel {
namespace {

using Ruling = SightingJudge::Ruling;

class Sightings : public testing::Test {
 protected:
  DockSighting From(double r, double alpha_deg, double h_deg) const {
    const Pose2 X_DR = FromDockingCoords({r, Radians(alpha_deg), Radians(h_deg)});
    return {Inverse(FromGround(X_DR, nominal_.wheel_radius_m)) * nominal_.X_DB, 1.0, 14, true};
  }

  const Nominal nominal_ = TestNominal();
  const AxelOptions options_{};
  Senses senses_{nominal_, options_};
  SightingJudge judge_{options_.look, nominal_.X_DB};
};

TEST_F(Sightings, TheFirstIsBelieved) {
  EXPECT_EQ(judge_.Judge(From(4, 10, 0), &senses_), Ruling::kAccepted);
  EXPECT_NEAR(ToDockingCoords(senses_.pose()).r, 4.0, 1e-6);
}

TEST_F(Sightings, AContradictionIsMeasuredAgain) {
  ASSERT_EQ(judge_.Judge(From(4, 10, 0), &senses_), Ruling::kAccepted);
  EXPECT_EQ(judge_.Judge(From(2, -20, 15), &senses_), Ruling::kLookAgain);
  EXPECT_NEAR(ToDockingCoords(senses_.pose()).r, 4.0, 1e-6);
}

TEST_F(Sightings, TwoThatAgreeOverruleOne) {
  ASSERT_EQ(judge_.Judge(From(4, 10, 0), &senses_), Ruling::kAccepted);
  judge_.Judge(From(2, -20, 15), &senses_);
  EXPECT_EQ(judge_.Judge(From(2.02, -20, 14), &senses_), Ruling::kAccepted);
  EXPECT_NEAR(ToDockingCoords(senses_.pose()).r, 2.02, 1e-6);
}

TEST_F(Sightings, TwoThatAgreeOverruleSeveral) {
  for (int i = 0; i < 3; ++i) ASSERT_EQ(judge_.Judge(From(4, 10, 0), &senses_), Ruling::kAccepted);
  judge_.Judge(From(2, -20, 15), &senses_);
  EXPECT_EQ(judge_.Judge(From(2.02, -20, 14), &senses_), Ruling::kAccepted);
  EXPECT_NEAR(ToDockingCoords(senses_.pose()).r, 2.02, 1e-6);
}

TEST_F(Sightings, OneAloneNeverOverrulesSeveral) {
  for (int i = 0; i < 3; ++i) ASSERT_EQ(judge_.Judge(From(4, 10, 0), &senses_), Ruling::kAccepted);
  EXPECT_EQ(judge_.Judge(From(2, -20, 15), &senses_), Ruling::kLookAgain);
  EXPECT_EQ(judge_.Judge(From(3, 30, -15), &senses_), Ruling::kRejected);
  judge_.NewStop();
  EXPECT_EQ(judge_.Judge(From(4, 10, 0), &senses_), Ruling::kAccepted);
}

TEST_F(Sightings, ABoardBehindTheRoverIsRejected) {
  EXPECT_EQ(judge_.Judge(From(4, 0, 180), &senses_), Ruling::kRejected);
  EXPECT_FALSE(senses_.filter().located());
}

TEST_F(Sightings, ABoardInTheFaceIsRejected) {
  EXPECT_EQ(judge_.Judge(From(0.2, 0, 0), &senses_), Ruling::kRejected);
}

TEST_F(Sightings, ExpectedBoardIsWhereItWasSeen) {
  const DockSighting seen = From(4, 10, 3);
  ASSERT_EQ(judge_.Judge(seen, &senses_), Ruling::kAccepted);
  const Pose3 expected = *HintsFrom(senses_).X_RB_expected;
  EXPECT_LT((expected.p - seen.X_RB.p).norm(), 1e-6);
  EXPECT_LT((expected.R - seen.X_RB.R).norm(), 1e-6);
}

}  // namespace
}  // namespace dockyard::axel
