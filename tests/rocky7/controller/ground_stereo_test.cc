#include "controller/rocky7/ground_stereo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/nominal_rover.h"
#include "stereo/ray_scene.h"

namespace dockyard::rocky7 {
namespace {

// A ball that stands out of the ground by 3 cm, ahead of R by x and aside by y; images by casting
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

// All that is as far along the optical axis as the click has half of its disparity, as by a wrong
// match. The paper's front end takes the range as it is.
TEST(GroundStereo, WithAWildRangeTheClickIsOnTheGround) {
  const Sample sample(1.0, 0.1);
  for (const FrontEnd front_end : {FrontEnd::kSandAndStones, FrontEnd::kBlocks7}) {
    const GroundStereo stereo(sample.nominal, front_end);
    GroundScan scan = stereo.Look(sample.images, {});
    ASSERT_NEAR(stereo.ClickOf(scan, sample.top_px).value().p_E.x(), 0.98, 0.03);
    // 0.58 m ahead of the cameras and 0.28 m below them, which are turned down by 45 deg.
    const double depth_m = (0.58 + 0.28) * std::sqrt(0.5);
    const double at_click_px = stereo.MapsAbout(scan, {1.0, 0.1}).focal_baseline_px_m / depth_m;
    for (float& px : scan.disparities.px) {
      if (std::abs(px / at_click_px - 1.0) < 0.06) px *= 0.5F;
    }
    const auto wild = stereo.ClickOf(scan, sample.top_px);
    ASSERT_TRUE(wild);
    if (front_end == FrontEnd::kSandAndStones) {
      EXPECT_NEAR(wild->p_E.x(), 1.0, 0.1);
    } else {
      EXPECT_NEAR(wild->p_E.x(), 1.56, 0.1);
    }
  }
}

/// Maps of the ball at 0.8 m.
GroundMaps MapsOfBall(FrontEnd front_end) {
  const Sample sample(0.8, 0.1);
  const GroundStereo stereo(sample.nominal, front_end);
  return stereo.MapsAbout(stereo.Look(sample.images, {}), {0.8, 0.1});
}

struct InMap {
  double known_share = 0.0, top_m = -1.0, ground_rms_m = 0.0;
};
InMap InMapOf(const ElevationMap& map) {
  InMap in;
  double ground = 0.0, squares = 0.0;
  for (int i = 0; i < map.nx * map.ny; ++i) {
    const double height_m = map.height_m[static_cast<std::size_t>(i)];
    if (std::isnan(height_m)) continue;
    in.known_share += 1.0 / (map.nx * map.ny);
    const double x = map.x0_m + (i % map.nx) * map.cell_m;
    const double y = map.y0_m + (i / map.nx) * map.cell_m;
    if (std::hypot(x - 0.8, y - 0.1) < 0.02) in.top_m = std::max(in.top_m, height_m);
    if (std::hypot(x - 0.8, y - 0.1) < 0.06) continue;
    ++ground;
    squares += height_m * height_m;
  }
  in.ground_rms_m = std::sqrt(squares / ground);
  return in;
}

TEST(GroundStereo, MapsTheStoneAndTheGroundAboutItWithoutGaps) {
  const InMap in = InMapOf(MapsOfBall(FrontEnd::kSandAndStones).closed);
  EXPECT_GT(in.known_share, 0.9);
  EXPECT_NEAR(in.top_m, 0.03, 0.006);
}

// The paper's front end takes no ground out before: a block on ground at a slant spans several
// disparities. The stone has its height.
TEST(GroundStereo, ThePapersFrontEndMapsTheSameLessExactly) {
  const InMap blocks = InMapOf(MapsOfBall(FrontEnd::kBlocks7).fine);
  const InMap ours = InMapOf(MapsOfBall(FrontEnd::kSandAndStones).fine);
  EXPECT_GT(blocks.known_share, 0.5 * ours.known_share);
  EXPECT_GT(blocks.ground_rms_m, 1.5 * ours.ground_rms_m);
  EXPECT_NEAR(blocks.top_m, 0.03, 0.01);
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
