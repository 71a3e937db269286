#include "controller/stereo/sand_and_stones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "stereo/ray_scene.h"

namespace dockyard {
namespace {

constexpr int kWidth = 200, kHeight = 160;
const PlaneDisparity kGround{.a = 20.0, .b = 0.0, .c = 0.2};

// The ground's plane, tilted against the one that is told, and a square bump of 24 px on it.
Disparities Level(double bump_px, double offset_px) {
  Disparities level{kWidth, kHeight, {}};
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const bool on = std::abs(u - 100) < 12 && std::abs(v - 80) < 12;
      level.px.push_back(
          static_cast<float>(kGround.At(u, v) + 0.004 * u + offset_px + (on ? bump_px : 0.0)));
    }
  }
  return level;
}

// The offset, 1/64 px, tells whose value a pixel has.
constexpr double kMark_px = 1.0 / 64.0;

bool IsStones(const Disparities& merged, int u, int v, double bump_px) {
  const double level = kGround.At(u, v) + 0.004 * u + bump_px;
  return std::abs(static_cast<double>(merged.at(u, v)) - level - kMark_px) < 1e-4;
}

TEST(MergeStones, TakesTheStonesWhereSomethingStandsOutAndTheSandElsewhere) {
  const Disparities merged =
      MergeStones(Level(3.0, 0.0), Level(3.0, kMark_px), kGround, SandAndStonesSettings{});
  EXPECT_TRUE(IsStones(merged, 100, 80, 3.0));
  EXPECT_TRUE(IsStones(merged, 110, 90, 3.0));
  EXPECT_TRUE(IsStones(merged, 114, 80, 0.0));  // beside it
  EXPECT_FALSE(IsStones(merged, 120, 80, 0.0));
  EXPECT_FALSE(IsStones(merged, 30, 30, 0.0));
}

TEST(MergeStones, LeavesNoiseOfTheStonesAlone) {
  Disparities noisy = Level(0.0, kMark_px);
  noisy.px[80 * kWidth + 100] += 3.0F;
  const Disparities merged = MergeStones(Level(0.0, 0.0), noisy, kGround, SandAndStonesSettings{});
  EXPECT_EQ(merged.px, Level(0.0, 0.0).px);
}

TEST(MergeStones, KeepsWhatOneOfThemDoesNotSee) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  Disparities sand = Level(3.0, 0.0), stones = Level(3.0, kMark_px);
  sand.px[80 * kWidth + 100] = none;   // on the bump: the stones' matcher sees it
  stones.px[30 * kWidth + 30] = none;  // on sand: the other does
  const Disparities merged = MergeStones(sand, stones, kGround, SandAndStonesSettings{});
  EXPECT_TRUE(IsStones(merged, 100, 80, 3.0));
  EXPECT_FALSE(std::isnan(merged.at(30, 30)));
}

TEST(MergeStones, RefusesTwoSizes) {
  EXPECT_DEATH(MergeStones(Level(0, 0), {8, 8, std::vector<float>(64)}, kGround, {}),
               "check failed");
}

// Those of the bump that have ground beside them, and no others.
TEST(WithoutEdges, LeavesOutTheFrontOfAnEdge) {
  const Disparities level = Level(3.0, 0.0), kept = WithoutEdges(level, kGround);
  int gone = 0;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const int away = std::max(std::abs(u - 100), std::abs(v - 80));
      EXPECT_EQ(std::isnan(kept.at(u, v)), away == 11) << u << ' ' << v;
      gone += std::isnan(kept.at(u, v));
    }
  }
  EXPECT_EQ(gone, 4 * 22);
}

// On level ground in closed form, with a ball half in it.
TEST(MatchSandAndStones, IsSharpOnBoth) {
  RayScene scene;
  scene.stone = {0.45, 0.03, 0.01};
  scene.stone_radius_m = 0.03;
  const StereoRig rig = BodyPair();
  const Rectifier rectifier(rig);
  const RectifiedPair& pair = rectifier.pair();
  const PlaneDisparity ground = DisparityOf(pair, {});
  const Disparities found = MatchSandAndStones(rectifier, scene.Pair(rig), ground);
  double sand = 0, sand_off = 0, sand2 = 0, stone = 0, stone_off = 0;
  for (int v = 0; v < found.height; ++v) {
    for (int u = 0; u < found.width; ++u) {
      const float px = found.at(u, v);
      if (!(px > 0.0F)) continue;
      const Eigen::Vector3d ray = pair.X_RC.R * pair.Point(u, v, pair.focal_px * pair.baseline_m);
      const Eigen::Vector3d p_R = scene.Hit(rig.X_RL.p, ray.normalized());
      const Eigen::Vector3d p_C = Inverse(pair.X_RC) * p_R;
      if (p_R.head<2>().norm() > 0.8) continue;
      const double error = static_cast<double>(px) - pair.focal_px * pair.baseline_m / p_C.z();
      if (p_R.z() > 1e-3) {
        ++stone;
        stone_off += std::abs(error) > 1.0;
      } else if ((p_R.head<2>() - scene.stone.head<2>()).norm() > 0.07) {
        ++sand;
        sand_off += std::abs(error) > 1.0;
        sand2 += std::abs(error) > 1.0 ? 0.0 : error * error;
      }
    }
  }
  ASSERT_GT(stone, 100);
  ASSERT_GT(sand, 5000);
  EXPECT_LT(sand_off / sand, 0.02);
  EXPECT_LT(std::sqrt(sand2 / (sand - sand_off)), 0.2);
  EXPECT_LT(stone_off / stone, 0.2);
}

}  // namespace
}  // namespace dockyard
