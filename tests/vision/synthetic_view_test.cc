// The ray caster must be right before it can judge anything.
#include "vision/synthetic_view.h"

#include <gtest/gtest.h>

#include "controller/vision/pose_refine.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

/// Centroid of the darkness against white within a radius about a pixel.
Eigen::Vector2d DarkCentroid(const GrayImage& image, const Eigen::Vector2d& about, double radius,
                             double white) {
  const int half = static_cast<int>(std::ceil(radius));
  double sum = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  const int cx = static_cast<int>(std::lround(about.x())),
            cy = static_cast<int>(std::lround(about.y()));
  for (int y = cy - half; y <= cy + half; ++y) {
    for (int x = cx - half; x <= cx + half; ++x) {
      if ((Eigen::Vector2d(x, y) - about).norm() > radius) continue;
      const double dark = white - image.at(x, y);
      sum += dark;
      moment += dark * Eigen::Vector2d(x, y);
    }
  }
  return moment / sum;
}

TEST(SyntheticView, PutsDiscsWhereTheyProject) {
  // Disc and bar share their centre but not their eccentricity offset: the bar, 18 % of the disc,
  // is shorter, so the grey centroid is the disc's to a few hundredths of a pixel.
  SyntheticScene scene;
  scene.noise_dn = 0.0;
  scene.samples = 6;
  scene.X_DR = RoverAt({2.0, Radians(20.0), Radians(10.0)}, 0.0);
  const StereoRig rig = TestRig(640, 480);
  const GrayImage image = SyntheticView(scene, rig.left, rig.X_RL);
  const Pose3 X_CB = Inverse(scene.X_DR * rig.X_RL) * scene.X_DB;
  for (const Fiducial& fiducial : scene.board.fiducials) {
    const auto truth = ProjectDisc(rig.left, X_CB, fiducial, scene.board.disc_diameter_m);
    ASSERT_TRUE(truth);
    const Eigen::Vector2d seen = DarkCentroid(image, *truth, 12.5, scene.white_dn);
    EXPECT_LT((seen - *truth).norm(), 0.03);
  }
}

TEST(SyntheticView, ShadesTheFarSideOfAShadowsEdge) {
  SyntheticScene scene;
  scene.noise_dn = 0.0;
  scene.X_DR = RoverAt({2.0, 0.0, 0.0}, 0.0);
  scene.shadow = SyntheticScene::ShadowEdge{};
  const StereoRig rig = TestRig(640, 480);
  const GrayImage image = SyntheticView(scene, rig.left, rig.X_RL);
  const Pose3 X_CB = Inverse(scene.X_DR * rig.X_RL) * scene.X_DB;
  const auto value = [&](double x_B) {
    const Eigen::Vector2d at = *rig.left.Project(X_CB * Eigen::Vector3d(x_B, -0.05, 0.0));
    return image.at(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())));
  };
  EXPECT_NEAR(value(-0.1), 170.0, 1.0);
  EXPECT_NEAR(value(0.1), 170.0 * 0.25, 1.0);
}

TEST(SyntheticView, IsTheSameTwice) {
  SyntheticScene scene;
  scene.X_DR = RoverAt({3.0, 0.0, 0.0}, 0.0);
  const StereoRig rig = TestRig(320, 240);
  EXPECT_TRUE(SyntheticView(scene, rig.left, rig.X_RL) == SyntheticView(scene, rig.left, rig.X_RL));
}

TEST(Miscalibrated, TurnsTheRightCameraByTheSpreadAsked) {
  const StereoRig rig = TestRig(640, 480);
  double sum = 0.0;
  for (std::uint64_t key = 0; key < 400; ++key) {
    const StereoRig built = Miscalibrated(rig, StreamKey(key, "rig"));
    const Eigen::Matrix3d R = rig.X_RQ.R.transpose() * built.X_RQ.R;
    sum += std::pow(std::atan2(R(0, 2), R(2, 2)), 2);
  }
  EXPECT_NEAR(std::sqrt(sum / 400.0), Radians(0.16), Radians(0.02));
}

}  // namespace
}  // namespace dockyard
