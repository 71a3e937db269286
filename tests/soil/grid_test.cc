// The height grid: interpolation, borders, undulation.
#include "sim/soil/height_grid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

TEST(HeightGrid, CoversItsExtentSymmetrically) {
  const HeightGrid grid = LevelGrid(-2.0, 10.0, 6.0, 0.02);
  EXPECT_EQ(grid.nx, 501);
  EXPECT_EQ(grid.ny, 301);
  EXPECT_DOUBLE_EQ(grid.y0_m, -3.0);
}

TEST(HeightGrid, GivesAPlaneItsHeightAndNormal) {
  HeightGrid grid = LevelGrid(0.0, 1.0, 1.0, 0.1);
  for (int iy = 0; iy < grid.ny; ++iy) {
    for (int ix = 0; ix < grid.nx; ++ix) {
      grid.heights_m[iy * grid.nx + ix] = 0.2 * ix * 0.1 - 0.1 * (grid.y0_m + iy * 0.1);
    }
  }
  EXPECT_NEAR(grid.Height(0.333, 0.123), 0.2 * 0.333 - 0.1 * 0.123, 1e-12);
  const Eigen::Vector3d expected = Eigen::Vector3d(-0.2, 0.1, 1.0).normalized();
  EXPECT_NEAR((grid.Normal(0.333, 0.123) - expected).norm(), 0.0, 1e-12);
}

TEST(HeightGrid, OutsideHasTheNearestBordersHeight) {
  HeightGrid grid = LevelGrid(0.0, 1.0, 1.0, 0.1);
  AddUndulation(grid, 0.02, 0.5, 0.0, 3);
  EXPECT_EQ(grid.Height(-5.0, 0.2), grid.Height(0.0, 0.2));
  EXPECT_EQ(grid.Height(0.4, 1e6), grid.Height(0.4, 0.5));
}

TEST(Undulation, HasItsRmsFarFromTheDock) {
  double square = 0.0;
  std::size_t samples = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    HeightGrid grid = LevelGrid(4.0, 12.0, 12.0, 0.1);
    AddUndulation(grid, 0.02, 2.0, 1.0, seed);
    for (double height : grid.heights_m) square += height * height;
    samples += grid.heights_m.size();
  }
  EXPECT_NEAR(std::sqrt(square / samples), 0.02, 0.0015);
}

TEST(Undulation, LeavesTheDocksFeetFlat) {
  HeightGrid grid = LevelGrid(-2.0, 10.0, 6.0, 0.02);
  AddUndulation(grid, 0.02, 2.0, 1.0, 7);
  for (double x = -0.6; x <= 0.6; x += 0.05) {
    for (double y = -0.6; y <= 0.6; y += 0.05) ASSERT_EQ(grid.Height(x, y), 0.0);
  }
  EXPECT_GT(std::fabs(grid.Height(4.0, 1.0)) + std::fabs(grid.Height(5.0, -1.0)), 1e-4);
}

TEST(Undulation, BelongsToItsSeed) {
  HeightGrid one = LevelGrid(0.0, 3.0, 3.0, 0.1), again = one, other = one;
  AddUndulation(one, 0.02, 1.0, 0.5, 11);
  AddUndulation(again, 0.02, 1.0, 0.5, 11);
  AddUndulation(other, 0.02, 1.0, 0.5, 12);
  EXPECT_EQ(one.heights_m, again.heights_m);
  EXPECT_NE(one.heights_m, other.heights_m);
}

}  // namespace
}  // namespace dockyard
