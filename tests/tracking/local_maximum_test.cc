#include "controller/tracking/local_maximum.h"

#include <gtest/gtest.h>

#include "tracking/height_scene.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

class ByLocalMaximum : public ::testing::Test {
 protected:
  RandomStream random_{StreamKey(1, "local maximum")};
};

TEST_F(ByLocalMaximum, FindsTheTopOfAStoneInTheWindow) {
  const HeightScene scene{{{{0.6, 0.1}, 0.03, 0.03}}};
  const ElevationMap map = scene.Map({}, 0.0, random_);
  const auto top = HighestInWindow(map, {0.58, 0.12}, {});
  ASSERT_TRUE(top);
  EXPECT_LT((top->p_E - Vector2d(0.6, 0.1)).norm(), 5e-3);
  EXPECT_FALSE(top->filled);
}

// Causes A3, A4 and the slope of the paper's failures: it takes what is highest.
TEST_F(ByLocalMaximum, TakesATallerStoneTheBorderUphillAndNothingOutsideTheWindow) {
  const HeightScene two{{{{0.6, 0.1}, 0.02, 0.02}, {{0.65, 0.1}, 0.02, 0.03}}};
  EXPECT_NEAR(HighestInWindow(two.Map({}, 0.0, random_), {0.6, 0.1}, {})->p_E.x(), 0.65, 5e-3);
  HeightScene slope{{{{0.6, 0.1}, 0.02, 0.008}}};
  slope.slope_x = std::tan(Radians(10.0));
  EXPECT_NEAR(HighestInWindow(slope.Map({}, 0.0, random_), {0.6, 0.1}, {})->p_E.x(), 0.66, 5e-3);
  const HeightScene one{{{{0.6, 0.1}, 0.03, 0.03}}};
  EXPECT_GT(
      (HighestInWindow(one.Map({}, 0.0, random_), {0.5, 0.1}, {})->p_E - Vector2d(0.6, 0.1)).norm(),
      0.03);
}

TEST_F(ByLocalMaximum, FillsGapsByStraightLinesAndSaysSo) {
  HeightScene scene;
  scene.slope_x = 0.2;
  ElevationMap map = scene.Map({}, 0.0, random_);
  Hide(map, {0.6, 0.1}, 0.02);
  const auto top = HighestInWindow(map, {0.6, 0.1}, {.window_m = 0.022});
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->height_m, 0.2 * top->p_E.x(), 1e-6);  // the plane's
  Hide(map, {0.6, 0.1}, 0.2);
  EXPECT_FALSE(HighestInWindow(map, {0.6, 0.1}, {}));
}

}  // namespace
}  // namespace dockyard
