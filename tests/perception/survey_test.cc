// A small survey on rendered pairs. Limits leave room below what the long one measures
// (docs/results/perception.md), so that a real loss shows and rounding does not.
#include <gtest/gtest.h>

#include "perception/false_boards.h"
#include "perception/survey_run.h"

namespace dockyard::axel {
namespace {

SurveyTally TallyAt(Light light, int count, const VisionSettings& settings = {}) {
  YardOptions options{.light = light};
  YardViews views(options);
  SurveyTally tally;
  for (int i = 0; tally.in_view < count && i < 4 * count; ++i) {
    if (!views.Take(i, false).InView()) continue;
    const YardSample sample = views.Take(i);
    tally.Add(Score(sample, LocateBoard(sample.images, views.calibration(), views.board(),
                                        sample.hints, settings)));
  }
  return tally;
}

TEST(YardSurvey, FindsTheBoardInEvenLight) {
  const SurveyTally tally = TallyAt(Light::kEven, 30);
  ASSERT_EQ(tally.in_view, 30);
  EXPECT_GE(tally.accepted, 29);  // [30]
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_EQ(tally.wrong_marks, 0);
  EXPECT_LT(tally.plain_rms_px(), 0.03);  // [0.015]
  EXPECT_LT(tally.range_rms_m(), 0.012);  // [0.006]
  EXPECT_LT(tally.heading_rms_rad(), Radians(0.6));
  // Six degrees of freedom: a mean of 6 when the covariance matches the errors. Far more is
  // overconfidence, far less is excess caution.
  EXPECT_LT(tally.nees / tally.accepted, 12.0);
  EXPECT_GT(tally.nees / tally.accepted, 1.0);
}

TEST(YardSurvey, FindsTheBoardUnderAHardShadow) {
  const SurveyTally tally = TallyAt(Light::kHardShadow, 30);
  ASSERT_EQ(tally.in_view, 30);
  EXPECT_GE(tally.accepted, 28);  // [30]
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_EQ(tally.wrong_marks, 0);
  EXPECT_GT(tally.cut, 10);
  EXPECT_LT(tally.plain_rms_px(), 0.1);   // [0.050]
  EXPECT_LT(tally.cut_rms_px(), 0.2);     // [0.080]
  EXPECT_LT(tally.range_rms_m(), 0.015);  // [0.006]
}

TEST(YardSurvey, FindsTheSameWhateverTheNumberOfThreads) {
  SurveyPlan plan{.yard = {.light = Light::kHardShadow, .width = 640, .height = 480}, .count = 8};
  const std::vector<SampleScore> alone = RunSurvey(plan).dockyard.scores;
  plan.jobs = 3;
  const std::vector<SampleScore> shared = RunSurvey(plan).dockyard.scores;
  ASSERT_GE(alone.size(), 5u);
  ASSERT_EQ(alone.size(), shared.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(alone[i].index, shared[i].index);
    EXPECT_EQ(alone[i].range_error_m, shared[i].range_error_m);
    EXPECT_EQ(alone[i].plain_px2, shared[i].plain_px2);
    EXPECT_EQ(alone[i].nees, shared[i].nees);
  }
}

// Near the dock the paper's measure of its correspondence holds mainly the lens
// (docs/results/perception.md).
TEST(YardSurvey, NearTheDockTheLensFillsTheSeedsReprojection) {
  SurveyPlan plan{.yard = {.r_max_m = 2.0}, .count = 12, .tsai_count = 12};
  double raw_px = 0.0, linear_px = 0.0;
  int images = 0;
  for (const SampleScore& score : RunSurvey(plan).tsai2013.scores) {
    if (score.wrong_marks > 0) continue;
    for (const HomographySum& sum : score.homography) {
      if (sum.marks < 6) continue;
      raw_px += sum.raw_px;
      linear_px += sum.linear_px;
      ++images;
    }
  }
  ASSERT_GE(images, 6);
  EXPECT_GT(raw_px / images, 3.0);     // [9.4]; the paper's: 8.21 +- 2.4
  EXPECT_LT(linear_px / images, 1.0);  // [0.31]
}

TEST(YardSurvey, SeesNoBoardWhereThereIsNone) {
  const FalseBoards seen = LookWithoutBoard(100, 640, 1, 0);
  EXPECT_EQ(seen.views, 100);
  EXPECT_EQ(seen.accepted, 0);
}

}  // namespace
}  // namespace dockyard::axel
