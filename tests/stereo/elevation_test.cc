#include "controller/stereo/elevation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "stereo/ray_scene.h"

namespace dockyard {
namespace {

// A stone of 5 cm, a third of it in the ground, half a metre ahead.
TEST(MapHeights, HasAStoneWhereItIsAndTheGroundLevel) {
  RayScene scene;
  scene.stone = {0.45, 0.03, 0.008};
  scene.stone_radius_m = 0.025;
  const StereoRig rig = BodyPair();
  const Rectifier rectifier(rig);
  const Plane ground;
  MatchSettings settings{
      .matcher = Matcher::kSemiGlobal, .block_px = 5, .least_px = -16, .count_px = 48};
  settings.ground = DisparityOf(rectifier.pair(), ground);
  const Disparities found = Match(rectifier, scene.Pair(rig), settings);
  const ElevationMap map = MapHeights(rectifier.pair(), found, ground, 5, {});
  double ground_sum = 0, highest_m = 0;
  Eigen::Vector2d top(0, 0);
  int cells = 0, level = 0, within_sigmas = 0;
  for (int iy = 0; iy < map.ny; ++iy) {
    for (int ix = 0; ix < map.nx; ++ix) {
      const auto cell = static_cast<std::size_t>(iy * map.nx + ix);
      if (map.points[cell] == 0) continue;
      const double x = map.x0_m + ix * map.cell_m, y = map.y0_m + iy * map.cell_m;
      const double height = static_cast<double>(map.height_m[cell]);
      const double aside_m = std::hypot(x - 0.45, y - 0.03);
      if (height > highest_m && aside_m < 0.08) {  // a tracker's window
        highest_m = height;
        top = {x, y};
      }
      if (aside_m < 0.06 || x > 0.6 || x < 0.1) continue;
      ++cells;
      ground_sum += height;
      level += std::abs(height) < 3e-3;
      within_sigmas += std::abs(height) < 2.0 * static_cast<double>(map.sigma_m[cell]);
    }
  }
  ASSERT_GT(cells, 2000);
  EXPECT_LT(std::abs(ground_sum / cells), 1e-3);
  EXPECT_GT(level, 0.95 * cells);
  EXPECT_GT(within_sigmas, 0.95 * cells);  // of what the cells say of themselves
  EXPECT_NEAR(highest_m, scene.Height(0.45, 0.03), 6e-3);
  EXPECT_LT((top - Eigen::Vector2d(0.45, 0.03)).norm(), 0.02);
}

// The frame on a tilted plane: a point of the plane has height 0, one above it its distance.
TEST(MapHeights, CountsHeightsFromAPlaneThatIsTilted) {
  const RectifiedPair pair = Rectifier(BodyPair()).pair();
  const Plane plane{RotY(0.2) * Eigen::Vector3d::UnitZ(), -0.05};
  Disparities one{pair.width, pair.height, {}};
  one.px.assign(static_cast<std::size_t>(pair.width * pair.height),
                std::numeric_limits<float>::quiet_NaN());
  const int u = pair.width / 2, v = pair.height / 2;
  const auto place = static_cast<std::size_t>(v * pair.width + u);
  one.px[place] = 40.0F;
  const Eigen::Vector3d p_R = pair.X_RC * pair.Point(u, v, 40.0);
  const ElevationMap map = MapHeights(pair, one, plane, 1, {});
  int seen = 0;
  for (std::size_t cell = 0; cell < map.points.size(); ++cell) {
    if (map.points[cell] == 0) continue;
    ++seen;
    EXPECT_NEAR(static_cast<double>(map.height_m[cell]), plane.normal.dot(p_R) + 0.05, 1e-6);
  }
  EXPECT_EQ(seen, 1);
}

TEST(MapHeights, RefusesAMapWithoutCells) {
  const RectifiedPair pair = Rectifier(BodyPair()).pair();
  EXPECT_DEATH(MapHeights(pair, {}, {}, 9, {.x_low_m = 1.0, .x_high_m = 0.5}), "check failed");
}

}  // namespace
}  // namespace dockyard
