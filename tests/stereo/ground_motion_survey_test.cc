// A rover's motion told from rendered pairs of the ground, against the truth: a table. Minutes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "controller/stereo/fill_gaps.h"
#include "controller/stereo/ground_motion.h"
#include "controller/stereo/sand_and_stones.h"
#include "sim/base/random.h"
#include "stereo/rendered_yard.h"

namespace dockyard {
namespace {

constexpr int kGroundYards = 3, kMotions = 8;
// As Rocky 7's controller has it: cells and what it looks at ahead.
constexpr ElevationSettings kAhead{
    .x_low_m = 0.0, .x_high_m = 0.95, .y_low_m = -0.5, .y_high_m = 0.5};

GroundImage PictureFrom(StereoRenderer& renderer, const RenderedYard& yard, const Pose2& X_WR,
                        std::uint64_t key) {
  static const StereoRig rig = BodyCameras();
  static const Rectifier rectifier(rig);
  const Plane ground{{0, 0, 1}, 0.0};
  const StereoImages images = PictureOf(renderer, yard, rig, key, FromGround(X_WR, 0.0));
  ElevationMap heights = MapHeights(
      rectifier.pair(),
      WithoutEdges(MatchSandAndStones(rectifier, images, DisparityOf(rectifier.pair(), ground)),
                   DisparityOf(rectifier.pair(), ground)),
      ground, SandAndStonesSettings{}.stones.block_px, kAhead);
  FillGaps(3, heights);
  return FromAbove(rectifier.pair(), rectifier.Rectified(images).left, heights);
}

double Quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * (static_cast<double>(values.size()) - 1.0))];
}

// Steps of 3 to 30 cm with a turn, odometry off by up to 5 cm ahead, 1.5 cm aside and 0.3 deg.
TEST(GroundMotionSurvey, TellsAMotionWithinMillimetresInEveryLight) {
  StereoRenderer renderer;
  for (const double sun_deg : {12.0, 40.0, 80.0}) {
    std::vector<double> along_mm, aside_mm, turn_deg, ahead_mm;
    int found = 0, asked = 0;
    for (int index = 0; index < kGroundYards; ++index) {
      YardSettings settings;
      settings.seed = static_cast<std::uint64_t>(700 + index);
      settings.sun_elevation_rad = Radians(sun_deg);
      settings.field.cover = 0.05;
      settings.field.least_m = 0.012;
      settings.field.largest_m = 0.15;
      const RenderedYard yard = MakeYard(settings);
      RandomStream random(StreamKey(settings.seed, "motions"));
      Pose2 X_WR;
      GroundImage before = PictureFrom(renderer, yard, X_WR, 1);
      for (int motion = 0; motion < kMotions; ++motion) {
        const double way_m = random.Uniform(0.03, 0.3) * (motion % 2 == 0 ? 1.0 : -1.0);
        const Pose2 moved{way_m, random.Uniform(-0.02, 0.02), Radians(random.Uniform(-8.0, 8.0))};
        X_WR = X_WR * moved;
        GroundImage now = PictureFrom(renderer, yard, X_WR, 2 + static_cast<std::uint64_t>(motion));
        const Pose2 X_NB = Inverse(moved);
        const Pose2 counted{X_NB.x + random.Uniform(-0.05, 0.05),
                            X_NB.y + random.Uniform(-0.015, 0.015),
                            X_NB.heading + Radians(random.Uniform(-0.3, 0.3))};
        const GroundMotion got = MotionBetween(before, now, counted, Radians(0.3));
        before = now;
        ++asked;
        if (!got.found) continue;
        ++found;
        along_mm.push_back(1e3 * std::abs(got.X_NB.x - X_NB.x));
        aside_mm.push_back(1e3 * std::abs(got.X_NB.y - X_NB.y));
        turn_deg.push_back(Degrees(std::abs(WrapPi(got.X_NB.heading - X_NB.heading))));
        const Eigen::Vector2d p_B(0.6, 0.0);
        ahead_mm.push_back(1e3 * (got.X_NB * p_B - X_NB * p_B).norm());
      }
    }
    ASSERT_GT(found, 0);
    std::printf(
        "sun %.0f deg: %d of %d, off along %.1f (95 %%: %.1f) mm, aside %.1f (%.1f) mm, "
        "turn %.2f (%.2f) deg, a point 0.6 m ahead %.1f (%.1f) mm\n",
        sun_deg, found, asked, Quantile(along_mm, 0.5), Quantile(along_mm, 0.95),
        Quantile(aside_mm, 0.5), Quantile(aside_mm, 0.95), Quantile(turn_deg, 0.5),
        Quantile(turn_deg, 0.95), Quantile(ahead_mm, 0.5), Quantile(ahead_mm, 0.95));
    EXPECT_GE(found, asked - 1);
    EXPECT_LT(Quantile(ahead_mm, 0.95), 2.0);
  }
}

}  // namespace
}  // namespace dockyard
