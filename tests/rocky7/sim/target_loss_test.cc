#include "sim/rocky7/target_loss.h"

#include <gtest/gtest.h>

namespace dockyard::rocky7 {
namespace {

// A target a metre ahead, with no other stone, of which nothing is detected.
LossTruth Alone() {
  return {.p_ET = {1.0, 0.0},
          .target_radius_m = 0.02,
          .window_m = 0.06,
          .predicted_E = Eigen::Vector2d(1.0, 0.0)};
}

TEST(TargetLoss, WithoutAnyOtherCauseItIsTheRangeData) {
  EXPECT_EQ(CauseOf(Alone()), Loss::kNoRange);
}

TEST(TargetLoss, IsOdometrysExactlyWhereTheTargetIsOutsideTheWindow) {
  LossTruth truth = Alone();
  truth.predicted_E = Eigen::Vector2d(1.0 - 0.059, 0.059);  // a square has both
  EXPECT_EQ(CauseOf(truth), Loss::kNoRange);
  truth.predicted_E = Eigen::Vector2d(1.0, 0.061);
  EXPECT_EQ(CauseOf(truth), Loss::kOdometry);
  truth.predicted_E = Eigen::Vector2d(1.0 - 0.061, 0.0);
  EXPECT_EQ(CauseOf(truth), Loss::kOdometry);
  truth.predicted_E.reset();
  EXPECT_EQ(CauseOf(truth), Loss::kNoRange);
}

TEST(TargetLoss, IsAnotherTargetsWhereThatOneIsNearerToTheDetectionAndInTheWindow) {
  LossTruth truth = Alone();
  truth.detected_E = Eigen::Vector2d(1.05, 0.0);  // 3 cm from the target's outline
  truth.others_E = {{{1.1, 0.0}, 0.021}};         // 2.9 cm; from 1.079 m, the window ends at 1.06
  EXPECT_EQ(CauseOf(truth), Loss::kNoRange);
  truth.others_E[0].radius_m = 0.041;
  EXPECT_EQ(CauseOf(truth), Loss::kSeveralTargets);
  truth.detected_E = Eigen::Vector2d(1.0, -0.05);
  EXPECT_EQ(CauseOf(truth), Loss::kNoRange);
  truth.detected_E.reset();
  EXPECT_EQ(CauseOf(truth), Loss::kNoRange);
}

TEST(TargetLoss, IsAnotherTargetsWhereABoulderWasDetectedElsewhere) {
  LossTruth truth = Alone();
  truth.on_boulder = true;
  EXPECT_EQ(CauseOf(truth), Loss::kSeveralTargets);
}

TEST(TargetLoss, IsTheColoursWithinFivePercentOfTheGrounds) {
  LossTruth truth = Alone();
  for (const double share : {0.951, 1.049}) {
    truth.albedo_share = share;
    EXPECT_EQ(CauseOf(truth), Loss::kColour);
  }
  for (const double share : {0.949, 1.051}) {
    truth.albedo_share = share;
    EXPECT_EQ(CauseOf(truth), Loss::kNoRange);
  }
}

// All hold at once; each is taken away in turn.
TEST(TargetLoss, HasTheFirstCauseInTheStatedOrder) {
  LossTruth truth = Alone();
  truth.in_view = false;
  truth.predicted_E = Eigen::Vector2d(1.2, 0.0);
  truth.detected_E = Eigen::Vector2d(1.2, 0.0);
  truth.others_E = {{{1.2, 0.0}, 0.02}, {{1.05, 0.0}, 0.01}};
  truth.albedo_share = 1.0;
  EXPECT_EQ(CauseOf(truth), Loss::kFieldOfView);
  truth.in_view = true;
  EXPECT_EQ(CauseOf(truth), Loss::kOdometry);
  truth.predicted_E = truth.p_ET;
  EXPECT_EQ(CauseOf(truth), Loss::kSeveralTargets);
  truth.others_E.clear();
  EXPECT_EQ(CauseOf(truth), Loss::kColour);
}

TEST(TargetLoss, IsThatOfTheFirstImagePairOfTheLastLoss) {
  LossRecord record;
  EXPECT_FALSE(record.loss());
  record.Lost(Loss::kOdometry);
  record.Lost(Loss::kColour);
  EXPECT_EQ(record.loss(), Loss::kOdometry);
  EXPECT_FALSE(record.has_target());
  record.Found();
  EXPECT_EQ(record.loss(), Loss::kNone);
  record.Lost(Loss::kColour);
  EXPECT_EQ(record.loss(), Loss::kColour);
}

}  // namespace
}  // namespace dockyard::rocky7
