// What a built lens does beyond its model: no parameter of the model takes it up.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "sim/plant/built_cameras.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

constexpr int kAcross = 33, kDown = 25, kParameters = 11;

StereoModel RippledPair(double ripple_px) {
  StereoModel stereo;
  stereo.nominal.left = stereo.nominal.right = EquidistantCamera(1024, 768, Radians(90.0));
  stereo.lens.ripple_px = ripple_px;
  return stereo;
}

Eigen::Vector2d PixelAt(int i) {
  return {1023.0 * (i % kAcross) / (kAcross - 1), 767.0 * (i / kAcross) / (kDown - 1)};
}

/// The pixel that a lens with these changes shows the direction at: two focal lengths, the centre,
/// four radial terms, three turns.
Eigen::Vector2d Changed(const Camera& camera, const Eigen::Matrix<double, kParameters, 1>& change,
                        const Eigen::Vector3d& ray) {
  Camera other = camera;
  auto& lens = std::get<KannalaBrandt>(other.lens);
  lens.fx += change[0];
  lens.fy += change[1];
  lens.cx += change[2];
  lens.cy += change[3];
  for (std::size_t k = 0; k < 4; ++k) lens.k[k] += change[4 + static_cast<int>(k)];
  return *other.Project(RotX(change[8]) * RotY(change[9]) * RotZ(change[10]) * ray);
}

/// How much of the ripple is left after the best fit of the whole family and of its attitude.
double ShareLeft(const Camera& camera, const LensRipple& ripple) {
  Eigen::MatrixXd jacobian(2 * kAcross * kDown, kParameters);
  Eigen::VectorXd off(2 * kAcross * kDown);
  for (int i = 0; i < kAcross * kDown; ++i) {
    const Eigen::Vector3d ray = RayWith(ripple, camera, PixelAt(i)).direction;
    off.segment<2>(2 * i) = PixelAt(i) - *camera.Project(ray);
    for (int k = 0; k < kParameters; ++k) {
      Eigen::Matrix<double, kParameters, 1> step = Eigen::Matrix<double, kParameters, 1>::Zero();
      step[k] = 1e-5;
      jacobian.block<2, 1>(2 * i, k) =
          (Changed(camera, step, ray) - Changed(camera, -step, ray)) / 2e-5;
    }
  }
  const Eigen::VectorXd fit = jacobian.colPivHouseholderQr().solve(off);
  return (off - jacobian * fit).norm() / off.norm();
}

TEST(BuiltRipple, TheFamilysBestFitLeavesMostOfIt) {
  const StereoModel stereo = RippledPair(0.3);
  double least = 1.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const LensRipple& ripple : BuiltRipples(stereo, seed)) {
      least = std::min(least, ShareLeft(stereo.nominal.left, ripple));
    }
  }
  EXPECT_GT(least, 0.7);
  EXPECT_LT(least, 1.0);
}

TEST(BuiltRipple, IsDrawnPerCameraAndRunAndHasItsSize) {
  const StereoModel stereo = RippledPair(0.3);
  const auto one = BuiltRipples(stereo, 7), again = BuiltRipples(stereo, 7);
  EXPECT_EQ(one, again);
  EXPECT_NE(one[0], one[1]);
  EXPECT_NE(one[0], BuiltRipples(stereo, 8)[0]);
  EXPECT_NE(one[0], BuiltRipples(stereo, 7, "mast_calibration")[0]);
  for (const LensRipple& ripple : one) {
    double sum = 0.0;
    for (int i = 0; i < kAcross * kDown; ++i) sum += ripple.At(PixelAt(i)).squaredNorm();
    EXPECT_NEAR(std::sqrt(sum / (kAcross * kDown)), 0.3, 0.03);
  }
}

TEST(BuiltRipple, LeavesTheOtherErrorsOfARunAsTheyAre) {
  StereoModel plain = RippledPair(0.0), rippled = RippledPair(0.5);
  plain.lens.focal_sigma = rippled.lens.focal_sigma = 0.002;
  plain.rotation_sigma_rad = rippled.rotation_sigma_rad = 0.001;
  const StereoRig a = BuiltRig(plain, 7), b = BuiltRig(rippled, 7);
  EXPECT_EQ(a.left, b.left);
  EXPECT_EQ(a.X_RQ.R, b.X_RQ.R);
  for (const LensRipple& ripple : BuiltRipples(plain, 7)) EXPECT_TRUE(ripple.none());
}

// The steepest that is let through still has an inverse, which ProjectWith finds.
TEST(BuiltRipple, TheLargestOneHasAnInverse) {
  StereoModel stereo = RippledPair(0.5);
  stereo.nominal.left = stereo.nominal.right = EquidistantCamera(160, 120, Radians(90.0));
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const LensRipple ripple = BuiltRipples(stereo, seed)[0];
    for (int y = 0; y < 120; y += 7) {
      for (int x = 0; x < 160; x += 7) {
        const Eigen::Vector2d pixel(x, y);
        const LensRay ray = RayWith(ripple, stereo.nominal.left, pixel);
        const auto back = ProjectWith(ripple, stereo.nominal.left, ray.direction);
        ASSERT_TRUE(back);
        ASSERT_LT((*back - pixel).norm(), 1e-6);
      }
    }
  }
  stereo.lens.ripple_px = 0.6;
  EXPECT_THROW(BuiltRipples(stereo, 1), ConfigError);
}

}  // namespace
}  // namespace dockyard
