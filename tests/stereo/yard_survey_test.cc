// Stereo on rendered yards against the truth, by matcher, sun and calibration: a table. Minutes.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "controller/stereo/sand_and_stones.h"
#include "sim/base/random.h"
#include "stereo/yard_score.h"

namespace dockyard {
namespace {

constexpr int kYards = 3;

using Search =
    std::function<Disparities(const Rectifier&, const StereoImages&, const PlaneDisparity&)>;

struct Trial {
  std::string name;
  Search search;
};

Trial One(const std::string& name, MatchSettings settings) {
  return {name, [settings](const Rectifier& rectifier, const StereoImages& images,
                           const PlaneDisparity& ground) {
            MatchSettings with = settings;
            with.ground = ground;
            return Match(rectifier, images, with);
          }};
}

Trial Merged() {
  return {"merged",
          [](const Rectifier& rectifier, const StereoImages& images, const PlaneDisparity& ground) {
            return MatchSandAndStones(rectifier, images, ground);
          }};
}

MatchSettings Blocks(int block_px) {
  return {.block_px = block_px, .least_px = -16, .count_px = 64};
}
MatchSettings Paths(int block_px, double smooth_px = 0.0) {
  return {.matcher = Matcher::kSemiGlobal,
          .block_px = block_px,
          .least_px = -16,
          .count_px = 64,
          .smooth_px = smooth_px};
}

std::vector<Trial> All() {
  return {One("blocks of 11", Blocks(11)),
          One("blocks of 15", Blocks(15)),
          One("semi-global, 3", Paths(3)),
          One("semi-global, 5", Paths(5)),
          One("semi-global, 5, smoothed by 0.7 px", Paths(5, 0.7)),
          One("semi-global, 7, smoothed by 1 px", Paths(7, 1.0)),
          Merged()};
}

YardSettings SurveyYard(int index, double sun_deg) {
  YardSettings settings;
  settings.seed = static_cast<std::uint64_t>(100 + index);
  settings.sun_elevation_rad = Radians(sun_deg);
  settings.field.cover = 0.05;  // Spirit's landing site
  settings.field.least_m = 0.012;
  settings.field.largest_m = 0.15;
  return settings;
}

struct Off {
  double yaw_rad = 0.0, pitch_rad = 0.0;  // of the right camera against the left, not told
};

std::vector<YardScore> Survey(double sun_deg, const Off& off, const std::vector<Trial>& trials) {
  StereoRenderer renderer;
  const StereoRig believed = BodyCameras();
  StereoRig rig = believed;
  rig.X_RQ.R = rig.X_RQ.R * RotY(off.yaw_rad) * RotX(off.pitch_rad);
  const Rectifier rectifier(believed);
  const PlaneDisparity ground = DisparityOf(rectifier.pair(), {});
  std::vector<YardScore> scores(trials.size());
  std::vector<double> ms(trials.size());
  std::size_t rocks = 0;
  for (int number = 0; number < kYards; ++number) {
    const RenderedYard yard = MakeYard(SurveyYard(number, sun_deg));
    rocks += yard.rocks.size();
    const StereoImages images =
        PictureOf(renderer, yard, rig, StreamKey(static_cast<std::uint64_t>(number), "noise"));
    const YardTruth truth = TruthOf(yard, believed, rectifier);
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      const Disparities found = trials[i].search(rectifier, images, ground);
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - start;
      ms[i] += took.count() / kYards;
      scores[i].Add(ScoreOf(found, truth, rectifier));
      if (number == 0) {
        KeepPicture("disparity_" + std::to_string(i),
                    Shades(found.width, found.height, found.px, 10.0, 110.0));
      }
    }
    if (number > 0) continue;
    KeepPicture("left", images.left);
    KeepPicture("rectified", rectifier.Rectified(images).left);
    std::vector<float> px;
    for (const YardTruth::Pixel& pixel : truth.pixels) px.push_back(pixel.disparity_px);
    KeepPicture("truth", Shades(truth.width, truth.height, px, 10.0, 110.0));
  }
  std::printf("\nsun at %.0f deg, %zu rocks, yaw off by %.2f deg, pitch by %.2f deg; bands",
              sun_deg, rocks, Degrees(off.yaw_rad), Degrees(off.pitch_rad));
  for (const double edge_m : kBands_m) std::printf(" %.1f", edge_m);
  std::printf(" m\n");
  for (std::size_t i = 0; i < trials.size(); ++i) {
    PrintScore(trials[i].name.c_str(), scores[i], ms[i]);
  }
  return scores;
}

// Bars of the certificate, but for two that are missed: sigma up 2.4 mm in the last band, where the
// sensor's noise decides, and a density of 0.98 of all ground in the third, whose left border the
// right camera does not see.
TEST(StereoSurvey, OfMatchersWithTheSunAt40Deg) {
  const YardScore merged = Survey(40.0, {}, All()).back();
  constexpr std::array<double, kBandCount> kUp_m{0.5e-3, 0.8e-3, 1.2e-3, 2.7e-3};
  constexpr std::array<double, kBandCount> kDense{0.8, 0.9, 0.93, 0.9};
  for (std::size_t band = 0; band < kBandCount; ++band) {
    EXPECT_LE(merged.ground[band].SigmaUp(), kUp_m[band]);
    EXPECT_GE(merged.ground[band].Density(), kDense[band]);
    EXPECT_GE(merged.ground[band].DensityOfBoth(), 0.97);
    EXPECT_LT(std::abs(merged.ground[band].BiasUp()), 0.2e-3);
    EXPECT_GE(merged.rocks[band].DensityOfBoth(), band == 0 ? 0.93 : 0.95);
  }
}
TEST(StereoSurvey, OfMatchersWithTheSunAt12Deg) {
  Survey(12.0, {}, {One("blocks of 15", Blocks(15)), Merged()});
}
TEST(StereoSurvey, OfMatchersWithTheSunAt80Deg) {
  Survey(80.0, {}, {One("blocks of 15", Blocks(15)), Merged()});
}
TEST(StereoSurvey, OfPairsThatAreNotAsTheyAreTold) {
  for (const double off_deg : {0.05, 0.16}) {
    Survey(40.0, {Radians(off_deg), 0.0}, {Merged()});
    Survey(40.0, {0.0, Radians(off_deg)}, {Merged()});
  }
}

// A grid of stones, 200 or 2000, before the cameras.
TEST(StereoSurvey, TimeToDraw2000StonesAgainst200) {
  StereoRenderer renderer;
  for (const int count : {200, 2000}) {
    YardSettings settings;
    for (int i = 0; i < count; ++i) {
      const int column = i % 40, row = i / 40;
      settings.field.given.push_back(
          {0.15 + 0.04 * row, 0.04 * (column - 19.5), 0.02, 0.01, 0.1 * i});
    }
    const RenderedYard yard = MakeYard(settings);
    for (const char* which : {"first", "again"}) {
      const auto start = std::chrono::steady_clock::now();
      const StereoImages images = PictureOf(renderer, yard, BodyCameras(), 1);
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - start;
      std::printf("%d stones, %s pair: %.0f ms\n", count, which, took.count());
      KeepPicture("stones_" + std::to_string(count), images.left);
    }
  }
}

}  // namespace
}  // namespace dockyard
