#include "sim/log/belief_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

HistorySample Sample(const Pose2& truth, const Pose2& believed, bool located) {
  HistorySample sample;
  sample.X_DR = truth;
  sample.X_DR_believed = believed;
  sample.located = located;
  return sample;
}

TEST(BeliefError, IsBeliefMinusTruthInTheTargetsFrame) {
  const auto errors = BeliefErrors(Sample({2.0, -1.0, 0.1}, {2.25, -1.5, 0.1 + kPi / 6}, true));
  ASSERT_EQ(errors.size(), BeliefErrorColumns().size());
  EXPECT_DOUBLE_EQ(errors[0], 0.25);
  EXPECT_DOUBLE_EQ(errors[1], -0.5);
  EXPECT_NEAR(errors[2], 30.0, 1e-9);
}

TEST(BeliefError, OfTheHeightIsThatOfThePoseInSpace) {
  HistorySample sample = Sample({}, {}, true);
  sample.X_DR.X.p.z() = -4.0;
  sample.X_DR_believed.X.p.z() = -3.25;
  EXPECT_DOUBLE_EQ(BeliefErrors(sample).back(), 0.75);
}

TEST(BeliefError, OfTheHeadingIsTheShortTurn) {
  // 179 deg believed, -179 deg true: 2 deg to the right.
  const Pose2 truth{0, 0, Radians(-179.0)}, believed{0, 0, Radians(179.0)};
  EXPECT_NEAR(BeliefErrors(Sample(truth, believed, true))[2], -2.0, 1e-9);
}

TEST(BeliefError, IsNoneWhileTheRobotIsNotLocated) {
  for (const double error : BeliefErrors(Sample({1, 2, 3}, {}, false))) {
    EXPECT_TRUE(std::isnan(error));
  }
}

}  // namespace
}  // namespace dockyard
