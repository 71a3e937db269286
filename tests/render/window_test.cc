// Cover and dust on a lens's window against closed forms (docs/reference/images.md).
#include "render/window.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/scene_samples.h"

namespace dockyard {
namespace {

constexpr int kWidth = 400, kHeight = 300;
const StereoRig kRig = SampleRig(kWidth, kHeight);
const Camera& kCamera = kRig.left;

RadianceImage Flat(float radiance) {
  return {.width = kWidth,
          .height = kHeight,
          .values = std::vector<float>(static_cast<std::size_t>(kWidth) * kHeight, radiance),
          .inverse_depth = {}};
}

double Mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

RadianceImage Behind(const WindowOptions& window, RadianceImage image = Flat(1.0f)) {
  ApplyWindow(kCamera, window, image);
  return image;
}

WindowOptions Cover(double share, double side_deg) {
  return {.distance_m = 0.02,
          .pupil_m = 0.4e-3,
          .cover_share = share,
          .cover_side_rad = Radians(side_deg)};
}

/// A pupil as wide as the window is far makes the blur f pixels; this one makes it that many.
WindowOptions Dust(double share, double blur_px = 6.0) {
  WindowOptions window{
      .distance_m = 0.02, .dust_share = share, .dust_clump_m = 3e-4, .dust_key = 5};
  window.pupil_m = window.distance_m * blur_px / kCamera.focal_px().x();
  return window;
}

TEST(Window, CleanOneLeavesEveryBit) {
  RadianceImage image = Flat(0.3f);
  image.values[17] = 0.1f;
  EXPECT_EQ(Behind({.dust_key = 9}, image).values, image.values);
}

TEST(Window, CoverTakesItsShareOfAFlatField) {
  for (const double share : {0.1, 0.3, 0.5, 0.8}) {
    for (const double side : {0.0, 90.0, 180.0, -90.0, 37.0, 125.0}) {
      EXPECT_NEAR(Mean(Behind(Cover(share, side)).values), 1.0 - share, 5e-4)
          << share << " from " << side;
    }
  }
}

TEST(Window, HalfCoverLeavesTheOtherHalf) {
  constexpr int kFar = 20;  // beyond the edge's blur of 5 px
  struct Side {
    double deg;
    int dark_x, dark_y, light_x, light_y;
  };
  const int mx = kWidth / 2, my = kHeight / 2;
  for (const Side& s : {Side{0.0, mx + kFar, my, mx - kFar, my},       // right
                        Side{90.0, mx, my - kFar, mx, my + kFar},      // up
                        Side{180.0, mx - kFar, my, mx + kFar, my},     // left
                        Side{-90.0, mx, my + kFar, mx, my - kFar}}) {  // down
    const RadianceImage image = Behind(Cover(0.5, s.deg));
    EXPECT_EQ(image.at(s.dark_x, s.dark_y), 0.0f) << s.deg;
    EXPECT_EQ(image.at(s.light_x, s.light_y), 1.0f) << s.deg;
    EXPECT_NEAR(CoverEdge_px(kCamera, Cover(0.5, s.deg)), 0.0, 1e-9);
  }
}

// A quarter from the right: the edge lies a quarter of the width right of the middle.
TEST(Window, EdgeLiesWhereTheShareSays) {
  EXPECT_NEAR(CoverEdge_px(kCamera, Cover(0.25, 0.0)), 0.25 * kWidth, 1e-6);
  EXPECT_NEAR(CoverEdge_px(kCamera, Cover(0.25, 90.0)), 0.25 * kHeight, 1e-6);
  const RadianceImage image = Behind(Cover(0.25, 0.0));
  EXPECT_NEAR(image.at(299, 10) + image.at(300, 10), 1.0, 1e-5);  // half light on the line
}

// The light beside an opaque edge falls as the share of the pupil's disc beyond it; the second
// moment of its slope is that of a disc, c^2 / 16.
TEST(Window, EdgeIsBlurredByThePupilsDisc) {
  for (const double blur_px : {6.0, 12.0, 25.0}) {
    WindowOptions window = Cover(0.5, 0.0);
    window.pupil_m = window.distance_m * blur_px / kCamera.focal_px().x();
    ASSERT_NEAR(WindowBlur_px(kCamera, window), blur_px, 1e-9);
    const RadianceImage image = Behind(window);
    double moment = 0.0;
    for (int x = 150; x < 250; ++x) {
      moment += (image.at(x, 9) - image.at(x + 1, 9)) * std::pow(x + 1.0 - 0.5 * kWidth, 2);
    }
    // A difference of pixels is itself a pixel wide: 1/12 px^2.
    EXPECT_NEAR(4.0 * std::sqrt(moment - 1.0 / 12.0), blur_px, 0.01 * blur_px);
    EXPECT_EQ(image.at(199 - static_cast<int>(0.5 * blur_px + 1.0), 9), 1.0f);
    EXPECT_EQ(image.at(200 + static_cast<int>(0.5 * blur_px + 1.0), 9), 0.0f);
  }
}

TEST(Window, DustTakesItsShareOfAFlatField) {
  for (const double share : {0.02, 0.1, 0.3, 0.6}) {
    for (const double blur_px : {0.2, 3.0, 8.5}) {
      // A clump takes 5e-4 of this image at most; at the border as much blurs out as in.
      EXPECT_NEAR(Mean(Behind(Dust(share, blur_px)).values), 1.0 - share, 0.02 * share + 1e-3)
          << share << ", blurred by " << blur_px << " px";
    }
  }
}

// Blurred wider than the clumps are, dust dims alike wherever it lies; sharp, it is black or clear.
TEST(Window, SharpDustIsOpaqueAndBlurEvensItOut) {
  const auto variance = [](const std::vector<float>& values) {
    const double mean = Mean(values);
    double sum = 0.0;
    for (const float v : values) sum += std::pow(v - mean, 2);
    return sum / static_cast<double>(values.size());
  };
  const std::vector<float> sharp = DustTransmission(kCamera, Dust(0.2, 0.1));
  for (const float v : sharp) ASSERT_TRUE(v == 0.0f || v == 1.0f) << v;
  EXPECT_NEAR(variance(sharp), 0.2 * 0.8, 1e-3);  // of a coin with that share
  // The mean of n independent places has an n-th of the variance: here discs of 40 px over clumps.
  EXPECT_LT(variance(DustTransmission(kCamera, Dust(0.2, 40.0))), 0.05 * 0.2 * 0.8);
}

// A single clump spreads to the overlap of two discs: its light lost is its own area.
TEST(Window, BlurLosesNoLight) {
  for (const double blur_px : {3.0, 7.0, 15.0}) {
    WindowOptions window = Dust(0.05, blur_px);
    const double lost = 1.0 - Mean(DustTransmission(kCamera, window));
    window.pupil_m = 1e-6;
    EXPECT_NEAR(lost, 1.0 - Mean(DustTransmission(kCamera, window)), 4e-3) << blur_px;
  }
}

TEST(Window, ScatterVeilsByWhatTheDustCatches) {
  WindowOptions window = Dust(0.3);
  const RadianceImage clear = Behind(window);
  window.dust_scatter = 0.4;
  const RadianceImage veiled = Behind(window);
  const double veil = 0.4 * (1.0 - Mean(clear.values));
  for (std::size_t i = 0; i < veiled.values.size(); i += 97) {
    ASSERT_NEAR(veiled.values[i], clear.values[i] + veil, 1e-6);
  }
  // A flat field keeps all but what is not scattered.
  EXPECT_NEAR(Mean(veiled.values), 1.0 - 0.6 * 0.3, 0.01);
  // Contrast of a pattern of 0.2 and 1.0 falls from 2/3 to t 0.8 / (t 1.2 + 2 veil).
  RadianceImage bars = Flat(0.2f);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; x += 2)
      bars.values[static_cast<std::size_t>(y) * kWidth + x] = 1.0f;
  }
  const RadianceImage seen = Behind(window, bars);
  double bright = 0.0, dark = 0.0;
  for (std::size_t i = 0; i < seen.values.size(); i += 2) {
    bright += seen.values[i];
    dark += seen.values[i + 1];
  }
  const double t = Mean(clear.values), bars_veil = 0.4 * 0.6 * (1.0 - t);
  EXPECT_NEAR((bright - dark) / (bright + dark), 0.8 * t / (1.2 * t + 2.0 * bars_veil), 0.005);
}

