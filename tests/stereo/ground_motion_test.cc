#include "controller/stereo/ground_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "controller/stereo/fill_gaps.h"
#include "controller/stereo/sand_and_stones.h"
#include "sim/base/random.h"
#include "stereo/ray_scene.h"

namespace dockyard {
namespace {

// Level ground 0 below the rig, as the rover at X_WR sees it. `sticks` is a square of the left
// picture that moves with the rover.
struct Seen {
  GroundImage picture;

  Seen(const RayScene& scene, const Pose2& X_WR, int sticks_px = 0) {
    const StereoRig rig = BodyPair();
    const Pose3 X_W3{RotZ(X_WR.heading), {X_WR.x, X_WR.y, 0.0}};
    StereoImages images{scene.Picture(rig.left, X_W3 * rig.X_RL),
                        scene.Picture(rig.right, X_W3 * rig.X_RQ)};
    RandomStream random(77);
    const auto width = static_cast<std::size_t>(rig.left.width);
    for (int v = 0; v < sticks_px; ++v) {
      for (int u = 0; u < sticks_px; ++u) {
        images.left
            .pixels[static_cast<std::size_t>(v + 120) * width + static_cast<std::size_t>(u + 100)] =
            static_cast<std::uint8_t>(random.Uniform(20.0, 200.0));
      }
    }
    const Rectifier rectifier(rig);
    const Plane ground{{0, 0, 1}, 0.0};
    const PlaneDisparity disparity = DisparityOf(rectifier.pair(), ground);
    ElevationMap heights =
        MapHeights(rectifier.pair(), MatchSandAndStones(rectifier, images, disparity), ground, 3,
                   {.x_low_m = 0.1, .x_high_m = 1.0, .y_low_m = -0.5, .y_high_m = 0.5});
    FillGaps(3, heights);
    picture = FromAbove(rectifier.pair(), rectifier.Rectified(images).left, heights);
  }
};

void ExpectNear(const Pose2& got, const Pose2& expected, double off_m, double off_rad) {
  EXPECT_NEAR(got.x, expected.x, off_m);
  EXPECT_NEAR(got.y, expected.y, off_m);
  EXPECT_NEAR(got.heading, expected.heading, off_rad);
}

TEST(GroundMotion, IsToldWithinMillimetresThoughTheWheelsSlippedByFiveCentimetres) {
  const RayScene scene{{0.55, 0.05, 0.0}, 0.03, 0.008};
  const Seen before(scene, {});
  for (const Pose2& X_WR : {Pose2{0.12, 0.0, 0.0}, Pose2{0.15, 0.02, Radians(8.0)},
                            Pose2{-0.1, 0.01, Radians(-3.0)}, Pose2{}}) {
    const Seen now(scene, X_WR);
    const Pose2 X_NB = Inverse(X_WR);
    const Pose2 counted{X_NB.x - 0.05, X_NB.y + 0.015, X_NB.heading + Radians(0.3)};
    const GroundMotion motion = MotionBetween(before.picture, now.picture, counted, Radians(0.5));
    ASSERT_TRUE(motion.found) << motion.agreeing << " of " << motion.parts;
    ExpectNear(motion.X_NB, X_NB, 0.003, Radians(0.2));
  }
}

TEST(GroundMotion, IsNotToldFromGroundThatTheEarlierPictureDoesNotShow) {
  const RayScene scene{{0.55, 0.05, 0.0}, 0.03, 0.008};
  const Seen before(scene, {}), now(scene, {5.0, 0.0, 0.0});
  EXPECT_FALSE(MotionBetween(before.picture, now.picture, {-0.1, 0.0, 0.0}, Radians(0.5)).found);
}

TEST(GroundMotion, IsThatOfTheGroundThoughAPartOfThePictureMovesWithTheRover) {
  const RayScene scene{{0.55, 0.05, 0.0}, 0.03, 0.008};
  const Pose2 X_WR{0.06, 0.0, 0.0};
  const Seen before(scene, {}, 90), now(scene, X_WR, 90);
  const GroundMotion motion =
      MotionBetween(before.picture, now.picture, {-0.04, 0.0, 0.0}, Radians(0.5));
  ASSERT_TRUE(motion.found);
  ExpectNear(motion.X_NB, Inverse(X_WR), 0.003, Radians(0.2));
}

TEST(GroundMotion, IsNotToldFromGroundOfOneGrey) {
  RayScene scene;
  scene.grain_m = 1e3;
  const Seen before(scene, {}), now(scene, {0.1, 0.0, 0.0});
  EXPECT_FALSE(MotionBetween(before.picture, now.picture, {-0.1, 0.0, 0.0}, Radians(0.5)).found);
}

}  // namespace
}  // namespace dockyard
