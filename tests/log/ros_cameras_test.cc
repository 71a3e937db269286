// What rectifies a pair's images: points of the world fall on one row, apart by f B / z.
#include "sim/log/ros_cameras.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

/// z ahead along the body's x, x to its right, y down.
Eigen::Matrix3d Ahead() {
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return R;
}

NamedCamera At(const std::string& name, const Eigen::Vector3d& p, const Eigen::Matrix3d& R) {
  return {name, EquidistantCamera(640, 480, Radians(90.0)), {R, p}, "robot"};
}

/// The pixel of a point of the body by a camera's R and P, as image_geometry reckons it.
Eigen::Vector2d Pixel(const NamedCamera& left, const RosRectification& how,
                      const RosRectification& of_left, const Eigen::Vector3d& p_O) {
  // P is of points in the left camera's rectified frame, for both cameras of a pair.
  const Eigen::Vector3d p = of_left.R * (left.X_OC.R.transpose() * (p_O - left.X_OC.p));
  const Eigen::Vector3d uvw = how.P * p.homogeneous();
  return uvw.hnormalized();
}

TEST(RosRectification, OfAParallelPairIsTheBaselineInTheRightCamerasP) {
  const std::vector<NamedCamera> cameras{At("left", {0.1, 0.175, 0.2}, Ahead()),
                                         At("right", {0.1, -0.175, 0.2}, Ahead())};
  const auto all = RectificationsOf(cameras);
  const double f = 640.0 / (kPi / 2.0);
  EXPECT_EQ(all[0].R, Eigen::Matrix3d::Identity());
  EXPECT_EQ(all[1].R, Eigen::Matrix3d::Identity());
  EXPECT_NEAR(all[0].P(0, 0), f, 1e-9);
  EXPECT_EQ(all[0].P(0, 3), 0.0);
  EXPECT_NEAR(all[1].P(0, 3), -f * 0.35, 1e-9);
}

TEST(RosRectification, OfATurnedPairBringsPointsOntoOneRow) {
  const Eigen::Matrix3d toe_in = RotZ(Radians(-3.0)) * Ahead();
  const Eigen::Matrix3d tilted = RotY(Radians(2.0)) * RotZ(Radians(4.0)) * Ahead();
  const std::vector<NamedCamera> cameras{At("left", {0, 0.1, 0}, toe_in),
                                         At("right", {0.01, -0.1, 0.005}, tilted)};
  const auto all = RectificationsOf(cameras);
  const double baseline_m = (cameras[1].X_OC.p - cameras[0].X_OC.p).norm();
  for (const Eigen::Vector3d& p_O : {Eigen::Vector3d(2, 0.3, 0.1), {5, -0.4, -0.2}}) {
    // Each camera's own frame, turned by its R, has the same axes.
    const Eigen::Vector3d in_left =
        all[0].R * cameras[0].X_OC.R.transpose() * (p_O - cameras[0].X_OC.p);
    const Eigen::Vector3d in_right =
        all[1].R * cameras[1].X_OC.R.transpose() * (p_O - cameras[1].X_OC.p);
    EXPECT_NEAR(in_left.y(), in_right.y(), 1e-12);
    EXPECT_NEAR(in_left.z(), in_right.z(), 1e-12);
    EXPECT_NEAR(in_left.x() - in_right.x(), baseline_m, 1e-12);
    const Eigen::Vector2d left = Pixel(cameras[0], all[0], all[0], p_O);
    const Eigen::Vector2d right = Pixel(cameras[0], all[1], all[0], p_O);
    EXPECT_NEAR(left.y(), right.y(), 1e-9);
    EXPECT_NEAR(left.x() - right.x(), all[0].P(0, 0) * baseline_m / in_left.z(), 1e-9);
  }
}

TEST(RosRectification, OfCamerasThatAreNoPairIsTheirOwn) {
  std::vector<NamedCamera> cameras{At("left", {0, 0.1, 0}, Ahead()), At("back", {0, 0, 0}, Ahead()),
                                   At("mast_right", {0, -0.1, 0}, Ahead())};
  cameras.push_back(At("right", {0, -0.1, 0}, Ahead()));
  cameras.back().body = "arm";  // it moves against the left one
  for (const RosRectification& each : RectificationsOf(cameras)) {
    EXPECT_EQ(each.R, Eigen::Matrix3d::Identity());
    EXPECT_EQ(each.P(0, 3), 0.0);
  }
}

}  // namespace
}  // namespace dockyard
