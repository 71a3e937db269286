#include "controller/tracking/stone_middle.h"

#include <gtest/gtest.h>

#include "tracking/height_scene.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr double kCellSigma_m = 1e-3;  // a cell's, by stereo at 0.6 m

class ByMiddle : public ::testing::Test {
 protected:
  ElevationMap Seen(const HeightScene& scene, double sigma_m = kCellSigma_m) {
    return scene.Map({}, sigma_m, random_);
  }
  RandomStream random_{StreamKey(1, "stone middle")};
};

TEST_F(ByMiddle, IsThatOfAStoneWhereverThePredictionIs) {
  const HeightScene scene{{{{0.6, 0.1}, 0.022, 0.02}}};
  for (int i = 0; i < 15; ++i) {
    const Vector2d off(random_.Uniform(-0.035, 0.035), random_.Uniform(-0.035, 0.035));
    const StoneMiddle stone = FindStone(Seen(scene), Vector2d(0.6, 0.1) + off, {});
    ASSERT_EQ(stone.verdict, StoneVerdict::kFound);
    EXPECT_LT((stone.p_E - Vector2d(0.6, 0.1)).norm(), 2e-3);
    EXPECT_NEAR(stone.height_m, 0.02, 3e-3);
    EXPECT_FALSE(stone.heading_rad);  // it is round
    EXPECT_NEAR(stone.sigma_m, kCellSigma_m, 0.2e-3);
  }
}

// The upper half of a half ellipsoid reaches out to sqrt(3)/2 of its radius.
TEST_F(ByMiddle, KnowsTheUpperPartsSides) {
  const HeightScene scene{{{{0.6, 0.1}, 0.03, 0.024}}};
  const StoneMiddle stone = FindStone(Seen(scene, 1e-5), {0.6, 0.1}, {});
  EXPECT_NEAR(stone.half_length_m, 0.026, 1.5e-3);
  EXPECT_NEAR(stone.half_width_m, 0.026, 1.5e-3);
}

// Two balls side by side that touch are one stone, twice as long as wide.
TEST_F(ByMiddle, KnowsALongStonesHeading) {
  for (const double heading : {-1.2, 0.0, 0.5, 1.4}) {
    const Vector2d along(std::cos(heading), std::sin(heading)), p(0.6, 0.1);
    const HeightScene scene{
        {{p - 0.012 * along, 0.018, 0.02}, {p + 0.012 * along, 0.018, 0.02}, {p, 0.018, 0.02}}};
    const StoneMiddle stone = FindStone(Seen(scene), p + Vector2d(0.01, -0.01), {});
    ASSERT_EQ(stone.verdict, StoneVerdict::kFound);
    EXPECT_LT((stone.p_E - p).norm(), 2e-3);
    ASSERT_TRUE(stone.heading_rad);
    EXPECT_LT(std::abs(std::sin(*stone.heading_rad - heading)), 0.15);
  }
}

// The window's border uphill is higher than the stone.
TEST_F(ByMiddle, StandsOutOfASlope) {
  HeightScene scene{{{{0.6, 0.1}, 0.02, 0.012}}};
  scene.slope_x = std::tan(Radians(10.0));
  const StoneMiddle stone = FindStone(Seen(scene), {0.58, 0.11}, {});
  ASSERT_EQ(stone.verdict, StoneVerdict::kFound);
  EXPECT_LT((stone.p_E - Vector2d(0.6, 0.1)).norm(), 3e-3);
  EXPECT_NEAR(stone.ground.y(), scene.slope_x, 0.01);
  EXPECT_NEAR(stone.height_m, 0.012, 3e-3);
  scene.stones.clear();
  EXPECT_EQ(FindStone(Seen(scene), {0.58, 0.11}, {}).verdict, StoneVerdict::kFlat);
}

TEST_F(ByMiddle, IsOfTheStoneNearerToThePrediction) {
  const HeightScene two{{{{0.6, 0.1}, 0.02, 0.016}, {{0.67, 0.1}, 0.02, 0.03}}};
  const StoneMiddle first = FindStone(Seen(two), {0.61, 0.1}, {});
  ASSERT_EQ(first.verdict, StoneVerdict::kFound);
  EXPECT_LT((first.p_E - Vector2d(0.6, 0.1)).norm(), 3e-3);
  const StoneMiddle second = FindStone(Seen(two), {0.66, 0.1}, {});
  ASSERT_EQ(second.verdict, StoneVerdict::kFound);
  EXPECT_LT((second.p_E - Vector2d(0.67, 0.1)).norm(), 3e-3);
  EXPECT_EQ(FindStone(Seen(two), {0.635, 0.1}, {}).verdict, StoneVerdict::kSeveral);
}

// Two that touch are two as long as the saddle between them is low.
TEST_F(ByMiddle, TellsTwoStonesThatTouch) {
  const HeightScene two{{{{0.6, 0.1}, 0.02, 0.02}, {{0.64, 0.1}, 0.02, 0.02}}};
  const StoneMiddle stone = FindStone(Seen(two), {0.6, 0.09}, {});
  ASSERT_EQ(stone.verdict, StoneVerdict::kFound);
  EXPECT_LT((stone.p_E - Vector2d(0.6, 0.1)).norm(), 3e-3);
}

TEST_F(ByMiddle, SaysThatThereIsNone) {
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(FindStone(Seen({}), {0.6, 0.1}, {}).verdict, StoneVerdict::kFlat);
  }
  // A pebble, and a stone beyond the window.
  const HeightScene pebble{{{{0.6, 0.1}, 0.01, 0.004}, {{0.75, 0.1}, 0.02, 0.03}}};
  EXPECT_EQ(FindStone(Seen(pebble), {0.6, 0.1}, {}).verdict, StoneVerdict::kFlat);
}

TEST_F(ByMiddle, SaysThatAStoneIsNotAllInTheWindow) {
  const HeightScene beside{{{{0.67, 0.1}, 0.02, 0.03}}};
  EXPECT_EQ(FindStone(Seen(beside), {0.6, 0.1}, {}).verdict, StoneVerdict::kBorder);
  const HeightScene boulder{{{{0.675, 0.1}, 0.06, 0.05}}};
  EXPECT_EQ(FindStone(Seen(boulder), {0.6, 0.1}, {}).verdict, StoneVerdict::kBorder);
}

TEST_F(ByMiddle, SaysThatTooLittleIsSeen) {
  ElevationMap map = Seen(HeightScene{{{{0.6, 0.1}, 0.02, 0.02}}});
  Hide(map, {0.6, 0.1}, 0.06);
  EXPECT_EQ(FindStone(map, {0.6, 0.1}, {}).verdict, StoneVerdict::kUnseen);
}

// Of the shadow behind a stone nothing is known.
TEST_F(ByMiddle, StaysWithAStoneWhoseBackIsHidden) {
  ElevationMap map = Seen(HeightScene{{{{0.6, 0.1}, 0.02, 0.02}}});
  Hide(map, {0.637, 0.1}, 0.02);
  const StoneMiddle stone = FindStone(map, {0.59, 0.1}, {});
  ASSERT_EQ(stone.verdict, StoneVerdict::kFound);
  EXPECT_LT((stone.p_E - Vector2d(0.6, 0.1)).norm(), 3e-3);
}

}  // namespace
}  // namespace dockyard
