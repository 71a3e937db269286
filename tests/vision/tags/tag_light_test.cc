// Light between the nodes of a grid.
#include "controller/vision/tags/tag_light.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

TEST(LightGrid, IsExactForLightThatIsLinearAlongEachSide) {
  const LightGrid grid(10, 62.0);
  const auto light = [](double x, double y) { return 100.0 + 3.0 * x - 2.0 * y + 0.4 * x * y; };
  LightGrid::Levels levels(grid.nodes());
  const int n = grid.a_side();
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      levels[y * n + x] = light(10.0 * x / (n - 1) - 5.0, 10.0 * y / (n - 1) - 5.0);
    }
  }
  for (double y = -5.0; y <= 5.0; y += 0.37) {
    for (double x = -5.0; x <= 5.0; x += 0.41) {
      EXPECT_NEAR(grid.At({x, y}).Of(levels), light(x, y), 1e-9);
    }
  }
}

TEST(LightGrid, GivesBeyondItsRimTheLightOfTheRim) {
  const LightGrid grid(8, 24.0);
  LightGrid::Levels levels(grid.nodes());
  for (int i = 0; i < grid.nodes(); ++i) levels[i] = 50.0 + i;
  EXPECT_EQ(grid.At({-9.0, -9.0}).Of(levels), levels[0]);
  EXPECT_EQ(grid.At({4.0, 99.0}).Of(levels), levels[grid.nodes() - 1]);
}

TEST(LightGrid, HasFewerNodesOnASmallTag) {
  EXPECT_LT(LightGrid(10, 20.0).a_side(), LightGrid(10, 40.0).a_side());
  EXPECT_EQ(LightGrid(10, 3.0).a_side(), 2);
  EXPECT_EQ(LightGrid(10, 900.0).a_side(), LightGrid::kMostASide);
}

}  // namespace
}  // namespace dockyard
