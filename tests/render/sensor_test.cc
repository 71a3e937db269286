// The sensor against the formulas that it stands for.
#include <gtest/gtest.h>

#include <cmath>

#include "render/pixel_noise.h"
#include "render/scene_samples.h"

namespace dockyard {
namespace {

constexpr int kWidth = 400, kHeight = 300;

std::array<RadianceImage, 2> Even(float radiance) {
  RadianceImage image{
      .width = kWidth, .height = kHeight, .values = std::vector<float>(kWidth * kHeight, radiance)};
  return {image, image};
}

struct Statistics {
  double mean = 0.0, variance = 0.0;
};

Statistics Of(const GrayImage& image) {
  Statistics s;
  for (const std::uint8_t p : image.pixels) s.mean += p;
  s.mean /= static_cast<double>(image.pixels.size());
  for (const std::uint8_t p : image.pixels) s.variance += (p - s.mean) * (p - s.mean);
  s.variance /= static_cast<double>(image.pixels.size() - 1);
  return s;
}

const StereoRig kRig = SampleRig(kWidth, kHeight);

TEST(Exposure, PutsTheGivenShareAtTheTargetLevel) {
  auto radiance = Even(1.0f);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    radiance[0].values[i] = radiance[1].values[i] = static_cast<float>(i) / (kWidth * kHeight);
  }
  const StereoImages out = ExposeStereo(radiance, kRig, {.read_noise_e = 0.0, .target_level = 0.4});
  int above = 0;
  for (const std::uint8_t p : out.left.pixels) above += p > 0.4 * 255.0;
  for (const std::uint8_t p : out.right.pixels) above += p > 0.4 * 255.0;
  EXPECT_NEAR(above / (2.0 * kWidth * kHeight), 0.05, 0.008);  // a level is 0.9 % of the pixels
}

TEST(Exposure, IsOneForThePair) {
  auto radiance = Even(1.0f);
  radiance[1] = Even(0.5f)[1];
  const StereoImages out = ExposeStereo(radiance, kRig, {});
  EXPECT_NEAR(Of(out.right).mean, 0.5 * Of(out.left).mean, 0.2);
}

TEST(Noise, HasPoissonAndReadVariance) {
  const SensorOptions sensor{.full_well_e = 8000.0, .read_noise_e = 30.0, .noise_key = 3};
  const Statistics s = Of(ExposeStereo(Even(2.0f), kRig, sensor).left);
  const double electrons = 0.49 * 8000.0, dn_per_e = 255.0 / 8000.0;
  const double variance = (electrons + 900.0) * dn_per_e * dn_per_e + 1.0 / 12.0;  // rounding
  EXPECT_NEAR(s.mean, electrons * dn_per_e, 0.03);
  EXPECT_NEAR(s.variance, variance, 0.02 * variance);
}

TEST(Noise, IsTheSameForTheSameKeyAndAnotherForAnother) {
  const auto radiance = Even(1.0f);
  EXPECT_EQ(ExposeStereo(radiance, kRig, {.noise_key = 5}),
            ExposeStereo(radiance, kRig, {.noise_key = 5}));
  EXPECT_NE(ExposeStereo(radiance, kRig, {.noise_key = 5}),
            ExposeStereo(radiance, kRig, {.noise_key = 6}));
}

TEST(Noise, OfTheTwoCamerasIsIndependent) {
  const StereoImages out = ExposeStereo(Even(1.0f), kRig, {});
  const double l = Of(out.left).mean, r = Of(out.right).mean;
  double covariance = 0.0;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    covariance += (out.left.pixels[i] - l) * (out.right.pixels[i] - r);
  }
  covariance /= kWidth * kHeight;
  EXPECT_LT(std::abs(covariance / Of(out.left).variance), 4.0 / std::sqrt(kWidth * kHeight));
}

TEST(Noise, IsNormalInItsMomentsAndTails) {
  constexpr int kDraws = 1000000;
  double m1 = 0, m2 = 0, m3 = 0, m4 = 0, neighbours = 0, last = 0;
  int beyond_2 = 0, beyond_3 = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double z = HashNormal(77, i);
    m1 += z;
    m2 += z * z;
    m3 += z * z * z;
    m4 += z * z * z * z;
    neighbours += z * last;
    last = z;
    beyond_2 += std::abs(z) > 2.0;
    beyond_3 += std::abs(z) > 3.0;
  }
  EXPECT_NEAR(m1 / kDraws, 0.0, 0.004);
  EXPECT_NEAR(m2 / kDraws, 1.0, 0.006);
  EXPECT_NEAR(m3 / kDraws, 0.0, 0.012);
  EXPECT_NEAR(m4 / kDraws, 3.0, 0.06);
  EXPECT_NEAR(neighbours / kDraws, 0.0, 0.004);
  EXPECT_NEAR(beyond_2 / 1e6, 0.0455, 0.002);
  EXPECT_NEAR(beyond_3 / 1e6, 0.0027, 0.0003);
}

TEST(Blur, HasTheGivenWidth) {
  auto radiance = Even(0.0f);
  for (auto& image : radiance) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 200; x < kWidth; ++x) image.values[y * kWidth + x] = 1.0f;
    }
  }
  const SensorOptions sensor{
      .full_well_e = 1e9, .read_noise_e = 0.0, .blur_sigma_px = 2.0, .target_level = 1.0};
  const GrayImage out = ExposeStereo(radiance, kRig, sensor).left;
  for (int x = 190; x < 210; ++x) {
    // The edge lies at 199.5; a Gaussian and the pixel's own box are behind its spread.
    const double sigma = std::sqrt(4.0 + 1.0 / 12.0);
    const double expected = 255.0 * 0.5 * std::erfc((199.5 - x) / (std::sqrt(2.0) * sigma));
    EXPECT_NEAR(out.at(x, 150), expected, 1.5) << x;
  }
}

TEST(Vignetting, FallsWithTheCosinePower) {
  const SensorOptions sensor{
      .full_well_e = 1e9, .read_noise_e = 0.0, .vignetting_exponent = 4.0, .target_level = 0.9};
  const GrayImage out = ExposeStereo(Even(1.0f), kRig, sensor).left;
  const double middle = out.at(kWidth / 2, kHeight / 2);
  for (const int x : {20, 80, 140}) {
    const double cosine = kRig.left.Direction({double(x), 40.0}).z();
    EXPECT_NEAR(out.at(x, 40) / middle, std::pow(cosine, 4), 0.01) << x;
  }
}

TEST(Sensor, BadOptionsAreRefused) {
  EXPECT_DEATH(ExposeStereo(Even(1.0f), kRig, {.full_well_e = 0.0}), "check failed");
  EXPECT_DEATH(ExposeStereo(Even(1.0f), kRig, {.blur_sigma_px = -1.0}), "check failed");
  EXPECT_DEATH(ExposeStereo(Even(1.0f), kRig, {.exposure_percent = 100.0}), "check failed");
}

TEST(Sensor, DarknessStaysDark) {
  const StereoImages out = ExposeStereo(Even(0.0f), kRig, {.read_noise_e = 0.0});
  EXPECT_EQ(Of(out.left).mean, 0.0);
}

}  // namespace
}  // namespace dockyard
