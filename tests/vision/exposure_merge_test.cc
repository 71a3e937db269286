// Exposures merged: known light comes back within the noise, and the picture is its logarithm.
#include "controller/vision/board/exposure_merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/base/random.h"

namespace dockyard {
namespace {

// The sensor of the tests, apart from the merge's own numbers: 78 electrons a number, 15 of noise.
constexpr double kElectrons = 78.0, kReadNoise = 15.0;

ExposedImage Expose(const std::vector<double>& light, double stops, RandomStream& noise) {
  ExposedImage out{{.width = static_cast<int>(light.size()), .height = 1, .pixels = {}}, stops};
  for (const double e : light) {
    const double electrons = kElectrons * e * std::exp2(stops);
    const double sigma = std::sqrt(electrons + kReadNoise * kReadNoise);
    const double z = (electrons + sigma * noise.Normal()) / kElectrons;
    out.image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(z + 0.5, 0.0, 255.0)));
  }
  return out;
}

ExposedImage Given(std::vector<std::uint8_t> pixels, double stops) {
  const int width = static_cast<int>(pixels.size());
  return {{.width = width, .height = 1, .pixels = std::move(pixels)}, stops};
}

double Mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double Rms(const std::vector<float>& values, double truth) {
  double sum = 0.0;
  for (const float value : values) sum += (value - truth) * (value - truth);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// Steps of a factor two over 12 stops, of which one exposure holds eight. The bound is three sigmas
// of the mean of 4 000, and what rounding and the cut at zero may shift.
TEST(ExposureMerge, KnownStepsOfLightComeBackWithinTheNoise) {
  RandomStream noise(3);
  for (double light = 0.5; light < 900.0; light *= 2.0) {
    const std::vector<double> field(4000, light);
    const std::vector<float> merged = MergedRadiance(
        {Expose(field, 0.0, noise), Expose(field, -2.0, noise), Expose(field, 2.0, noise)});
    // Shot noise of all the light that unsaturated pictures caught, read noise of the best of them.
    const double most = light < 55.0 ? 4.0 : light < 220.0 ? 1.0 : 0.25;
    const double sigma =
        std::sqrt(light / kElectrons / most + std::pow(kReadNoise / kElectrons / most, 2) +
                  1.0 / 12.0 / (most * most));
    EXPECT_NEAR(Mean(merged), light, 3.0 * sigma / std::sqrt(4000.0) + 0.01 * light + 0.02)
        << light;
    EXPECT_LT(Rms(merged, light), 1.15 * sigma + 0.005 * light) << light;
  }
}

TEST(ExposureMerge, DimLightIsQuieterThanInTheSinglePicture) {
  RandomStream noise(4);
  const std::vector<double> field(4000, 1.5);
  const ExposedImage single = Expose(field, 0.0, noise);
  const std::vector<float> merged =
      MergedRadiance({single, Expose(field, -2.0, noise), Expose(field, 2.0, noise)});
  EXPECT_LT(Rms(merged, 1.5), 0.5 * Rms(MergedRadiance({single}), 1.5));
}

TEST(ExposureMerge, OneExposureAloneGivesItsOwnNumbers) {
  const std::vector<float> merged = MergedRadiance({Given({0, 1, 100, 249}, 0.0)});
  EXPECT_EQ(merged, (std::vector<float>{0.0f, 1.0f, 100.0f, 249.0f}));
}

TEST(ExposureMerge, SaturatedNumbersDoNotCount) {
  const std::vector<float> merged =
      MergedRadiance({Given({255}, 0.0), Given({150}, -2.0), Given({255}, 2.0)});
  EXPECT_FLOAT_EQ(merged[0], 600.0f);
}

TEST(ExposureMerge, LightThatSaturatesEveryPictureGetsTheLeastExposedOnesBound) {
  const std::vector<float> merged =
      MergedRadiance({Given({255}, 0.0), Given({255}, -2.0), Given({255}, 2.0)});
  EXPECT_FLOAT_EQ(merged[0], 4.0f * 255.0f);
}

TEST(ExposureMerge, PictureIsTheLogarithmAboveTheKnee) {
  // Numbers at -2 stops, four times as bright: 40 to 960, and a knee of 8 at 0 stops.
  const std::vector<std::uint8_t> numbers{10, 20, 40, 80, 160, 240};
  const GrayImage merged = MergeExposures({Given({0, 0, 0, 0, 0, 0}, 0.0), Given(numbers, -2.0)},
                                          {.floor_variance = 1e12, .shot_variance = 0.0});
  // Zeros of equal noise weigh 1 against 1/16: light is 4 z / 17.
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double light = 4.0 * numbers[i] * (1.0 / 16.0) / (1.0 + 1.0 / 16.0);
    // 240 is trusted by two thirds: (250 - 240) / 15.
    const double trust = numbers[i] > 235 ? 10.0 / 15.0 : 1.0;
    const double bright = 4.0 * numbers[i] * trust / 16.0 / (1.0 + trust / 16.0);
    const double e = numbers[i] > 235 ? bright : light;
    const double top = 4.0 * 240.0 * (10.0 / 15.0) / 16.0 / (1.0 + 10.0 / 15.0 / 16.0);
    EXPECT_NEAR(merged.pixels[i], 255.0 * std::log1p(e / 8.0) / std::log1p(top / 8.0), 0.51) << i;
  }
}

TEST(ExposureMerge, MoreLightIsNeverDarker) {
  std::vector<std::uint8_t> at0, less, more;
  for (int i = 0; i < 1000; ++i) {
    const double light = 0.05 * std::pow(1.01, i);
    const auto z = [&](double stops) {
      return static_cast<std::uint8_t>(std::min(light * std::exp2(stops) + 0.5, 255.0));
    };
    at0.push_back(z(0.0));
    less.push_back(z(-2.0));
    more.push_back(z(2.0));
  }
  const GrayImage merged = MergeExposures({Given(at0, 0.0), Given(less, -2.0), Given(more, 2.0)});
  for (std::size_t i = 1; i < 1000; ++i) {
    // Rounded numbers of two pictures may differ by a step of the third.
    EXPECT_GE(merged.pixels[i] + 1, merged.pixels[i - 1]) << i;
  }
  EXPECT_EQ(merged.pixels.front(), 0);
  EXPECT_EQ(merged.pixels.back(), 255);
}

TEST(ExposureMerge, DarknessIsNotStretchedToWhite) {
  const GrayImage merged = MergeExposures({Given({0, 1, 0}, 0.0), Given({0, 0, 1}, 2.0)});
  EXPECT_LT(*std::max_element(merged.pixels.begin(), merged.pixels.end()), 64);
}

TEST(ExposureMerge, PicturesOfAnotherSizeAreLeftOut) {
  const std::vector<float> merged =
      MergedRadiance({Given({10, 20}, 0.0), Given({200, 200, 200}, 1.0)});
  EXPECT_EQ(merged, (std::vector<float>{10.0f, 20.0f}));
  EXPECT_TRUE(MergeExposures({}).pixels.empty());
  EXPECT_TRUE(MergeExposures({ExposedImage{}}).pixels.empty());
}

}  // namespace
}  // namespace dockyard
