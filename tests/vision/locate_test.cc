#include "controller/vision/board/locate.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

const StereoRig kRig = TestRig(640, 480);

SyntheticScene From(double r_m, double alpha_deg, double h_deg) {
  SyntheticScene scene;
  scene.X_DR = RoverAt({r_m, Radians(alpha_deg), Radians(h_deg)}, 0.0);
  return scene;
}

GrayImage Blank() {
  return {.width = 640, .height = 480, .pixels = std::vector<std::uint8_t>(640 * 480, 120)};
}

Pose3 Truth(const SyntheticScene& scene) { return Inverse(scene.X_DR) * scene.X_DB; }

TEST(LocateBoard, NeedsNoInitialEstimate) {
  const SyntheticScene scene = From(2.5, -15.0, 5.0);
  const LocateOutput out = LocateBoard(SyntheticPair(scene, kRig), kRig, scene.board, {});
  ASSERT_TRUE(out.sighting);
  EXPECT_TRUE(out.sighting->stereo);
  EXPECT_EQ(out.sighting->fiducials_used, 16);
  EXPECT_LT((out.sighting->X_RB.p - Truth(scene).p).norm(), 0.01);
}

TEST(LocateBoard, ReportsEveryMarkWithItsName) {
  const SyntheticScene scene = From(2.0, 0.0, 0.0);
  const LocateOutput out = LocateBoard(SyntheticPair(scene, kRig), kRig, scene.board, {});
  ASSERT_TRUE(out.report.accepted);
  EXPECT_EQ(out.report.method, "stereo");
  ASSERT_EQ(out.report.marks.size(), 16u);
  for (const SightingReport::Mark& mark : out.report.marks) {
    const Camera& camera = mark.camera == 1 ? kRig.right : kRig.left;
    const Pose3 X_CB = Inverse(mark.camera == 1 ? kRig.X_RQ : kRig.X_RL) * Truth(scene);
    const Eigen::Vector2d p = scene.board.fiducials[static_cast<std::size_t>(mark.id)].p_BF;
    const auto pixel = camera.Project(X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0));
    EXPECT_LT((*pixel - Eigen::Vector2d(mark.u_px, mark.v_px)).norm(), 0.5);
  }
}

TEST(LocateBoard, DoesWithOneCamera) {
  const SyntheticScene scene = From(2.0, 20.0, 5.0);
  StereoImages images = SyntheticPair(scene, kRig);
  images.left = Blank();
  const LocateOutput out = LocateBoard(images, kRig, scene.board, {});
  ASSERT_TRUE(out.sighting);
  EXPECT_FALSE(out.sighting->stereo);
  EXPECT_EQ(out.report.method, "right");
  EXPECT_LT((out.sighting->X_RB.p - Truth(scene).p).norm(), 0.03);
}

TEST(LocateBoard, SaysThatNothingIsToBeSeen) {
  const LocateOutput out = LocateBoard({.left = Blank(), .right = Blank()}, kRig, TestBoard(), {});
  ASSERT_FALSE(out.sighting);
  EXPECT_EQ(out.sighting.error(), PoseFailure::kTooFewFiducials);
  EXPECT_EQ(out.report.reason, "too few fiducials");
}

TEST(LocateBoard, NoticesWhenTheCamerasSeeDifferentBoards) {
  StereoImages images = SyntheticPair(From(2.0, 0.0, 0.0), kRig);
  images.right = SyntheticPair(From(2.0, 0.0, 8.0), kRig).right;
  const LocateOutput out = LocateBoard(images, kRig, TestBoard(), {});
  ASSERT_FALSE(out.sighting);
  EXPECT_EQ(out.sighting.error(), PoseFailure::kCamerasDisagree);
}

TEST(LocateBoard, ToleratesTheCalibrationErrorOfARealRig) {
  SyntheticScene scene = From(3.0, 10.0, -5.0);
  for (const std::uint64_t key : {1u, 2u, 3u}) {
    const StereoImages images = SyntheticPair(scene, Miscalibrated(kRig, StreamKey(key, "rig")));
    const LocateOutput out = LocateBoard(images, kRig, scene.board, {});
    ASSERT_TRUE(out.sighting);
    EXPECT_NEAR(out.sighting->X_RB.p.norm(), Truth(scene).p.norm(), 0.05);
  }
}

TEST(LocateBoard, IsTheSameTwice) {
  const SyntheticScene scene = From(3.0, 10.0, -5.0);
  const StereoImages images = SyntheticPair(scene, kRig);
  const LocateOutput a = LocateBoard(images, kRig, scene.board, {});
  const LocateOutput b = LocateBoard(images, kRig, scene.board, {});
  ASSERT_TRUE(a.sighting && b.sighting);
  EXPECT_TRUE(a.sighting->X_RB.p == b.sighting->X_RB.p && a.sighting->X_RB.R == b.sighting->X_RB.R);
}

}  // namespace
}  // namespace dockyard
