#include "controller/rocky7/ground_stereo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/nominal_rover.h"
#include "stereo/ray_scene.h"

namespace dockyard::rocky7 {
namespace {

// A ball that stands out of the ground by 3 cm, ahead of R by x and aside by y; pictures by casting
// rays. The scene's origin is R's, so the ground lies at -0.07 m there.
struct Sample {
  Nominal nominal = NominalRover();
  RayScene scene;
  StereoImages images;
  Eigen::Vector2d top_px{0, 0};

  Sample(double x, double y) {
    scene.stone = {x, y, 0.0};
    scene.stone_radius_m = 0.03;
    const Pose3 X_up = Pose3::Translation(0.0, 0.0, nominal.rolling_radius_m);
    images = {scene.Picture(nominal.front.left, X_up * nominal.front.X_RL),
              scene.Picture(nominal.front.right, X_up * nominal.front.X_RQ)};
    const Eigen::Vector3d front_R(x - 0.02, y, 0.02 - nominal.rolling_radius_m);
    top_px = *nominal.front.left.Project(Inverse(nominal.front.X_RL) * front_R);
  }
};

TEST(GroundStereo, PlacesAClickOnAStoneWithinACentimetreAndAHalf) {
  for (const auto& [x, y] : {std::pair{0.7, 0.05}, {1.0, -0.2}}) {
    const Sample sample(x, y);
    const GroundStereo stereo(sample.nominal);
    const GroundScan seen = stereo.Look(sample.images, {});
    const auto at = stereo.PlaceOf(seen, sample.top_px);
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->x(), x - 0.02, 0.015);
    EXPECT_NEAR(at->y(), y, 0.006);
  }
}

TEST(GroundStereo, MapsTheStoneAndTheGroundAboutItWithoutGaps) {
  const Sample sample(0.8, 0.1);
  const GroundStereo stereo(sample.nominal);
  const ElevationMap map = stereo.MapsAbout(stereo.Look(sample.images, {}), {0.8, 0.1}).closed;
  int known = 0;
  double top_m = -1.0;
  for (int i = 0; i < map.nx * map.ny; ++i) {
    const double height_m = map.height_m[static_cast<std::size_t>(i)];
    if (std::isnan(height_m)) continue;
    ++known;
    const double x = map.x0_m + (i % map.nx) * map.cell_m;
    const double y = map.y0_m + (i / map.nx) * map.cell_m;
    if (std::hypot(x - 0.8, y - 0.1) < 0.02) top_m = std::max(top_m, height_m);
  }
  EXPECT_GT(known, 0.9 * map.nx * map.ny);
  EXPECT_NEAR(top_m, 0.03, 0.006);
}

TEST(GroundStereo, SeesNoPlaceAboveTheGround) {
  const Sample sample(0.8, 0.1);
  const GroundStereo stereo(sample.nominal);
  GroundScan seen = stereo.Look(sample.images, {});
  for (float& px : seen.disparities.px) px = std::nanf("");
  EXPECT_FALSE(stereo.PlaceOf(seen, sample.top_px));
}

}  // namespace
}  // namespace dockyard::rocky7
