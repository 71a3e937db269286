// Each effect of lens and sensor against the formula that it stands for (docs/reference/images.md).
#include <gtest/gtest.h>

#include <cmath>

#include "render/optics.h"
#include "render/scene_samples.h"
#include "render/shading.h"

namespace dockyard {
namespace {

constexpr int kWidth = 200, kHeight = 150;
const StereoRig kRig = SampleRig(kWidth, kHeight);

RadianceImage Flat(float radiance, float inverse_depth = 0.5f) {
  const std::size_t count = kWidth * kHeight;
  return {.width = kWidth,
          .height = kHeight,
          .values = std::vector<float>(count, radiance),
          .inverse_depth = std::vector<float>(count, inverse_depth)};
}

std::array<RadianceImage, 2> Pair(const RadianceImage& image) { return {image, image}; }

struct Statistics {
  double mean = 0.0, variance = 0.0, skew = 0.0;
};

Statistics Of(const DeepImage& image) {
  Statistics s;
  const auto n = static_cast<double>(image.pixels.size());
  for (const auto p : image.pixels) s.mean += p / n;
  double m3 = 0.0;
  for (const auto p : image.pixels) {
    s.variance += std::pow(p - s.mean, 2) / n;
    m3 += std::pow(p - s.mean, 3) / n;
  }
  s.skew = m3 / std::pow(s.variance, 1.5);
  return s;
}

// f = 3.5 mm, 4.65 um pixels, focused at 1.5 m (a third-inch XGA sensor behind Axel's lens).
Focus AxelFocus(double f_number) { return {3.5e-3, f_number, 1.5, 4.65e-6}; }

TEST(Defocus, CircleIsThatOfTheThinLens) {
  EXPECT_NEAR(BlurCircle_px(AxelFocus(2.0), 0.5), 1.76, 0.01);
  EXPECT_NEAR(BlurCircle_px(AxelFocus(2.0), 5.0), 0.616, 0.005);
  EXPECT_NEAR(BlurCircle_px(AxelFocus(1.4), 0.5), 2.52, 0.01);
  EXPECT_EQ(BlurCircle_px(AxelFocus(2.0), 1.5), 0.0);
  EXPECT_EQ(BlurCircle_px({}, 0.3), 0.0);
}

TEST(Defocus, SpreadsAnEdgeAsAUniformDiscDoes) {
  for (const double f_number : {2.0, 0.7, 0.35}) {
    const Focus focus = AxelFocus(f_number);
    RadianceImage image = Flat(0.0f, 2.0f);  // 0.5 m away
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 100; x < kWidth; ++x) image.values[y * kWidth + x] = 1.0f;
    }
    ApplyOptics(kRig.left, {.focus = focus}, image);
    // Second moment of the edge's slope: c^2 / 16 for a disc of diameter c.
    double moment = 0.0;
    for (int x = 60; x < 140; ++x) {
      const double slope = image.at(x + 1, 75) - image.at(x, 75);
      moment += slope * std::pow(x + 0.5 - 99.5, 2);
    }
    const double measured = 4.0 * std::sqrt(moment), c = BlurCircle_px(focus, 0.5);
    std::printf("f/%.2f: blur circle %.2f px, measured %.2f px\n", f_number, c, measured);
    EXPECT_NEAR(measured, c, 0.05 * c);
    EXPECT_NEAR(image.at(20, 75), 0.0, 1e-6);
    EXPECT_NEAR(image.at(180, 75), 1.0, 1e-6);
  }
}

TEST(Defocus, LeavesWhatIsInFocusAlone) {
  RadianceImage image = Flat(0.0f, 1.0f / 1.5f);
  image.values[75 * kWidth + 100] = 1.0f;
  const RadianceImage before = image;
  ApplyOptics(kRig.left, {.focus = AxelFocus(1.0)}, image);
  EXPECT_EQ(image.values, before.values);
}

TEST(Defocus, WithoutDepthsIsRefused) {
  RadianceImage image = Flat(1.0f);
  image.inverse_depth.clear();
  EXPECT_DEATH(ApplyOptics(kRig.left, {.focus = AxelFocus(2.0)}, image), "check failed");
}

TEST(Exposure, FixedGivesTheElectronsAskedFor) {
  const SensorOptions sensor{
      .full_well_e = 20000, .read_noise_e = 0, .bits = 12, .fixed_exposure_e = 8000};
  const double electrons = 0.3 * 8000;
  EXPECT_NEAR(Of(ExposeDeep(Pair(Flat(0.3f)), kRig, sensor)[0]).mean, electrons * 4095 / 20000,
              0.3);
}

