#include "controller/stereo/band_pass_blocks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/stereo/gray_mat.h"
#include "controller/stereo/match.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

constexpr int kWidth = 200, kHeight = 80;

double Noise(std::uint64_t seed, double x, double y) {
  // The last bytes of a number reach the hash's high bits after eight more.
  const std::uint64_t hash = HashBits(HashDouble(HashDouble(seed, x), y), 0);
  return static_cast<double>(hash >> 40) / (1U << 24) - 0.5;
}

// Smooth noise that is known between pixels: corners 3 px apart, cosines between them.
double Texture(double x, double y) {
  const double i = std::floor(x / 3.0), j = std::floor(y / 3.0);
  const double s = 0.5 - 0.5 * std::cos(M_PI * (x / 3.0 - i));
  const double t = 0.5 - 0.5 * std::cos(M_PI * (y / 3.0 - j));
  return (1 - t) * ((1 - s) * Noise(1, i, j) + s * Noise(1, i + 1, j)) +
         t * ((1 - s) * Noise(1, i, j + 1) + s * Noise(1, i + 1, j + 1));
}

struct Shot {
  double shift_px = 0.0, contrast = 40.0, brightness = 100.0, noise = 0.0;
  std::uint64_t seed = 2;

  GrayImage Image() const {
    GrayImage image{kWidth, kHeight, {}};
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const double grey = brightness + contrast * Texture(u + shift_px, v) +
                            noise * std::sqrt(12.0) * Noise(seed, u, v);
        image.pixels.push_back(static_cast<std::uint8_t>(std::lround(grey)));
      }
    }
    return image;
  }
};

struct Found {
  double density = 0.0, bias_px = 0.0, sigma_px = 0.0;
};

// Off by a pixel at most, of the columns that both images show.
Found About(const Disparities& disparities, double truth_px) {
  double all = 0, n = 0, sum = 0, squares = 0;
  for (int v = 8; v < kHeight - 8; ++v) {
    for (int u = 40; u < kWidth - 8; ++u) {
      ++all;
      const double error = static_cast<double>(disparities.at(u, v)) - truth_px;
      if (!(std::abs(error) <= 1.0)) continue;
      ++n;
      sum += error;
      squares += error * error;
    }
  }
  const double mean = sum / n;
  return {n / all, mean, std::sqrt(squares / n - mean * mean)};
}

constexpr MatchSettings kBandPass{
    .matcher = Matcher::kBandPassed, .block_px = 7, .least_px = 0, .count_px = 32};

// Sums of absolute differences pull the parabola towards whole pixels, by an eighth at most here.
TEST(BandPassBlocks, FindAShiftOfPartsOfAPixel) {
  for (const double shift_px : {5.0, 12.25, 12.5, 20.8}) {
    const StereoImages images{Shot{}.Image(), Shot{.shift_px = shift_px}.Image()};
    const Found found = About(Match(images, kBandPass), shift_px);
    EXPECT_GT(found.density, 0.98) << shift_px;
    EXPECT_NEAR(found.bias_px, 0.0, 0.14) << shift_px;
    EXPECT_LT(found.sigma_px, 0.1) << shift_px;
  }
}

// One camera darker by 30 grey levels and with less contrast, as two cameras of one make are.
TEST(BandPassBlocks, HeedNoBrightnessOfTheCameras) {
  const Shot dark{.shift_px = 12.5, .contrast = 34.0, .brightness = 70.0};
  const Found found = About(Match({Shot{}.Image(), dark.Image()}, kBandPass), 12.5);
  EXPECT_GT(found.density, 0.95);
  EXPECT_NEAR(found.bias_px, 0.0, 0.1);
}

// Faint sand in video noise: slopes between neighbouring pixels drown in it, bands do not.
TEST(BandPassBlocks, FindMoreInFaintTextureThanSlopesDo) {
  const Shot left{.contrast = 8.0, .noise = 1.9, .seed = 2};
  const Shot right{.shift_px = 12.0, .contrast = 8.0, .noise = 1.9, .seed = 3};
  const StereoImages images{left.Image(), right.Image()};
  MatchSettings slopes = kBandPass;
  slopes.matcher = Matcher::kBlocks;
  const Found bands = About(Match(images, kBandPass), 12.0);
  EXPECT_GT(bands.density, 0.6);
  EXPECT_GT(bands.density, 1.5 * About(Match(images, slopes), 12.0).density);
}

int Claimed(const cv::Mat& found) { return cv::countNonZero(found >= 0); }

// Images of noise alone, as of a plain face, and of a texture of twice that noise.
TEST(BandPassBlocks, LeaveOutFlatSumsOfNoiseAndKeepThoseOfTexture) {
  const auto claimed = [](double contrast, int least_bend) {
    const GrayImage left = Shot{.contrast = contrast, .noise = 1.9, .seed = 2}.Image();
    const GrayImage right =
        Shot{.shift_px = 12.0, .contrast = contrast, .noise = 1.9, .seed = 3}.Image();
    return Claimed(MatchBandPassed(MatOn(left), MatOn(right), {.least_bend = least_bend}));
  };
  EXPECT_GT(claimed(0.0, 0), 0.1 * kWidth * kHeight);
  EXPECT_LT(claimed(0.0, 40), 0.15 * claimed(0.0, 0));
  EXPECT_GT(claimed(20.0, 40), 0.97 * claimed(20.0, 0));
}

// Of what they claim by chance, most leads back from the right image to another place.
TEST(BandPassBlocks, ClaimLittleBeyondTheDisparitiesThatWereTried) {
  const StereoImages images{Shot{}.Image(), Shot{.shift_px = 37.0}.Image()};
  int claimed = 0;
  for (const float px : Match(images, kBandPass).px) claimed += std::isfinite(px) ? 1 : 0;
  EXPECT_LT(claimed, 0.25 * kWidth * kHeight);
  MatchSettings from_24 = kBandPass;
  from_24.least_px = 24;
  EXPECT_GT(About(Match(images, from_24), 37.0).density, 0.95);
}

}  // namespace
}  // namespace dockyard
