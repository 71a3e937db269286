// Is the board where the camera model says, to a small part of a pixel, and the right way up?
#include <gtest/gtest.h>

#include <cmath>

#include "render/measure.h"

namespace dockyard {
namespace {

struct Offsets {
  double rms_px = 0.0, worst_px = 0.0;
};

/// turn_C: from facing the board's middle to facing past it; fewer discs are then in view.
Offsets CentroidOffsets(const Camera& camera, double range_m, double yaw_rad,
                        const Eigen::Matrix3d& turn_C = Eigen::Matrix3d::Identity(),
                        int least_discs = 12) {
  Scene scene = BoardOnly();
  scene.boards[0].board.width_m = 1.3;  // its edges stay out of the windows
  scene.boards[0].board.height_m = 0.9;
  scene.boards[0].X_WB.R = RotZ(yaw_rad) * scene.boards[0].X_WB.R;
  Pose3 X_WC = LookAt({range_m, 0.05, 0.62}, {0.0, -0.03, 0.75});
  X_WC.R = X_WC.R * turn_C;
  StereoRenderer renderer;
  const StereoRig rig = RigAt(camera, X_WC);
  const auto pair = renderer.RenderRadiance(scene, rig, {});
  const double white = UnshadedRadiance(scene.light, -scene.boards[0].X_WB.R.col(2), 0.85);
  Offsets offsets;
  int count = 0;
  for (int view = 0; view < 2; ++view) {
    const Pose3 X_CB = Inverse(view == 0 ? rig.X_RL : rig.X_RQ) * scene.boards[0].X_WB;
    for (const Fiducial& f : scene.boards[0].board.fiducials) {
      const Eigen::Vector2d exact = ExactBlackCentroid(scene.boards[0].board, f, camera, X_CB);
      if (!camera.Sees(exact, 1.2 * 0.1 * camera.focal_px().x() / range_m)) continue;
      const double window = 0.068 * camera.focal_px().x() / range_m + 2.0;
      const double off = (CentroidOfDark(pair[view], exact, window, white) - exact).norm();
      offsets.rms_px += off * off;
      offsets.worst_px = std::max(offsets.worst_px, off);
      ++count;
    }
  }
  EXPECT_GE(count, least_discs);
  offsets.rms_px = std::sqrt(offsets.rms_px / count);
  std::printf("range %.1f m, yaw %.0f deg, f %.0f: rms %.4f px, worst %.4f px\n", range_m,
              Degrees(yaw_rad), camera.focal_px().x(), offsets.rms_px, offsets.worst_px);
  return offsets;
}

class Centroids : public testing::TestWithParam<double> {};

TEST_P(Centroids, OfDiscsLieWhereTheyProject) {
  const Offsets off = CentroidOffsets(EquidistantCamera(1024, 768, kPi / 2), GetParam(), 0.0);
  EXPECT_LT(off.rms_px, 0.01);
  EXPECT_LT(off.worst_px, 0.02);
}

TEST_P(Centroids, OfObliqueDiscsLieWhereTheyProject) {
  const Offsets off =
      CentroidOffsets(EquidistantCamera(1024, 768, kPi / 2), GetParam(), Radians(30));
  EXPECT_LT(off.rms_px, 0.01);
}

TEST(Centroids640, OfDiscsLieWhereTheyProject) {
  for (const double range_m : {1.0, 2.5, 5.0}) {
    const Offsets off = CentroidOffsets(EquidistantCamera(640, 480, kPi / 2), range_m, 0.0);
    EXPECT_LT(off.rms_px, 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Ranges, Centroids, testing::Values(1.0, 2.0, 3.0, 4.0, 5.0));

TEST(Centroids, FollowADistortedLensToo) {
  Camera camera = EquidistantCamera(1024, 768, kPi / 2);
  auto& lens = std::get<KannalaBrandt>(camera.lens);
  lens.k = {-0.02, 0.004, 0.0, 0.0};
  lens.fy = 655.0;
  lens.cx += 7.3;
  EXPECT_LT(CentroidOffsets(camera, 2.0, 0.3).rms_px, 0.01);
}

// The left Navcam of Mars 2020 (nasa-jpl/m2020-urdf-models) in its own frame, at 1024 x 768. Its
// pupil moves with the angle: drawn from one point, discs near a corner are off by 0.1-0.2 px.
TEST(Centroids, FollowALensWhosePupilMoves) {
  Cahvore lens{.A = {0.999943, -0.005833, 0.00885},
               .H = {2612.926691, 2943.39557, 14.632299},
               .V = {1916.489292, -3.389678, 2975.009835},
               .O = Eigen::Vector3d(0.99995, -0.004409, 0.008967).normalized(),
               .R = {2e-6, 0.049535, -0.015973},
               .E = {-0.003612, 0.013016, -0.023961},
               .linearity = 0.37};
  lens = InFrame(lens, CameraFrameOf(lens));
  const Camera camera = Resized({5120, 3840, lens}, 1024, 768);
  const Eigen::Matrix3d to_corner = RotY(Radians(-28)) * RotX(Radians(20));
  for (const double range_m : {1.0, 1.5, 2.0}) {
    EXPECT_LT(CentroidOffsets(camera, range_m, 0.0, to_corner, 6).rms_px, 0.01);
  }
  EXPECT_LT(CentroidOffsets(camera, 0.75, 0.2).rms_px, 0.01);
}

class Upright : public testing::Test {
 protected:
  Upright() {
    scene_.boards[0].board.fiducials = {{{0.3, 0.15}, kPi / 4}};
    image_ = StereoRenderer().RenderRadiance(scene_, RigAt(camera_, X_WC_), {})[0];
    X_CB_ = Inverse(X_WC_) * scene_.boards[0].X_WB;
  }
  Eigen::Vector2d Pixel(double x_m, double y_m) const {
    return *camera_.Project(X_CB_ * Eigen::Vector3d(x_m, y_m, 0.0));
  }

  Camera camera_ = EquidistantCamera(640, 480, kPi / 2);
  Scene scene_ = BoardOnly();
  Pose3 X_WC_ = LookAt({1.0, 0.0, 0.7}, {0.0, 0.0, 0.7});
  Pose3 X_CB_;
  RadianceImage image_;
};

TEST_F(Upright, ADiscAtPositiveXAndYLiesRightAndLow) {
  const double white = UnshadedRadiance(scene_.light, Eigen::Vector3d::UnitX(), 0.85);
  const Eigen::Vector2d at = CentroidOfDark(image_, Pixel(0.3, 0.15), 35, white);
  EXPECT_GT(at.x(), camera_.centre_px().x() + 80);
  EXPECT_GT(at.y(), camera_.centre_px().y() + 40);
}

TEST_F(Upright, ABarTurnedCounterClockwiseRisesToTheRight) {
  const double along = RadianceAt(image_, Pixel(0.3 + 0.02, 0.15 - 0.02));
  const double across = RadianceAt(image_, Pixel(0.3 + 0.02, 0.15 + 0.02));
  EXPECT_GT(along, 5.0 * across);
}

TEST_F(Upright, WhiteAndBlackHaveTheirAlbedos) {
  const Eigen::Vector3d out = Eigen::Vector3d::UnitX();
  EXPECT_NEAR(RadianceAt(image_, Pixel(0.0, 0.0)), UnshadedRadiance(scene_.light, out, 0.85), 1e-4);
  EXPECT_NEAR(RadianceAt(image_, Pixel(0.3 + 0.02, 0.15 + 0.02)),
              UnshadedRadiance(scene_.light, out, 0.05), 1e-4);
}

TEST_F(Upright, TheBackShowsNoDiscs) {
  const Pose3 X_WC = LookAt({-1.0, 0.0, 0.7}, {0.0, 0.0, 0.7});
  const RadianceImage back = StereoRenderer().RenderRadiance(scene_, RigAt(camera_, X_WC), {})[0];
  const Pose3 X_CB = Inverse(X_WC) * scene_.boards[0].X_WB;
  const Eigen::Vector2d disc = *camera_.Project(X_CB * Eigen::Vector3d(0.33, 0.15, 0.0));
  const Eigen::Vector2d plain = *camera_.Project(X_CB * Eigen::Vector3d(0.1, 0.15, 0.0));
  EXPECT_NEAR(RadianceAt(back, disc), RadianceAt(back, plain), 1e-4);
}

}  // namespace
}  // namespace dockyard
