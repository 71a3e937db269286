#include "controller/geometry/camera.h"

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <vector>

namespace dockyard {
namespace {

// The constants of OpenCV's own fisheye test (modules/calib3d/test/test_fisheye.cpp).
KannalaBrandt OpenCvLens() {
  return {
      .fx = 558.478087865323,
      .fy = 560.506767351568,
      .cx = 620.458515360843,
      .cy = 381.939424848348,
      .k = {-0.0014613319981768, -0.00329861110580401, 0.00605760088590183, -0.00374209380722371}};
}

Camera OpenCvTestCamera() { return {.width = 1280, .height = 800, .lens = OpenCvLens()}; }

TEST(KannalaBrandt, ProjectsAsOpenCvDoes) {
  const KannalaBrandt lens = OpenCvLens();
  const cv::Matx33d K(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1);
  const cv::Vec4d D(lens.k[0], lens.k[1], lens.k[2], lens.k[3]);
  for (const double x : {-1.2, -0.3, 0.0, 0.8}) {
    for (const double y : {-0.9, 0.1, 0.7}) {
      const std::vector<cv::Point3d> points{{x, y, 1.0}};
      std::vector<cv::Point2d> pixels;
      cv::fisheye::projectPoints(points, pixels, cv::Vec3d(), cv::Vec3d(), K, D);
      const auto pixel = OpenCvTestCamera().Project({x, y, 1.0});
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x(), pixels[0].x, 1e-10);
      EXPECT_NEAR(pixel->y(), pixels[0].y, 1e-10);
    }
  }
}

TEST(KannalaBrandt, RayUndoesProjectFromNearToFar) {
  const Camera camera = OpenCvTestCamera();
  for (double u = 0.0; u < camera.width; u += 127.0) {
    for (double v = 0.0; v < camera.height; v += 133.0) {
      for (const double range_m : {0.3, 1.0, 5.0, 30.0}) {
        const Eigen::Vector2d pixel(u, v);
        const auto back = camera.Project(range_m * camera.Direction(pixel));
        ASSERT_TRUE(back);
        EXPECT_LT((*back - pixel).norm(), 1e-8);
      }
    }
  }
}

TEST(EquidistantCamera, SpreadsItsFieldOverTheImage) {
  const Camera camera = EquidistantCamera(1024, 768, Radians(90.0));
  const double middle = camera.centre_px().y();
  // The outer edges of the first and last pixel lie 45 deg off the axis.
  EXPECT_NEAR(std::acos(camera.Direction({-0.5, middle}).z()), Radians(45.0), 1e-12);
  EXPECT_NEAR(std::acos(camera.Direction({1023.5, middle}).z()), Radians(45.0), 1e-12);
}

TEST(EquidistantCamera, SeesNothingBehindIt) {
  const Camera camera = EquidistantCamera(640, 480, Radians(90.0));
  EXPECT_FALSE(camera.Project({0.0, 0.0, -1.0}));
  EXPECT_FALSE(camera.Project({0.1, 0.0, -1.0}));
  EXPECT_FALSE(camera.Project({0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace dockyard
