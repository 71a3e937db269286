#include "controller/rocky7/ground_behind.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/nominal_rover.h"
#include "stereo/ray_scene.h"

namespace dockyard::rocky7 {
namespace {

// The rover's drawing with a back pair: the front one turned about, 0.1 m behind R.
Nominal WithBackPair() {
  Nominal nominal = NominalRover();
  const Pose3 turned{RotZ(kPi), Eigen::Vector3d(0.3, 0.0, 0.0)};
  nominal.back.X_RL = turned * nominal.front.X_RL;
  nominal.back.X_RQ = turned * nominal.front.X_RQ;
  return nominal;
}

std::vector<Eigen::Vector2d> ObstaclesBehind(double x, double y, double high_m) {
  const Nominal nominal = WithBackPair();
  RayScene scene;
  scene.stone = {x, y, 0.0};
  scene.stone_radius_m = high_m;
  const Pose3 X_up = Pose3::Translation(0.0, 0.0, nominal.rolling_radius_m);
  const StereoImages images{scene.Picture(nominal.back.left, X_up * nominal.back.X_RL),
                            scene.Picture(nominal.back.right, X_up * nominal.back.X_RQ)};
  return GroundBehind(nominal).Obstacles(images, {});
}

TEST(GroundBehind, FindsARockThatIsTooHighToPassAndNothingElse) {
  for (const auto& [x, y] : {std::pair{-0.6, 0.1}, {-0.8, -0.2}}) {
    const auto found = ObstaclesBehind(x, y, 0.1);
    EXPECT_GE(found.size(), 4u);
    for (const Eigen::Vector2d& place : found) {
      EXPECT_LT((place - Eigen::Vector2d(x, y)).norm(), 0.12) << place.transpose();
    }
  }
  EXPECT_TRUE(ObstaclesBehind(-0.6, 0.1, 0.04).empty());
}

}  // namespace
}  // namespace dockyard::rocky7
