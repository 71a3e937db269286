// Analogue video through a frame grabber: its noise, its lines' starts and its fields.
#include "render/frame_grabber.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/scene_samples.h"
#include "render/video_fields.h"

namespace dockyard {
namespace {

constexpr int kWidth = 160, kHeight = 400;
const StereoRig kRig = SampleRig(kWidth, kHeight);

/// Hardly any noise of the sensor's own, at half of full scale for radiance 1.
SensorOptions CleanSensor() {
  return {
      .full_well_e = 1e9, .read_noise_e = 0.0, .bits = 16, .fixed_exposure_e = 5e8, .noise_key = 3};
}

/// An edge at x0 in each row, 1.5 px wide, so that its samples hold its moments.
RadianceImage EdgeAt(double x0) {
  RadianceImage image{.width = kWidth, .height = kHeight, .values = {}};
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const double x = i % kWidth;
    image.values.push_back(
        static_cast<float>(0.5 + 0.5 * std::erf((x - x0) / (1.5 * std::numbers::sqrt2))));
  }
  return image;
}

RadianceImage Flat(float radiance) {
  return {
      .width = kWidth, .height = kHeight, .values = std::vector<float>(kWidth * kHeight, radiance)};
}

/// The place of the edge in a row: the mean place of its slope.
double EdgeOf(const DeepImage& image, int row) {
  const std::uint16_t* line = &image.pixels[static_cast<std::size_t>(row) * kWidth];
  double sum = 0.0, moment = 0.0;
  for (int x = 1; x < kWidth; ++x) {
    const double slope = line[x] - line[x - 1];
    sum += slope;
    moment += slope * (x - 0.5);
  }
  return moment / sum;
}

struct Spread {
  double mean = 0.0, sigma = 0.0;
};
Spread Of(const std::vector<double>& values) {
  Spread s;
  for (const double v : values) s.mean += v / static_cast<double>(values.size());
  for (const double v : values) s.sigma += std::pow(v - s.mean, 2);
  s.sigma = std::sqrt(s.sigma / static_cast<double>(values.size()));
  return s;
}

std::vector<double> Edges(const DeepImage& image) {
  std::vector<double> edges;
  for (int row = 0; row < image.height; ++row) edges.push_back(EdgeOf(image, row));
  return edges;
}

TEST(FrameGrabber, NoiseIsAShareOfFullScaleWhateverTheLight) {
  SensorOptions sensor = CleanSensor();
  sensor.video.noise_share = 0.0075;
  for (const float light : {0.3f, 1.0f, 1.6f}) {
    const auto images = ExposeDeep({Flat(light), Flat(light)}, kRig, sensor);
    const Spread s = Of({images[0].pixels.begin(), images[0].pixels.end()});
    EXPECT_NEAR(s.mean, 0.5 * light * 65535.0, 8.0);
    EXPECT_NEAR(s.sigma, 0.0075 * 65535.0, 0.01 * 0.0075 * 65535.0);
    EXPECT_NE(images[0], images[1]) << "two cameras share no noise";
  }
}

TEST(FrameGrabber, AFullWellIsFullScaleBeforeTheNoise) {
  SensorOptions sensor = CleanSensor();
  sensor.video.noise_share = 0.01;
  const DeepImage image = ExposeDeep({Flat(9.0f), Flat(9.0f)}, kRig, sensor)[0];
  double below = 0.0;
  for (const auto p : image.pixels) below += p < 65535;
  EXPECT_NEAR(below / (kWidth * kHeight), 0.5, 0.01);
}

TEST(FrameGrabber, EachLineBeginsAtAPlaceOfItsOwn) {
  SensorOptions sensor = CleanSensor();
  for (const double jitter_px : {0.1, 0.3, 1.5}) {
    sensor.video.line_jitter_px = jitter_px;
    const auto images = ExposeDeep({EdgeAt(80.3), EdgeAt(80.3)}, kRig, sensor);
    const std::vector<double> edges = Edges(images[0]);
    const Spread s = Of(edges);
    EXPECT_NEAR(s.mean, 80.3, 4.0 * jitter_px / std::sqrt(kHeight));
    EXPECT_NEAR(s.sigma, jitter_px, 4.0 * jitter_px / std::sqrt(2.0 * kHeight));
    double together = 0.0;
    for (int row = 1; row < kHeight; ++row) {
      together += (edges[row] - s.mean) * (edges[row - 1] - s.mean) / (kHeight - 1);
    }
    EXPECT_NEAR(together / (s.sigma * s.sigma), 0.0, 4.0 / std::sqrt(kHeight));
    EXPECT_NE(edges, Edges(images[1])) << "two cameras share no lines";
  }
}

TEST(FrameGrabber, AnEvenImageStaysEvenToItsBorders) {
  SensorOptions sensor = CleanSensor();
  sensor.full_well_e = 1e13;  // no noise to speak of
  sensor.fixed_exposure_e = 5e12;
  sensor.video.line_jitter_px = 2.0;
  const DeepImage image = ExposeDeep({Flat(1.0f), Flat(1.0f)}, kRig, sensor)[0];
  for (const auto p : image.pixels) ASSERT_NEAR(p, 32768, 1);
}

TEST(FrameGrabber, TheThreeColoursOfACameraShareItsLines) {
  SensorOptions sensor = CleanSensor();
  sensor.video.line_jitter_px = 0.5;
  const RadianceImage edge = EdgeAt(70.0);
  const auto images = ExposeColour({{{edge, edge, edge}, {edge, edge, edge}}}, kRig, sensor);
  const std::vector<double> red = Edges(images[0][0]), blue = Edges(images[0][2]);
  const std::vector<double> other = Edges(images[1][0]);
  double apart = 0.0;
  for (int row = 0; row < kHeight; ++row) {
    ASSERT_NEAR(red[row], blue[row], 0.02);
    apart = std::max(apart, std::abs(red[row] - other[row]));
  }
  EXPECT_GT(apart, 0.5);
}

TEST(FrameGrabber, ACameraAloneIsTheLeftOneOfAPairWithWhatItKeepsToo) {
  SensorOptions sensor{.response_sigma = 0.01, .noise_key = 4, .pattern_key = 5};
  sensor.video = {.noise_share = 0.01, .line_jitter_px = 0.2};
  const RadianceImage edge = EdgeAt(50.0);
  KeptSensor kept;
  const GrayImage alone = ExposeGrey(edge, kRig.left, sensor);
  EXPECT_EQ(alone, ExposeStereo({edge, edge}, kRig, sensor).left);
  EXPECT_EQ(alone, ExposeGrey(edge, kRig.left, sensor, kept));
}

TEST(FrameGrabber, BadOptionsAreRefused) {
  SensorOptions sensor = CleanSensor();
  sensor.video.noise_share = -0.1;
  EXPECT_DEATH(ExposeDeep({Flat(1), Flat(1)}, kRig, sensor), "check failed");
  sensor.video = {.line_jitter_px = 6.0};
  EXPECT_DEATH(ExposeDeep({Flat(1), Flat(1)}, kRig, sensor), "check failed");
}

TEST(VideoFields, OddLinesOfAMovingEdgeAreASixtiethOfASecondLater) {
  SensorOptions sensor = CleanSensor();
  sensor.bits = 8;
  sensor.fixed_exposure_e = 4.98e8;  // the bright side is not between two levels
  sensor.video.interlaced = true;
  constexpr double kSpeed_px_s = 120.0;  // 2 px from field to field
  const auto light = [&](double seconds) {
    const RadianceImage edge = EdgeAt(80.0 + kSpeed_px_s * seconds);
    return StereoRadiance{edge, edge};
  };
  const StereoImages images = ExposeVideo(PairAt(light), kSpeed_px_s / 60.0, kRig, sensor);
  for (const GrayImage& image : {images.left, images.right}) {
    DeepImage deep{.width = kWidth, .height = kHeight, .bits = 8, .pixels = {}};
    deep.pixels.assign(image.pixels.begin(), image.pixels.end());
    const std::vector<double> edges = Edges(deep);
    for (int row = 0; row + 1 < kHeight; row += 2) {
      ASSERT_NEAR(edges[row], 79.0, 0.05);
      ASSERT_NEAR(edges[row + 1] - edges[row], kSpeed_px_s / 60.0, 0.05);
    }
  }
}

TEST(VideoFields, OfACameraAtRestOneViewOfNowServesAllLines) {
  SensorOptions sensor{.noise_key = 6};
  KeptSensor kept;
  const RadianceImage edge = EdgeAt(80.0);
  int views = 0;
  const auto pair = [&](double seconds) {
    ++views;
    EXPECT_EQ(seconds, 0.0);
    return StereoRadiance{edge, edge};
  };
  const auto one = [&](double seconds) { return pair(seconds)[0]; };
  const StereoImages progressive = ExposeVideo(PairAt(pair), 5.0, kRig, sensor);
  sensor.video.interlaced = true;
  EXPECT_EQ(ExposeVideo(PairAt(pair), 0.09, kRig, sensor), progressive);
  EXPECT_EQ(ExposeVideo(OneAt(one), 0.0, kRig.left, sensor, kept), progressive.left);
  EXPECT_EQ(views, 3);
}

TEST(VideoFields, TwoLikeFieldsAreTheProgressiveImage) {
  SensorOptions sensor{.blur_sigma_px = 0.6, .noise_key = 6};
  sensor.video = {.noise_share = 0.01, .line_jitter_px = 0.2, .interlaced = true};
  const RadianceImage edge = EdgeAt(80.0);
  KeptSensor kept;
  const StereoImages progressive = ExposeStereo({edge, edge}, kRig, sensor);
  EXPECT_EQ(ExposeFields({StereoRadiance{edge, edge}, StereoRadiance{edge, edge}}, kRig, sensor),
            progressive);
  EXPECT_EQ(ExposeFields({edge, edge}, kRig.left, sensor, kept), progressive.left);
}

TEST(VideoFields, TheLensBlursEachFieldByItself) {
  SensorOptions sensor = CleanSensor();
  sensor.bits = 8;
  sensor.blur_sigma_px = 1.0;
  KeptSensor kept;
  const GrayImage image = ExposeFields({Flat(1.0f), Flat(0.0f)}, kRig.left, sensor, kept);
  for (int row = 0; row < kHeight; ++row) {
    ASSERT_NEAR(image.at(kWidth / 2, row), row % 2 == 0 ? 127.5 : 0.0, 1.0) << row;
  }
}

}  // namespace
}  // namespace dockyard
