// The two pipelines behind LocateBoard, and the steps that ours adds to a first pose.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/vision/board/locate.h"
#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

const StereoRig kRig = TestRig(640, 480);
const VisionSettings kTsai{.pipeline = VisionPipeline::kTsai2013};

SyntheticScene From(double r_m, double alpha_deg, double h_deg) {
  SyntheticScene scene;
  scene.X_DR = RoverAt({r_m, Radians(alpha_deg), Radians(h_deg)}, 0.0);
  return scene;
}

Pose3 Truth(const SyntheticScene& scene) { return Inverse(scene.X_DR) * scene.X_DB; }

/// Paints a grey patch over fiducials of one image.
void Hide(GrayImage* image, const Camera& camera, const Pose3& X_RC, const SyntheticScene& scene,
          const std::vector<int>& ids) {
  const Pose3 X_CB = Inverse(scene.X_DR * X_RC) * scene.X_DB;
  for (const int id : ids) {
    const Eigen::Vector2d p = scene.board.fiducials[static_cast<std::size_t>(id)].p_BF;
    const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0);
    const Eigen::Vector2d at = *camera.Project(p_C);
    const int reach = static_cast<int>(0.065 * camera.focal_px().x() / p_C.norm());
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const int u = static_cast<int>(at.x()) + x, v = static_cast<int>(at.y()) + y;
        if (u < 0 || v < 0 || u >= image->width || v >= image->height) continue;
        image->pixels[static_cast<std::size_t>(v) * image->width + u] = 170;
      }
    }
  }
}

TEST(Tsai2013, LocatesACalibratedBoardInEvenLight) {
  const SyntheticScene scene = From(2.0, 10.0, 5.0);
  const LocateOutput out = LocateBoard(SyntheticPair(scene, kRig), kRig, scene.board, {}, kTsai);
  ASSERT_TRUE(out.sighting);
  EXPECT_EQ(out.report.method, "stereo");
  EXPECT_TRUE(out.sighting->covariance.isZero());
  EXPECT_LT((out.sighting->X_RB.p - Truth(scene).p).norm(), 0.03);
}

TEST(Tsai2013, NeedsNoGravity) {
  const SyntheticScene scene = From(2.0, 10.0, 5.0);
  const StereoImages images = SyntheticPair(scene, kRig);
  LocateHints wrong;
  wrong.up_R = Eigen::Vector3d(0.0, 1.0, 0.0);
  const LocateOutput with = LocateBoard(images, kRig, scene.board, wrong, kTsai);
  const LocateOutput without = LocateBoard(images, kRig, scene.board, {}, kTsai);
  ASSERT_TRUE(with.sighting && without.sighting);
  EXPECT_EQ(with.sighting->X_RB.p, without.sighting->X_RB.p);
}

TEST(Tsai2013, RangeErrorOfAToeInGrowsAsTheSquareOfTheRange) {
  // Z^2 d / B (vision handbook of stereo): 0.16 deg over 0.35 m is 0.8 cm at 1 m.
  StereoRig built = kRig;
  built.X_RQ.R = built.X_RQ.R * RotY(Radians(0.16));
  for (const double r : {2.0, 3.0, 4.0}) {
    const SyntheticScene scene = From(r, 0.0, 0.0);
    const LocateOutput out = LocateBoard(SyntheticPair(scene, built), kRig, scene.board, {}, kTsai);
    ASSERT_TRUE(out.sighting) << r;
    const Pose3 X_RB = Truth(scene);
    const double depth = X_RB.p.x() - kRig.X_RL.p.x();
    const double expected = depth * depth * Radians(0.16) / 0.35;
    EXPECT_NEAR(std::abs(out.sighting->X_RB.p.x() - X_RB.p.x()), expected, 0.35 * expected) << r;
    const LocateOutput ours = LocateBoard(SyntheticPair(scene, built), kRig, scene.board, {});
    ASSERT_TRUE(ours.sighting) << r;
    EXPECT_LT(std::abs(ours.sighting->X_RB.p.x() - X_RB.p.x()), 0.35 * expected) << r;
  }
}

TEST(Tsai2013, FillsTheMissingByTheHomography) {
  const SyntheticScene scene = From(2.5, 0.0, 0.0);
  StereoImages images = SyntheticPair(scene, kRig);
  Hide(&images.left, kRig.left, kRig.X_RL, scene, {2});
  const LocateOutput out = LocateBoard(images, kRig, scene.board, {}, kTsai);
  ASSERT_TRUE(out.sighting);
  ASSERT_EQ(out.report.predicted.size(), 1u);
  EXPECT_EQ(out.report.predicted[0].id, 2);
  EXPECT_EQ(out.report.predicted[0].camera, 0);
}

