// Rates and errors over the workspace, on images. The figures asserted leave room below what was
// measured (in brackets), so that a real loss shows and rounding does not.
#include "vision/survey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/base/random.h"

namespace dockyard {
namespace {

struct Tally {
  int pairs = 0, accepted = 0, wrong_marks = 0, far_off = 0;
  double rms_range_m = 0.0, rms_heading_rad = 0.0;
};

Tally Count(const std::vector<PoseSample>& pairs) {
  Tally tally{.pairs = static_cast<int>(pairs.size())};
  for (const PoseSample& sample : pairs) {
    if (!sample.out.sighting) continue;
    ++tally.accepted;
    tally.wrong_marks += sample.wrong_marks;
    if (sample.place_error_m > 0.05 + 0.05 * sample.at.r) ++tally.far_off;
    tally.rms_range_m += sample.range_error_m * sample.range_error_m;
    tally.rms_heading_rad += sample.heading_error_rad * sample.heading_error_rad;
  }
  if (tally.accepted > 0) {
    tally.rms_range_m = std::sqrt(tally.rms_range_m / tally.accepted);
    tally.rms_heading_rad = std::sqrt(tally.rms_heading_rad / tally.accepted);
  }
  return tally;
}

SurveyOptions At(int width) {
  SurveyOptions options{.width = width, .height = width * 3 / 4};
  options.arrange = [](SyntheticScene& scene, int) { scene.samples = 3; };
  return options;
}

void HardShadow(SyntheticScene& scene, int i) {
  RandomStream random(StreamKey(static_cast<std::uint64_t>(i), "shadow"));
  scene.samples = 3;
  scene.shadow = SyntheticScene::ShadowEdge{
      .through_B = {random.Uniform(-0.3, 0.3), random.Uniform(-0.15, 0.15)},
      .normal_rad = random.Uniform(0.0, 2.0 * kPi),
      .shade = random.Uniform(0.15, 0.35)};
}

void BrokenShade(SyntheticScene& scene, int) {
  scene.samples = 3;
  scene.speckle = 0.5;
}

TEST(Survey, FindsTheBoardInEvenLightAtFullSize) {
  const Tally tally = Count(Survey(At(1024), 30));
  EXPECT_GE(tally.accepted, 29);  // [30]
  EXPECT_EQ(tally.wrong_marks, 0);
  EXPECT_EQ(tally.far_off, 0);
}

TEST(Survey, FindsTheBoardInEvenLightAtHalfTheSize) {
  const Tally tally = Count(Survey(At(640), 40));
  EXPECT_GE(tally.accepted, 38);  // [40]
  EXPECT_EQ(tally.wrong_marks, 0);
  EXPECT_EQ(tally.far_off, 0);
}

TEST(Survey, FindsTheBoardUnderAHardShadow) {
  SurveyOptions options = At(1024);
  options.arrange = HardShadow;
  const Tally tally = Count(Survey(options, 30));
  EXPECT_GE(tally.accepted, 28);  // [30]
  EXPECT_EQ(tally.wrong_marks, 0);
  EXPECT_EQ(tally.far_off, 0);
}

TEST(Survey, FindsTheBoardInBrokenShade) {
  SurveyOptions options = At(1024);
  options.arrange = BrokenShade;
  const Tally tally = Count(Survey(options, 30));
  EXPECT_GE(tally.accepted, 28);  // [30]
  EXPECT_EQ(tally.wrong_marks, 0);
  EXPECT_EQ(tally.far_off, 0);
}

TEST(Survey, KeepsThePosesErrorBelowThePapersWithAMiscalibratedRig) {
  // Tsai et al., V-E: range 2.56, 4.12 and 20 cm at 1, 2 and 5 m; heading 2.5 and 4.58 deg at 1 and
  // 2 m. Theirs hold a fixed part of about 2.4 cm and 2.3 deg from aligning frames that is absent
  // here, so that only the part that grows with the square of the range is comparable:
  // 0.8, 3.2 and 20 cm.
  const double paper_m[3] = {0.008, 0.032, 0.20};
  const double ranges_m[3] = {1.0, 2.0, 5.0};
  for (int i = 0; i < 3; ++i) {
    SurveyOptions options = At(640);
    options.miscalibrated = true;
    options.r_min_m = options.r_max_m = ranges_m[i];
    const Tally tally = Count(Survey(options, 15));
    EXPECT_EQ(tally.accepted, 15);
    EXPECT_LT(tally.rms_range_m, paper_m[i]) << ranges_m[i] << " m";
    EXPECT_LT(tally.rms_heading_rad, Radians(1.0)) << ranges_m[i] << " m";
  }
}

TEST(Survey, SeesNoBoardWhereThereIsNone) {
  // 200 images: ground, stones, dark discs, and up to three stray fiducials.
  const StereoRig rig = TestRig(640, 480);
  for (int i = 0; i < 100; ++i) {
    SyntheticScene scene;
    scene.has_board = false;
    scene.samples = 2;
    scene.clutter_discs = i % 40;
    scene.clutter_fiducials = i % 4;
    scene.seed = static_cast<std::uint64_t>(5000 + i);
    scene.X_DR = RoverAt({2.0 + 0.04 * i, 0.0, 0.0}, Radians(0.2 * (i - 50)));
    const LocateOutput out = LocateBoard(SyntheticPair(scene, rig), rig, scene.board, {});
    EXPECT_FALSE(out.sighting) << "image pair " << i;
  }
}

}  // namespace
}  // namespace dockyard
