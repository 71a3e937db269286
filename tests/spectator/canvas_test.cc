#include "sim/spectator/canvas.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace dockyard {
namespace {

RgbImage Black(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * height)};
}

std::array<int, 3> At(const RgbImage& image, int x, int y) {
  const std::uint8_t* p = &image.pixels[3 * (static_cast<std::size_t>(y) * image.width + x)];
  return {p[0], p[1], p[2]};
}

SightingReport Report() {
  SightingReport report;
  report.marks = {{.id = 3, .camera = 0, .u_px = 60.0, .v_px = 40.0},
                  {.id = 4, .camera = 1, .u_px = 20.0, .v_px = 20.0}};
  report.predicted = {{.id = 5, .camera = 0, .u_px = 90.0, .v_px = 60.0}};
  return report;
}

TEST(DrawMarks, RingsAreGreenWhereMeasuredAndOrangeCrossesWherePredicted) {
  RgbImage image = Black(128, 96);
  DrawMarks(image, Report(), 0);
  const auto ring = At(image, 64, 40);  // 4 px from the mark
  EXPECT_GT(ring[1], 150);
  EXPECT_GT(ring[1], ring[0] + 50);
  EXPECT_EQ(At(image, 60, 40), (std::array<int, 3>{0, 0, 0}));  // its inside is free
  const auto cross = At(image, 90, 60);
  EXPECT_GT(cross[0], 150);
  EXPECT_EQ(cross[2], 0);
  EXPECT_EQ(At(image, 24, 20), (std::array<int, 3>{0, 0, 0}));  // the other camera's
}

TEST(DrawMarks, FollowThePicturesScale) {
  RgbImage image = Black(128, 96);
  DrawMarks(image, Report(), 0, 0.5);
  EXPECT_GT(At(image, 34, 20)[1], 150);
}

TEST(DrawMarks, LeavesOutThoseWithoutAPlace) {
  SightingReport report;
  report.marks = {{.id = 1, .camera = 0, .u_px = std::numeric_limits<double>::quiet_NaN()},
                  {.id = 2, .camera = 0, .u_px = 1e300, .v_px = -1e300}};
  RgbImage image = Black(32, 32);
  DrawMarks(image, report, 0);
  EXPECT_EQ(image, Black(32, 32));
}

TEST(PutInset, PlacesThePictureAndCutsWhatIsOutside) {
  RgbImage image = Black(20, 20), white = Black(8, 8);
  std::fill(white.pixels.begin(), white.pixels.end(), 255);
  PutInset(image, {16, -4}, white);
  EXPECT_EQ(At(image, 17, 1)[0], 255);
  EXPECT_EQ(At(image, 15, 1)[0], 0);
  EXPECT_EQ(At(image, 17, 5)[0], 0);
  PutInset(image, {40, 40}, white);  // wholly outside: nothing
}

TEST(Resized, KeepsTheProportionAndTheMean) {
  RgbImage image = Black(40, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) image.pixels[3 * (40 * y + x)] = 200;
  }
  const RgbImage half = Resized(image, 20);
  EXPECT_EQ(half.height, 10);
  EXPECT_EQ(At(half, 3, 3)[0], 200);
  EXPECT_EQ(At(half, 16, 3)[0], 0);
}

TEST(SideBySide, KeepsBothPicturesPixels) {
  RgbImage left = Black(3, 2), right = Black(2, 4);
  left.pixels[0] = 7;
  right.pixels[3 * (2 * 3 + 1)] = 9;  // its last row's last pixel
  const RgbImage both = SideBySide(left, right);
  EXPECT_EQ(both.width, 5);
  EXPECT_EQ(both.height, 4);
  EXPECT_EQ(At(both, 0, 0)[0], 7);
  EXPECT_EQ(At(both, 4, 3)[0], 9);
}

TEST(DrawWords, KeepToThePictureAndReplaceWhatTheFontLacks) {
  RgbImage image = Black(60, 20);
  DrawWords(image, {2, 2}, {"a long line that leaves the picture \xc3\xa9"}, 12.0);
  int lit = 0;
  for (const std::uint8_t level : image.pixels) lit += level > 200;
  EXPECT_GT(lit, 30);
}

}  // namespace
}  // namespace dockyard
