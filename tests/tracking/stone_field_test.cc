#include "controller/tracking/stone_field.h"

#include <gtest/gtest.h>

#include "controller/geometry/pose.h"
#include "sim/base/random.h"
#include "tracking/height_scene.h"

namespace dockyard {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

const Eigen::Vector3d kCameras_E(0.0, 0.0, 0.3);

FieldStone At(double x, double y, double height_m) {
  return {.p = {x, y},
          .spread_m2 = 1e-5 * Matrix2d::Identity(),
          .height_m = height_m,
          .height_sigma_m = 0.004};
}

Matrix2d Spread(double along_m, double across_m) {
  return Vector2d(along_m * along_m, across_m * across_m).asDiagonal();
}

TEST(StoneField, AShiftOfAllAlikeIsNoReasonToTakeTheNeighbour) {
  const std::vector<FieldStone> remembered{At(0.8, 0.0, 0.02), At(0.87, 0.02, 0.02),
                                           At(0.75, 0.12, 0.03)};
  // By 7 cm: the neighbour stands where the target was, as high.
  std::vector<FieldStone> seen = remembered;
  for (FieldStone& stone : seen) stone.p += Vector2d(-0.07, -0.02);
  const FieldMatch match = MatchField(remembered, seen, Spread(0.03, 0.015), {});
  EXPECT_EQ(match.seen, (std::vector<int>{0, 1, 2}));
  EXPECT_LT((match.shift_m - Vector2d(-0.07, -0.02)).norm(), 0.003);
  EXPECT_GT(match.odds, 2.0);
}

TEST(StoneField, TheTargetGoneAmongItsNeighboursIsNotOneOfThem) {
  const std::vector<FieldStone> remembered{At(0.8, 0.0, 0.02), At(0.86, 0.0, 0.02),
                                           At(0.75, 0.12, 0.03)};
  std::vector<FieldStone> seen{At(0.85, 0.0, 0.02), At(0.74, 0.12, 0.03)};
  const FieldMatch match = MatchField(remembered, seen, Spread(0.03, 0.015), {});
  EXPECT_EQ(match.seen, (std::vector<int>{-1, 0, 1}));
  EXPECT_GT(match.odds, 2.0);
}

TEST(StoneField, OneStoneHalfwayBetweenTwoIsNotDecided) {
  const std::vector<FieldStone> remembered{At(0.8, 0.0, 0.02), At(0.86, 0.0, 0.02)};
  const FieldMatch match = MatchField(remembered, {At(0.83, 0.0, 0.02)}, Spread(0.05, 0.015), {});
  EXPECT_LT(match.odds, 2.0);
}

// A height that one look measured wrong, as in a hard shadow.
TEST(StoneField, AWrongHeightAloneDoesNotRefuseTheStone) {
  const std::vector<FieldStone> remembered{At(0.8, 0.0, 0.02)};
  const FieldMatch match = MatchField(remembered, {At(0.81, 0.0, 0.05)}, Spread(0.02, 0.01), {});
  EXPECT_EQ(match.seen, std::vector<int>{0});
}

TEST(StoneField, FindsTheStonesOfAMapAndNoneOnBareGround) {
  RandomStream random(5);
  HeightScene scene;
  scene.slope_x = 0.05;
  EXPECT_TRUE(StonesAbout(scene.Map({}, 1e-3, random), {0.6, 0.0}, kCameras_E, {}).empty());
  scene.stones = {{{0.6, 0.0}, 0.02, 0.02}, {{0.67, 0.05}, 0.02, 0.025}};
  const auto stones = StonesAbout(scene.Map({}, 1e-3, random), {0.6, 0.0}, kCameras_E, {});
  ASSERT_EQ(stones.size(), 2u);
  for (const FieldStone& stone : stones) {
    const HalfBall& ball = scene.stones[stone.p.x() > 0.64 ? 1 : 0];
    EXPECT_LT((stone.p - ball.p).norm(), 0.003);
    EXPECT_NEAR(stone.height_m, ball.height_m, 0.004);
    EXPECT_NEAR(stone.ground_m, 0.05 * ball.p.x(), 0.002);
    EXPECT_GT(stone.real, 0.8);
  }
}

}  // namespace
}  // namespace dockyard