TEST(Window, SameKeySameDustAnotherKeyOtherDust) {
  WindowOptions window = Dust(0.2);
  const std::vector<float> first = DustTransmission(kCamera, window);
  EXPECT_EQ(first, DustTransmission(kCamera, window));
  ++window.dust_key;
  EXPECT_NE(first, DustTransmission(kCamera, window));
}

TEST(Window, DustOfTheSameSizeKeepsItsShareInSmallerImages) {
  const StereoRig small = SampleRig(kWidth / 4, kHeight / 4);
  EXPECT_NEAR(Mean(DustTransmission(small.left, Dust(0.3))), 0.7, 0.02);
}

TEST(Window, BadOnesAreRefused) {
  WindowOptions good = Dust(0.1);
  good.cover_share = 0.1;
  CheckWindow(good);
  for (const auto& spoil : std::vector<void (*)(WindowOptions&)>{
           [](WindowOptions& w) { w.cover_share = 1.0; },
           [](WindowOptions& w) { w.cover_share = -0.1; },
           [](WindowOptions& w) { w.cover_side_rad = std::nan(""); },
           [](WindowOptions& w) { w.dust_share = 0.9; },
           [](WindowOptions& w) { w.dust_clump_m = 0.0; },
           [](WindowOptions& w) { w.dust_scatter = 1.1; },
           [](WindowOptions& w) { w.pupil_m = 0.0; },
           [](WindowOptions& w) { w.distance_m = 0.0; }}) {
    WindowOptions bad = good;
    spoil(bad);
    EXPECT_DEATH(CheckWindow(bad), "check failed");
  }
}

