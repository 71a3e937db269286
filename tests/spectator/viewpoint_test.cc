#include "sim/spectator/viewpoint.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

TEST(PoseAimedAt, PutsTheCentreInTheMiddleAndTheWorldsUpwardsUp) {
  const Camera camera = PinholeCamera(640, 360, 0.6);
  const Eigen::Vector3d eye(3.0, -2.0, 1.5), centre(0.5, 0.3, 0.2);
  const Pose3 X_CW = Inverse(PoseAimedAt(eye, centre));
  const Eigen::Vector2d middle = *camera.Project(X_CW * centre);
  EXPECT_NEAR(middle.x(), 319.5, 1e-9);
  EXPECT_NEAR(middle.y(), 179.5, 1e-9);
  const Eigen::Vector2d above = *camera.Project(X_CW * (centre + Eigen::Vector3d(0, 0, 0.1)));
  EXPECT_NEAR(above.x(), 319.5, 1e-9);
  EXPECT_LT(above.y(), 179.5);
  // To the right of one who looks from the eye to the centre: forwards x upwards.
  const Eigen::Vector3d right = (centre - eye).cross(Eigen::Vector3d::UnitZ()).normalized();
  EXPECT_GT(camera.Project(X_CW * (centre + 0.1 * right))->x(), 320.0);
}

TEST(PinholeCamera, SpansItsFieldOverItsHeight) {
  const Camera camera = PinholeCamera(640, 360, 0.6);
  const Eigen::Vector2d edge = *camera.Project({0.0, std::tan(0.3), 1.0});
  EXPECT_NEAR(edge.y(), 359.5, 1e-9);
}

TEST(SpectatorPose, SeesEveryPlaceFromTheTargetsFrontAndTheSunsSide) {
  const Camera camera = PinholeCamera(960, 540, 0.55);
  for (const double heading : {0.0, 1.3, -2.5}) {
    for (const double sun : {0.4, -0.4}) {
      Sights sights;
      sights.X_WD = {4.0, -1.0, heading};
      const Pose3 X_WD = FromGround(sights.X_WD, 0.0);
      for (const double x : {0.0, 1.0, 3.0, 5.0}) {
        sights.places_W.push_back(X_WD * Eigen::Vector3d(x, 0.2 * x, 0.0));
      }
      sights.to_sun_W = X_WD.R * Eigen::Vector3d(0.1, sun, 0.9).normalized();
      const Pose3 X_WC = SpectatorPose(sights, camera, std::nullopt);
      for (const Eigen::Vector3d& place : sights.places_W) {
        const auto pixel = camera.Project(Inverse(X_WC) * place);
        ASSERT_TRUE(pixel.has_value());
        EXPECT_TRUE(camera.Sees(*pixel, 10.0)) << heading << " " << place.transpose();
      }
      const Eigen::Vector3d eye_D = Inverse(X_WD) * X_WC.p;
      EXPECT_GT(eye_D.x(), 0.0);
      EXPECT_GT(eye_D.y() * sun, 0.0);
      EXPECT_GT(eye_D.z(), 0.5);
    }
  }
}

TEST(SpectatorPose, StandsWhereItIsTold) {
  Sights sights;
  sights.X_WD = {1.0, 2.0, kPi / 2.0};
  sights.places_W = {{1.0, 4.0, 0.0}};
  const Pose3 X_WC =
      SpectatorPose(sights, PinholeCamera(64, 64, 0.5), Eigen::Vector3d(2.0, 0.5, 1.0));
  EXPECT_NEAR((X_WC.p - Eigen::Vector3d(0.5, 4.0, 1.0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace dockyard
