// A lens beyond its model: its inverse, its size, and where the renderer shows things.
#include "render/lens_ripple.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/measure.h"

namespace dockyard {
namespace {

LensRipple SampleRipple(int width, int height, double rms_px) {
  LensRipple ripple;
  ripple.ring_px = 1.0;
  ripple.ring_turns = 2.7;
  ripple.ring_phase_rad = 0.4;
  ripple.waves = {{{{1.2, 0.7}, {1.0, 0.2}, 0.3},
                   {{-0.4, 2.1}, {-0.6, 0.8}, 2.0},
                   {{1.7, -1.6}, {0.1, 1.0}, 4.4}}};
  return ScaledTo(ripple, width, height, rms_px);
}

/// 2 m before the board at the origin, square to it.
Pose3 AtTheBoard() { return LevelRover(2.0, 0.0, kPi, 0.0) * ForwardCamera(0.0, 0.0, 0.7); }

TEST(LensRipple, HasItsSizeOverTheImage) {
  const LensRipple ripple = SampleRipple(640, 480, 0.4);
  double sum = 0.0;
  for (int y = 0; y < 480; y += 3) {
    for (int x = 0; x < 640; x += 3) sum += ripple.At(Eigen::Vector2d(x, y)).squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(sum / (160.0 * 214.0)), 0.4, 0.004);
  EXPECT_TRUE(LensRipple{}.none());
  EXPECT_EQ(LensRipple{}.At({7.0, 9.0}), Eigen::Vector2d(0.0, 0.0));
}

TEST(LensRipple, ProjectingTheRayOfAPixelComesBackToIt) {
  const Camera fisheye = EquidistantCamera(640, 480, Radians(90.0));
  const Camera pinhole{
      .width = 640,
      .height = 480,
      .lens = BrownPinhole{.fx = 500, .fy = 500, .cx = 320, .cy = 235, .k1 = -0.1}};
  for (const Camera& camera : {fisheye, pinhole}) {
    const LensRipple ripple = SampleRipple(640, 480, 1.0);
    double most_px = 0.0;
    for (int y = 0; y < 480; y += 11) {
      for (int x = 0; x < 640; x += 13) {
        const Eigen::Vector2d pixel(x, y);
        const auto back =
            ProjectWith(ripple, camera, 3.0 * RayWith(ripple, camera, pixel).direction);
        ASSERT_TRUE(back);
        most_px = std::max(most_px, (*back - pixel).norm());
      }
    }
    EXPECT_LT(most_px, 1e-8);
  }
}

TEST(LensRipple, DiscsLieWhereTheRippledLensProjectsThem) {
  const Camera camera = EquidistantCamera(640, 480, kPi / 2);
  Scene scene = BoardOnly();
  const LensRipple ripple = SampleRipple(640, 480, 0.5);
  const Pose3 X_WC = AtTheBoard();
  const Pose3 X_CB = Inverse(X_WC) * scene.boards[0].X_WB;
  const double white = UnshadedRadiance(scene.light, Eigen::Vector3d::UnitX(), 0.85);
  StereoRenderer renderer;
  for (const Eigen::Vector2d& p_BF :
       {Eigen::Vector2d(0.3, 0.15), {-0.3, 0.1}, {0.0, -0.15}, {-0.25, -0.15}}) {
    scene.boards[0].board.fiducials = {{p_BF, 0.0}};
    const Fiducial& fiducial = scene.boards[0].board.fiducials[0];
    const RadianceImage image =
        renderer.RenderRadiance(scene, RigAt(camera, X_WC), {}, false, {ripple, {}})[0];
    const Eigen::Vector2d model = ExactBlackCentroid(scene.boards[0].board, fiducial, camera, X_CB);
    const Eigen::Vector2d at = CentroidOfDark(image, model, 15, white);
    // Over a disc of 20 px the ripple changes by a fifth of itself.
    EXPECT_LT((at - model - ripple.At(at)).norm(), 0.04) << p_BF.transpose();
    EXPECT_GT(ripple.At(at).norm(), 0.1);
  }
}

TEST(LensRipple, OfNoneTheImageIsTheSameToTheBit) {
  const Camera camera = EquidistantCamera(160, 120, kPi / 2);
  const Pose3 X_WC = AtTheBoard();
  StereoRenderer renderer;
  const RadianceImage plain = renderer.RenderGrey(BoardOnly(), camera, X_WC);
  EXPECT_EQ(renderer.RenderGrey(BoardOnly(), camera, X_WC, false, LensRipple{}).values,
            plain.values);
  EXPECT_NE(
      renderer.RenderGrey(BoardOnly(), camera, X_WC, false, SampleRipple(160, 120, 0.4)).values,
      plain.values);
}

}  // namespace
}  // namespace dockyard