TEST(DeadEye, DarkOneGivesTheReadNoiseOfNoLight) {
  SensorOptions sensor{.read_noise_e = 0.0, .fixed_exposure_e = 10000.0};
  sensor.eyes = {EyeState::kDark, EyeState::kAlive};
  const StereoImages images = ExposeStereo({Flat(1.0f), Flat(1.0f)}, kRig, sensor);
  for (const std::uint8_t pixel : images.left.pixels) ASSERT_EQ(pixel, 0);
  double sum = 0.0;
  for (const std::uint8_t pixel : images.right.pixels) sum += pixel;
  EXPECT_NEAR(sum / static_cast<double>(images.right.pixels.size()), 127.5, 0.6);  // half the well
}

// The pair is exposed for what both give: a dark picture counts, one that never comes does not.
TEST(DeadEye, SilentOneHasNoPixelsAndCountsForNoExposure) {
  RadianceImage ramp = Flat(0.0f);
  for (std::size_t i = 0; i < ramp.values.size(); ++i) {
    ramp.values[i] = static_cast<float>(i) / static_cast<float>(ramp.values.size());
  }
  const auto brightest = [&](EyeState left) {
    SensorOptions sensor{.read_noise_e = 0.0, .exposure_percent = 5.0, .target_level = 0.4};
    sensor.full_well_e = 1e8;
    sensor.eyes[0] = left;
    const StereoImages images = ExposeStereo({ramp, ramp}, kRig, sensor);
    EXPECT_EQ(images.left.pixels.empty(), left == EyeState::kSilent);
    EXPECT_EQ(images.right.pixels.size(), ramp.values.size());
    return images.right.pixels.back() / 255.0;
  };
  // The ramp's quantile at 5 % is 0.95; of ramp and darkness together 5 % exceed 0.90.
  EXPECT_NEAR(brightest(EyeState::kAlive), 0.4 / 0.95, 0.004);
  EXPECT_NEAR(brightest(EyeState::kSilent), 0.4 / 0.95, 0.004);
  EXPECT_NEAR(brightest(EyeState::kDark), 0.4 / 0.90, 0.004);
}

}  // namespace
}  // namespace dockyard