TEST(Exposure, AStopDoublesTheLight) {
  SensorOptions sensor{.read_noise_e = 0, .bits = 12, .fixed_exposure_e = 8000};
  const double at_0 = Of(ExposeDeep(Pair(Flat(0.3f)), kRig, sensor)[0]).mean;
  sensor.exposure_stops = -2.0;
  EXPECT_NEAR(Of(ExposeDeep(Pair(Flat(0.3f)), kRig, sensor)[0]).mean, at_0 / 4.0, 0.3);
}

TEST(Exposure, AutomaticPutsTheExactQuantileAtItsLevel) {
  RadianceImage image = Flat(0.0f);
  for (int i = 0; i < kWidth * kHeight; ++i) {  // 0 to 1 in an order that says nothing
    image.values[i] = static_cast<float>((i * 7919ll) % (kWidth * kHeight)) / (kWidth * kHeight);
  }
  const SensorOptions sensor{.full_well_e = 1e9,
                             .read_noise_e = 0,
                             .bits = 16,
                             .exposure_percent = 2.0,
                             .target_level = 0.5};
  const DeepImage out = ExposeDeep(Pair(image), kRig, sensor)[0];
  int above = 0;
  for (const auto p : out.pixels) above += p > 0.5 * 65535 + 2.0;
  EXPECT_NEAR(above / double(kWidth * kHeight), 0.02, 2e-4);
}

TEST(Response, VariesFromPixelToPixelAndStays) {
  SensorOptions sensor{.full_well_e = 1e9,
                       .read_noise_e = 0,
                       .response_sigma = 0.01,
                       .bits = 16,
                       .fixed_exposure_e = 5e8,
                       .noise_key = 1,
                       .pattern_key = 4};
  const auto first = ExposeDeep(Pair(Flat(1.0f)), kRig, sensor);
  const Statistics s = Of(first[0]);
  EXPECT_NEAR(std::sqrt(s.variance) / s.mean, 0.01, 2e-4);
  // Another image of the same cameras: the same pattern, hidden by no noise to speak of.
  sensor.noise_key = 2;
  const auto second = ExposeDeep(Pair(Flat(1.0f)), kRig, sensor);
  double worst = 0.0;
  for (std::size_t i = 0; i < first[0].pixels.size(); ++i) {
    worst = std::max<double>(worst, std::abs(first[0].pixels[i] - second[0].pixels[i]));
  }
  EXPECT_LT(worst, 0.001 * s.mean);
  EXPECT_NE(first[0], first[1]) << "two cameras share no pattern";
}

TEST(Noise, OfFewElectronsIsPoissons) {
  for (const double mean : {0.5, 4.0, 30.0}) {
    const SensorOptions sensor{
        .full_well_e = 65535, .read_noise_e = 0, .bits = 16, .fixed_exposure_e = mean};
    const Statistics s = Of(ExposeDeep(Pair(Flat(1.0f)), kRig, sensor)[0]);
    EXPECT_NEAR(s.mean, mean, 5.0 * std::sqrt(mean / 3e4));
    EXPECT_NEAR(s.variance, mean, 0.05 * mean);
    EXPECT_NEAR(s.skew, 1.0 / std::sqrt(mean), 0.08);
  }
}

TEST(Converter, TwelveBitsHoldSixteenTimesAsManyLevels) {
  SensorOptions sensor{.read_noise_e = 15, .fixed_exposure_e = 9000, .noise_key = 7};
  const Statistics eight = Of(ExposeDeep(Pair(Flat(1.0f)), kRig, sensor)[0]);
  sensor.bits = 12;
  const auto deep = ExposeDeep(Pair(Flat(1.0f)), kRig, sensor);
  const Statistics twelve = Of(deep[0]);
  EXPECT_NEAR(twelve.mean / eight.mean, 4095.0 / 255.0, 0.05);
  // (electrons + read^2) in levels, and the step's own 1/12.
  const double level = 4095.0 / 20000.0;
  EXPECT_NEAR(twelve.variance, (9000 + 225) * level * level + 1.0 / 12, 0.03 * twelve.variance);
  // The controller sees the upper eight bits.
  const StereoImages seen = ExposeStereo(Pair(Flat(1.0f)), kRig, sensor);
  for (std::size_t i = 0; i < seen.left.pixels.size(); ++i) {
    ASSERT_EQ(seen.left.pixels[i], deep[0].pixels[i] >> 4);
  }
}

TEST(Sensor, BadNewOptionsAreRefused) {
  EXPECT_DEATH(ExposeDeep(Pair(Flat(1)), kRig, {.bits = 7}), "check failed");
  EXPECT_DEATH(ExposeDeep(Pair(Flat(1)), kRig, {.response_sigma = -0.1}), "check failed");
  EXPECT_DEATH(ExposeDeep(Pair(Flat(1)), kRig, {.focus = {.distance_m = 1.0}}), "check failed");
}

}  // namespace
}  // namespace dockyard