TEST(Tsai2013, FailsUnderAHardShadowWhereOursDoesNot) {
  int ours = 0, theirs = 0;
  for (int i = 0; i < 8; ++i) {
    SyntheticScene scene = From(2.0 + 0.3 * i, 0.0, 0.0);
    scene.shadow = SyntheticScene::ShadowEdge{
        .through_B = {0.05 * (i - 4), 0.0}, .normal_rad = 0.6 * i, .shade = 0.15};
    const StereoImages images = SyntheticPair(scene, kRig);
    const auto good = [&](const LocateOutput& out) {
      return out.sighting && (out.sighting->X_RB.p - Truth(scene).p).norm() < 0.1;
    };
    ours += good(LocateBoard(images, kRig, scene.board, {}));
    theirs += good(LocateBoard(images, kRig, scene.board, {}, kTsai));
  }
  EXPECT_EQ(ours, 8);
  EXPECT_LT(theirs, 6);
}

TEST(LocateBoard, FourMarksOfEachCameraAreEnoughTogether) {
  const SyntheticScene scene = From(2.0, 5.0, 0.0);
  StereoImages images = SyntheticPair(scene, kRig);
  Hide(&images.left, kRig.left, kRig.X_RL, scene, {0, 2, 5, 7});
  Hide(&images.right, kRig.right, kRig.X_RQ, scene, {1, 2, 4, 6});
  const LocateOutput out = LocateBoard(images, kRig, scene.board, {});
  ASSERT_TRUE(out.sighting) << out.report.reason;
  EXPECT_TRUE(out.sighting->stereo);
  EXPECT_GE(out.sighting->fiducials_used, 6);
  EXPECT_LT((out.sighting->X_RB.p - Truth(scene).p).norm(), 0.03);
}

TEST(LocateBoard, SaysWhereTheHiddenMarksShouldBe) {
  const SyntheticScene scene = From(2.0, 0.0, 0.0);
  StereoImages images = SyntheticPair(scene, kRig);
  Hide(&images.right, kRig.right, kRig.X_RQ, scene, {3});
  const LocateOutput out = LocateBoard(images, kRig, scene.board, {});
  ASSERT_TRUE(out.sighting);
  EXPECT_EQ(out.report.marks.size(), 15u);
  ASSERT_EQ(out.report.predicted.size(), 1u);
  EXPECT_EQ(out.report.predicted[0].id, 3);
  const Eigen::Vector2d p = scene.board.fiducials[3].p_BF;
  const auto pixel =
      kRig.right.Project(Inverse(kRig.X_RQ) * Truth(scene) * Eigen::Vector3d(p.x(), p.y(), 0.0));
  EXPECT_LT(
      (*pixel - Eigen::Vector2d(out.report.predicted[0].u_px, out.report.predicted[0].v_px)).norm(),
      0.5);
}

TEST(LocateBoard, WorksAtFortyCentimetresAndAtTheBorder) {
  // The cameras 0.4 m before the plate, tilted up at it: part of it lies outside of either image.
  SyntheticScene scene = From(0.45, 0.0, 0.0);
  scene.X_DR = RoverAt({0.45, 0.0, 0.0}, Radians(-20.0));
  LocateHints hints;
  hints.up_R = scene.X_DR.R.transpose() * Eigen::Vector3d::UnitZ();
  const LocateOutput out = LocateBoard(SyntheticPair(scene, kRig), kRig, scene.board, hints);
  ASSERT_TRUE(out.sighting) << out.report.reason;
  EXPECT_LT(out.report.marks.size(), 16u);
  EXPECT_LT((out.sighting->X_RB.p - Truth(scene).p).norm(), 0.005);
}

TEST(LocateBoard, TheCamerasTurnIsLearntOverARun) {
  StereoRig built = kRig;
  built.X_RQ.R = built.X_RQ.R * RotY(Radians(0.3));
  LocateHints hints;
  const double at_first = std::sqrt(hints.camera_turn.covariance(1, 1));
  for (int i = 0; i < 6; ++i) {
    SyntheticScene scene = From(4.5 - 0.5 * i, 10.0 - 3.0 * i, 4.0);
    scene.seed = static_cast<std::uint64_t>(i + 1);
    hints.up_R = scene.X_DR.R.transpose() * Eigen::Vector3d::UnitZ();
    const LocateOutput out = LocateBoard(SyntheticPair(scene, built), kRig, scene.board, hints);
    ASSERT_TRUE(out.sighting) << i;
    hints.camera_turn = out.sighting->camera_turn;
    // It widens again as the board comes near, where an unknown focal length counts for more.
    EXPECT_LT(std::sqrt(hints.camera_turn.covariance(1, 1)), 0.2 * at_first) << i;
  }
  EXPECT_NEAR(hints.camera_turn.mean_rad.y(), Radians(0.3), Radians(0.05));
}

}  // namespace
}  // namespace dockyard
