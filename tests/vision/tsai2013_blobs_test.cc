// Each filter of the paper's blob detection on a figure whose measure is known in closed form: a
// bound on the one side of the measure takes the figure, a bound on the other side refuses it.
#include <gtest/gtest.h>

#include <functional>

#include "controller/vision/board/tsai2013.h"

namespace dockyard {
namespace {

using Shape = std::function<bool(double x, double y)>;  // about the figure's middle [px]

/// A black figure with a white pattern inside on a light ground of 200 x 200 pixels.
GrayImage Drawn(const Shape& black, const Shape& white) {
  constexpr int kSize = 200;
  GrayImage image{.width = kSize, .height = kSize, .pixels = {}};
  for (int v = 0; v < kSize; ++v) {
    for (int u = 0; u < kSize; ++u) {
      const double x = u - 100.0, y = v - 100.0;
      image.pixels.push_back(black(x, y) && !white(x, y) ? 30 : 200);
    }
  }
  return image;
}

Shape Disc(double radius_x, double radius_y) {
  return [=](double x, double y) { return std::hypot(x / radius_x, y / radius_y) < 1.0; };
}

Shape Bar(double half_x, double half_y, double at_x = 0.0) {
  return [=](double x, double y) { return std::abs(x - at_x) < half_x && std::abs(y) < half_y; };
}

Shape Either(const Shape& a, const Shape& b) {
  return [=](double x, double y) { return a(x, y) || b(x, y); };
}

/// A window as wide as the figure, so that its middle is black too, and figures up to half the
/// image.
Tsai2013Vision Settings() {
  Tsai2013Vision settings;
  settings.window_share = 0.2;
  settings.most_area_share = 0.5;
  return settings;
}

std::size_t Found(const GrayImage& image, double Tsai2013Vision::*bound, double value,
                  Tsai2013Vision settings = Settings()) {
  settings.*bound = value;
  return DetectTsai2013(image, settings).size();
}

// An outline through the pixels' centres: half a pixel inside the disc.
TEST(TsaiBlobs, AreOfABoundedArea) {
  const GrayImage small = Drawn(Disc(8.0, 8.0), Bar(4.0, 1.6));
  const double area_px = kPi * 7.5 * 7.5;
  EXPECT_EQ(Found(small, &Tsai2013Vision::least_area_px, 0.9 * area_px), 1u);
  EXPECT_EQ(Found(small, &Tsai2013Vision::least_area_px, 1.1 * area_px), 0u);
  const double share = area_px / (200.0 * 200.0);
  EXPECT_EQ(Found(small, &Tsai2013Vision::most_area_share, 1.1 * share), 1u);
  EXPECT_EQ(Found(small, &Tsai2013Vision::most_area_share, 0.9 * share), 0u);
}

TEST(TsaiBlobs, AreOfABoundedEccentricity) {
  const GrayImage oblique = Drawn(Disc(30.0, 18.0), Bar(15.0, 5.0));
  EXPECT_EQ(Found(oblique, &Tsai2013Vision::least_axis_ratio, 0.56), 1u);
  EXPECT_EQ(Found(oblique, &Tsai2013Vision::least_axis_ratio, 0.64), 0u);
}

TEST(TsaiBlobs, HaveABoundedNumberOfHoles) {
  const Shape three = Either(Bar(2.5, 5.0), Either(Bar(2.5, 5.0, -10.0), Bar(2.5, 5.0, 10.0)));
  const GrayImage image = Drawn(Disc(30.0, 30.0), three);
  Tsai2013Vision settings = Settings();
  settings.most_holes = 3;
  EXPECT_EQ(DetectTsai2013(image, settings).size(), 1u);
  settings.most_holes = 2;
  EXPECT_EQ(DetectTsai2013(image, settings).size(), 0u);
}

TEST(TsaiBlobs, HaveTheirWhiteAboutTheirMiddle) {
  const GrayImage image = Drawn(Disc(30.0, 30.0), Bar(5.0, 12.0, 0.2 * 30.0));
  EXPECT_EQ(Found(image, &Tsai2013Vision::coincidence, 0.23), 1u);
  EXPECT_EQ(Found(image, &Tsai2013Vision::coincidence, 0.17), 0u);
}

TEST(TsaiBlobs, HaveABoundedShareOfWhite) {
  const GrayImage thin = Drawn(Disc(30.0, 30.0), Bar(18.0, 4.0));
  const double thin_share = 4.0 * 18.0 * 4.0 / (kPi * 30.0 * 30.0);
  EXPECT_EQ(Found(thin, &Tsai2013Vision::least_white, 0.85 * thin_share), 1u);
  EXPECT_EQ(Found(thin, &Tsai2013Vision::least_white, 1.15 * thin_share), 0u);
  const GrayImage thick = Drawn(Disc(30.0, 30.0), Bar(18.0, 13.0));
  const double thick_share = 4.0 * 18.0 * 13.0 / (kPi * 30.0 * 30.0);
  EXPECT_EQ(Found(thick, &Tsai2013Vision::most_white, 1.1 * thick_share), 1u);
  EXPECT_EQ(Found(thick, &Tsai2013Vision::most_white, 0.9 * thick_share), 0u);
}

// A cross of arms 0.3 of its width has 0.78 of the area of the ellipse with its second moments.
TEST(TsaiBlobs, FillTheirEllipse) {
  const GrayImage cross = Drawn(Either(Bar(30.0, 9.0), Bar(9.0, 30.0)), Bar(7.0, 5.0));
  EXPECT_EQ(Found(cross, &Tsai2013Vision::fullness, 0.72), 1u);
  EXPECT_EQ(Found(cross, &Tsai2013Vision::fullness, 0.86), 0u);
}

// A bar of 0.2 radii across 0.9 of the disc: white is 0.2 x 2 w of pi, within w radii.
TEST(TsaiBlobs, AreReadWithinAShareOfTheirRadius) {
  const GrayImage image = Drawn(Disc(40.0, 40.0), Bar(36.0, 4.0));
  Tsai2013Vision settings = Settings();
  settings.least_white = 0.085;
  EXPECT_EQ(Found(image, &Tsai2013Vision::pattern_within, 0.8, settings), 1u);  // 0.102
  EXPECT_EQ(Found(image, &Tsai2013Vision::pattern_within, 0.5, settings), 0u);  // 0.064
}

}  // namespace
}  // namespace dockyard
