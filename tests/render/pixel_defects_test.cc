// Hot and dead pixels against their laws.
#include "render/pixel_defects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render/stereo_renderer.h"

namespace dockyard {
namespace {

constexpr std::size_t kPixels = 1 << 20;

std::vector<float> InTheDark(const DefectOptions& defects, std::uint64_t pattern) {
  std::vector<float> electrons(kPixels, 0.0f);
  AddDefects(defects, pattern, 0, kPixels, electrons.data());
  return electrons;
}

struct Count {
  double share = 0.0, mean = 0.0;  // of the hot ones
};
Count HotOf(const std::vector<float>& electrons) {
  Count count;
  for (const float e : electrons) {
    count.share += e > 0.0f;
    count.mean += e;
  }
  count.mean /= std::max(count.share, 1.0);
  count.share /= kPixels;
  return count;
}

// 10 500 of a million are hot: their share within 1 %, 1 sigma, their mean as well.
TEST(PixelDefects, ShareAndMeanOfTheDarkSignalAreThoseOfTheLaw) {
  const std::vector<float> dark = InTheDark({.hot_share = 0.01, .hot_dark_e = 250.0}, 5);
  const Count hot = HotOf(dark);
  EXPECT_NEAR(hot.share, 0.01, 0.0004);
  EXPECT_NEAR(hot.mean, 250.0, 10.0);
  // An exponential law: exp(-k) of them have more than k times the mean.
  for (const double k : {0.5, 1.0, 2.0, 4.0}) {
    double above = 0.0;
    for (const float e : dark) above += e > k * 250.0;
    const double expected = 0.01 * kPixels * std::exp(-k);
    EXPECT_NEAR(above, expected, 4.0 * std::sqrt(expected)) << k;
  }
}

TEST(PixelDefects, TwoInFiveHotPixelsAddAnOffsetToEveryImage) {
  const Count stuck = HotOf(InTheDark({.hot_share = 0.02, .hot_offset_e = 40.0}, 6));
  EXPECT_NEAR(stuck.share, 0.02 * kStuckShare, 0.0004);
  EXPECT_NEAR(stuck.mean, 40.0, 2.0);
}

TEST(PixelDefects, DeadPixelsGetNoLightAndTheOthersKeepTheirs) {
  std::vector<float> electrons(kPixels, 1000.0f);
  AddDefects({.dead_share = 0.01}, 7, 0, kPixels, electrons.data());
  double dead = 0.0;
  for (const float e : electrons) {
    ASSERT_TRUE(e == 0.0f || e == 1000.0f);
    dead += e == 0.0f;
  }
  EXPECT_NEAR(dead / kPixels, 0.01, 0.0004);
}

TEST(PixelDefects, EachCameraHasItsOwnPixelsAndPartsAreThoseOfTheWhole) {
  const DefectOptions defects{.hot_share = 0.01, .hot_dark_e = 100.0};
  const std::vector<float> one = InTheDark(defects, 8), other = InTheDark(defects, 9);
  double both = 0.0;
  for (std::size_t i = 0; i < kPixels; ++i) both += one[i] > 0.0f && other[i] > 0.0f;
  EXPECT_LT(both / kPixels, 0.0003);  // 0.01^2 by chance
  std::vector<float> parts(kPixels, 0.0f);
  for (std::size_t first = 0; first < kPixels; first += 64) {
    AddDefects(defects, 8, first, 64, &parts[first]);
  }
  EXPECT_EQ(parts, one);
}

TEST(PixelDefects, AreTheSamePixelsInEachImageAndNoOtherChanges) {
  const Camera camera = EquidistantCamera(160, 120, Radians(90.0));
  RadianceImage light{.width = 160, .height = 120, .values = std::vector<float>(160 * 120, 0.3f)};
  SensorOptions clean{.bits = 12, .fixed_exposure_e = 20000.0, .pattern_key = 3};
  SensorOptions hot = clean;
  hot.defects = {.hot_share = 0.01, .hot_dark_e = 20000.0};
  std::vector<int> times(160 * 120, 0);
  for (std::uint64_t image = 0; image < 3; ++image) {
    clean.noise_key = hot.noise_key = image;
    const DeepImage a = ExposeOne(light, camera, clean), b = ExposeOne(light, camera, hot);
    for (std::size_t i = 0; i < times.size(); ++i) times[i] += a.pixels[i] != b.pixels[i];
  }
  int always = 0, sometimes = 0;
  for (const int count : times) {
    always += count == 3;
    sometimes += count == 1 || count == 2;
  }
  EXPECT_NEAR(always, 192, 60);
  EXPECT_LE(sometimes, 4);  // of those that are hardly hot
}

}  // namespace
}  // namespace dockyard
