// The blur of one view against closed forms.
#include "render/motion_blur.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

namespace dockyard {
namespace {

// Against the projection itself, at pixels in the whole image and at several depths.
TEST(MotionBlur, ShiftIsThatOfTheProjection) {
  for (const Camera& camera : {EquidistantCamera(640, 480, Radians(90.0)),
                               Camera{640, 480, BrownPinhole{500, 510, 320, 240, -0.1, 0.02}}}) {
    const ExposureMotion motion{{4e-5, -2e-5, 6e-5}, {3e-5, 5e-5, -4e-5}};
    const Eigen::Matrix3d R_C1C2 =
        Eigen::AngleAxisd(motion.turn_rad.norm(), motion.turn_rad.normalized()).matrix();
    for (const double depth_m : {0.4, 2.0, 30.0}) {
      for (const Eigen::Vector2d& pixel : {Eigen::Vector2d{319, 241}, {20, 30}, {600, 100}}) {
        const Eigen::Vector3d ray = camera.Direction(pixel);
        const Eigen::Vector3d p_C1 = ray * (depth_m / ray.z());
        const Eigen::Vector3d p_C2 = R_C1C2.transpose() * (p_C1 - motion.shift_m);
        const Eigen::Vector2d moved = *camera.Project(p_C2) - pixel;
        const Eigen::Vector2d shift = ImageShift_px(camera, motion, pixel, 1.0 / depth_m);
        EXPECT_NEAR((shift - moved).norm(), 0.0, 1e-3 * moved.norm() + 1e-6) << depth_m;
      }
    }
  }
}

TEST(MotionBlur, CameraOnALeverMovesWithItsBody) {
  const Pose3 X_BC{Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()).matrix(), {0.2, 0.0, 0.1}};
  const ExposureMotion of_camera = MotionOfCamera({{0.01, 0, 0}, {0, 0, 0.05}}, X_BC);
  // The camera's origin goes by 0.01 m along x and by 0.05 rad of 0.2 m along y.
  EXPECT_NEAR((X_BC.R * of_camera.shift_m - Eigen::Vector3d(0.01, 0.01, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((X_BC.R * of_camera.turn_rad - Eigen::Vector3d(0, 0, 0.05)).norm(), 0.0, 1e-12);
}

// An edge under a lens of 0.6 px that moves across the image in any direction. Its profile after
// the blur is that of a box of d |cos| px, convolved with the lens.
TEST(MotionBlur, EdgeIsThatOfABoxUnderTheLens) {
  constexpr int kSize = 64;
  constexpr double kSigma_px = 0.6;
  const Camera camera = EquidistantCamera(kSize, kSize, Radians(4.0));
  const double f = camera.focal_px().x();
  const auto edge = [&](double x) {
    return 0.5 * std::erfc(-x / (kSigma_px * std::numbers::sqrt2));
  };
  for (const double edge_angle : {0.0, 0.4, 0.785, 1.2}) {
    for (const double motion_angle : {0.0, 0.3, 0.785, 1.57, 2.4}) {
      for (const double d : {0.3, 0.5, 0.85}) {
        const auto across = [&](int x, int y) {
          return std::cos(edge_angle) * (x - 31.7) + std::sin(edge_angle) * (y - 31.2);
        };
        RadianceImage image{.width = kSize, .height = kSize, .values = {}, .inverse_depth = {}};
        for (int i = 0; i < kSize * kSize; ++i) {
          image.values.push_back(static_cast<float>(edge(across(i % kSize, i / kSize))));
        }
        image.inverse_depth.assign(image.values.size(), 0.0f);
        // Turning by w about y moves things by -w f along u, about x by w f along v.
        const Eigen::Vector3d turn_rad(d * std::sin(motion_angle) / f,
                                       -d * std::cos(motion_angle) / f, 0);
        BlurByMotion(camera, {{0, 0, 0}, turn_rad}, image);
        const double along = d * std::cos(motion_angle - edge_angle);
        double worst = 0.0, sharp = 0.0;
        for (int y = 4; y < kSize - 4; ++y) {
          for (int x = 4; x < kSize - 4; ++x) {
            double box = 0.0;
            constexpr int kFine = 50;
            for (int i = 0; i < kFine; ++i) {
              box += edge(across(x, y) + ((i + 0.5) / kFine - 0.5) * along) / kFine;
            }
            worst = std::max(worst, std::abs(image.at(x, y) - box));
            sharp = std::max(sharp, std::abs(edge(across(x, y)) - box));
          }
        }
        EXPECT_LT(worst, 0.005) << edge_angle << " " << motion_angle << " " << d << " sharp "
                                << sharp;
      }
    }
  }
}

TEST(MotionBlur, LightIsKeptAndNearThingsAreWidenedMore) {
  constexpr int kSize = 64;
  const Camera camera = EquidistantCamera(kSize, kSize, Radians(20.0));
  // Two spots of one size: the left one is at 0.5 m, the right one at 2 m.
  RadianceImage image{.width = kSize, .height = kSize, .values = {}, .inverse_depth = {}};
  const auto spot = [](double x, double y) {
    return std::exp(-(x * x + y * y) / (2.0 * 1.5 * 1.5));
  };
  for (int i = 0; i < kSize * kSize; ++i) {
    const int x = i % kSize, y = i / kSize;
    image.values.push_back(static_cast<float>(spot(x - 16, y - 32) + spot(x - 48, y - 32)));
    image.inverse_depth.push_back(x < 32 ? 2.0f : 0.5f);
  }
  const double shift_m = 2.0 / camera.focal_px().x();  // 4 px at 0.5 m would be cut; 1 px at 2 m
  BlurByMotion(camera, {{0.25 * shift_m, 0, 0}, {0, 0, 0}}, image);
  for (const auto& [left, d] : {std::pair{0, 1.0}, {32, 0.25}}) {
    double sum = 0.0, second = 0.0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = left; x < left + 32; ++x) {
        sum += image.at(x, y);
        second += image.at(x, y) * std::pow(x - left - 16, 2);
      }
    }
    EXPECT_NEAR(sum, 2.0 * std::numbers::pi * 1.5 * 1.5, 1e-3);
    EXPECT_NEAR(second / sum, 1.5 * 1.5 + d * d / 12.0, 0.01 * d * d) << d;
  }
}

}  // namespace
}  // namespace dockyard
