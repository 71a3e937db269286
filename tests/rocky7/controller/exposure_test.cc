#include "controller/rocky7/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard::rocky7 {
namespace {

constexpr int kWidth = 60, kHeight = 40, kAbout = 8;
const Eigen::Vector2d kPixel(30.0, 20.0);

GrayImage Even(int grey) {
  return {kWidth, kHeight,
          std::vector<std::uint8_t>(kWidth * kHeight, static_cast<std::uint8_t>(grey))};
}

// A grey of 80 is aimed at; a stop is twice the light.
TEST(MoreStops, BringTheGreyToEightyByTheLogarithmOfTheirRatio) {
  for (const int grey : {5, 10, 20, 40}) {
    const auto more = MoreStops(Even(grey), kPixel, kAbout, 0.0);
    ASSERT_TRUE(more) << grey;
    EXPECT_DOUBLE_EQ(*more, std::min(std::log2(80.0 / grey), 4.0));
  }
}

TEST(MoreStops, LessThanAStopIsNotWorthAnImage) {
  for (const int grey : {41, 60, 80, 150, 199}) {
    EXPECT_FALSE(MoreStops(Even(grey), kPixel, kAbout, 0.0)) << grey;
  }
}

TEST(MoreStops, ATooBrightImageGivesStopsBackButNoneThatItDidNotHave) {
  EXPECT_FALSE(MoreStops(Even(250), kPixel, kAbout, 0.0));
  EXPECT_DOUBLE_EQ(*MoreStops(Even(250), kPixel, kAbout, 3.0), std::log2(80.0 / 250.0));
  EXPECT_DOUBLE_EQ(*MoreStops(Even(250), kPixel, kAbout, 0.5), -0.5);
}

TEST(MoreStops, NeverAddUpToMoreThanFour) {
  double stops = 0.0;
  while (const auto more = MoreStops(Even(1), kPixel, kAbout, stops)) {
    ASSERT_GT(*more, 0.0);
    stops += *more;
  }
  EXPECT_DOUBLE_EQ(stops, 4.0);
}

// Only what is about the pixel counts, also at the image's border.
TEST(MoreStops, CountOnlyTheSquareAboutThePixel) {
  GrayImage image = Even(80);
  for (int v = 12; v < 28; ++v) {
    for (int u = 22; u < 38; ++u) image.pixels[static_cast<std::size_t>(v * kWidth + u)] = 20;
  }
  EXPECT_DOUBLE_EQ(*MoreStops(image, kPixel, kAbout, 0.0), 2.0);
  EXPECT_FALSE(MoreStops(image, {50.0, 20.0}, kAbout, 0.0));
  EXPECT_DOUBLE_EQ(*MoreStops(Even(20), {0.0, 0.0}, kAbout, 0.0), 2.0);
  EXPECT_FALSE(MoreStops(Even(20), {-20.0, 10.0}, kAbout, 0.0));
}

}  // namespace
}  // namespace dockyard::rocky7
