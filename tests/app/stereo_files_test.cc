// Files of `dockyard stereo`, without the program around them.
#include "sim/app/stereo_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/app/stereo_truth.h"
#include "sim/images/deep_png.h"
#include "sim/images/pfm.h"
#include "sim/images/png.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

const float kNone = std::nanf("");

TEST(DisparityFiles, HoldAHundredthOfAPixelUpToWhatSixteenBitsHold) {
  const ScratchFolder folder;
  const std::string file = folder.path() / "d.png";
  const Disparities disparities{2, 2, {0.25F, 255.99F, kNone, 40.126F}};
  WriteDisparities(file, disparities);
  const auto image = DeepFromPng(Slurp(file));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->pixels, (std::vector<std::uint16_t>{64, 65533, 0, 10272}));
  const Disparities read = LoadTruth(file, 2, 2);
  EXPECT_FLOAT_EQ(read.px[3], 40.125F);
  EXPECT_TRUE(std::isnan(read.px[2]));
}

TEST(DisparityFiles, RefuseALargerOneAndHoldItAsAFloat) {
  const ScratchFolder folder;
  const Disparities large{2, 1, {300.0F, kNone}};
  const std::string png = folder.path() / "d.png", pfm = folder.path() / "d.PFM";
  const std::string message = MessageOf([&] { WriteDisparities(png, large); }, folder);
  EXPECT_THAT(message, HasSubstr("found 300.00 px"));
  EXPECT_THAT(message, HasSubstr("--disparity"));
  EXPECT_THAT(message, HasSubstr("d.pfm"));
  EXPECT_FALSE(std::filesystem::exists(png));
  WriteDisparities(pfm, large);
  EXPECT_EQ(LoadTruth(pfm, 2, 1).px[0], 300.0F);
  EXPECT_TRUE(std::isnan(LoadTruth(pfm, 2, 1).px[1]));
}

TEST(Truth, OfEightBitsHasWholePixels) {
  const ScratchFolder folder;
  const std::string file = folder.Write("t.png", EncodePng(GrayImage{2, 1, {0, 200}}));
  const Disparities truth = LoadTruth(file, 2, 1);
  EXPECT_TRUE(std::isnan(truth.px[0]));
  EXPECT_EQ(truth.px[1], 200.0F);
  EXPECT_THAT(MessageOf([&] { LoadTruth(file, 2, 2); }, folder),
              HasSubstr("2 x 2 px, found 2 x 1"));
  const std::string colour = folder.Write("c.png", EncodePng(RgbImage{1, 1, {1, 2, 3}}));
  EXPECT_THAT(MessageOf([&] { LoadTruth(colour, 1, 1); }, folder), HasSubstr("a grey PNG"));
}

// By hand: errors of 0.5, 1.5 and 5 px; one pixel not found, one without a truth.
TEST(StereoScore, CountsWhatIsOff) {
  const Disparities found{5, 1, {10.5F, 11.5F, 15.0F, kNone, 7.0F}};
  const Disparities truth{5, 1, {10.0F, 10.0F, 10.0F, 10.0F, kNone}};
  const StereoScore score = ScoreOf(found, truth);
  EXPECT_EQ(score.truths, 4);
  EXPECT_DOUBLE_EQ(score.density(), 0.75);
  EXPECT_DOUBLE_EQ(score.bad_1, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.bad_2, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.bad_4, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.rms_px, std::sqrt((0.25 + 2.25 + 25.0) / 3.0));
  EXPECT_DOUBLE_EQ(score.median_px, 1.5);
}

// u = 3, v = 1, d = 4 of a pair with f = 100, centre (1, 1), baseline 0.2 m: 5 m away, 0.1 m aside.
TEST(PointsPly, HasAPixelsPointInTheRigsFrame) {
  RectifiedPair pair;
  pair.width = 4;
  pair.height = 2;
  pair.focal_px = 100.0;
  pair.centre_px = {1.0, 1.0};
  pair.baseline_m = 0.2;
  pair.X_RC.p = {10.0, 0.0, 0.0};
  Disparities disparities{4, 2, std::vector<float>(8, kNone)};
  disparities.px[7] = 4.0F;
  const GrayImage left{4, 2, {0, 0, 0, 0, 0, 0, 0, 77}};
  const std::string ply = PointsPly(pair, disparities, left);
  EXPECT_THAT(ply, HasSubstr("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(ply, HasSubstr("element vertex 1\n"));
  const std::string point = ply.substr(ply.find("end_header\n") + 11);
  // 10.1, 0, 5 as floats, and three bytes of 77.
  EXPECT_EQ(point, std::string("\x9a\x99\x21\x41\x00\x00\x00\x00\x00\x00\xa0\x40MMM", 15));
}

}  // namespace
}  // namespace dockyard
