// Obstacles before a face, on disparities in closed form.
#include "controller/rocky7/face_obstacles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard::rocky7 {
namespace {

constexpr int kWidth = 320, kHeight = 240;

/// From 1.1 m up at a boulder of this height, 0.3 m wide, 1.6 m ahead, on ground that rises so.
/// err_rad: of the pitch that the mast's angles tell.
FaceView ViewOf(double boulder_m, double rise, double err_rad) {
  FaceView view;
  RectifiedPair& pair = view.pair;
  pair.width = kWidth;
  pair.height = kHeight;
  pair.focal_px = 400.0;
  pair.baseline_m = 0.2;
  pair.centre_px = {0.5 * kWidth, 0.5 * kHeight};
  const double down_rad = 0.6;
  Pose3 X_EC;
  // z of the camera is its optical axis, y points down.
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  X_EC.R = RotY(down_rad) * axes;
  X_EC.p = {0.0, 0.0, 1.1};
  view.disparities.width = kWidth;
  view.disparities.height = kHeight;
  view.disparities.px.assign(static_cast<std::size_t>(kWidth) * kHeight, std::nanf(""));
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray_C((u - pair.centre_px.x()) / pair.focal_px,
                                  (v - pair.centre_px.y()) / pair.focal_px, 1.0);
      const Eigen::Vector3d ray = X_EC.R * ray_C;
      double depth = -1.1 / (ray.z() - rise * ray.x());
      // The front of a box.
      const double front = 1.6 / ray.x();
      const Eigen::Vector3d at = X_EC.p + front * ray;
      const bool is_box =
          std::abs(at.y()) < 0.15 && at.z() > rise * 1.6 && at.z() < rise * 1.6 + boulder_m;
      if (is_box) depth = front;
      if (depth <= 0.0 || depth > 6.0) continue;
      view.disparities.px[static_cast<std::size_t>(v) * kWidth + u] =
          static_cast<float>(pair.focal_px * pair.baseline_m / depth);
    }
  }
  pair.X_RC = X_EC;
  pair.X_RC.R = RotY(err_rad) * X_EC.R;
  view.ground_rise = {0.0, 0.0};
  return view;
}

// Though the ground slopes, and the mast's joints are off by three degrees.
TEST(FaceObstacles, IsTheBoulderAndNotTheGroundAboutIt) {
  for (const double rise : {0.0, 0.1}) {
    for (const double err_rad : {0.0, 0.06, -0.06}) {
      FaceView view = ViewOf(0.3, rise, err_rad);
      view.ground_rise = {rise, 0.0};
      const std::vector<Eigen::Vector2d> cells =
          ObstaclesAbout(view, {1.6, 0.0, 1.6 * rise + 0.15});
      EXPECT_GE(cells.size(), 6u) << rise << " " << err_rad;
      for (const Eigen::Vector2d& cell : cells) {
        EXPECT_NEAR(cell.x(), 1.6, 0.09) << rise << " " << err_rad;
        EXPECT_LT(std::abs(cell.y()), 0.2);
      }
    }
  }
}

// Far ground matched wrongly: a patch that floats 0.57 m up, from the boulder 0.3 m towards the
// rover. In plan it is connected with the boulder.
TEST(FaceObstacles, APatchOfWrongRangesAboveTheGroundIsNone) {
  FaceView view = ViewOf(0.3, 0.0, 0.0);
  const RectifiedPair& pair = view.pair;
  int wrong = 0;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray =
          pair.X_RC.R *
          Eigen::Vector3d((u - pair.centre_px.x()) / 400.0, (v - pair.centre_px.y()) / 400.0, 1);
      const double depth_m = (0.57 - pair.X_RC.p.z()) / ray.z();
      const Eigen::Vector3d at = pair.X_RC.p + depth_m * ray;
      if (at.x() < 1.3 || at.x() > 1.65 || std::abs(at.y()) > 0.1) continue;
      view.disparities.px[static_cast<std::size_t>(v) * kWidth + u] =
          static_cast<float>(pair.focal_px * pair.baseline_m / depth_m);
      ++wrong;
    }
  }
  EXPECT_GT(wrong, 500);
  const std::vector<Eigen::Vector2d> cells = ObstaclesAbout(view, {1.6, 0.0, 0.15});
  EXPECT_GE(cells.size(), 6u);
  for (const Eigen::Vector2d& cell : cells) EXPECT_NEAR(cell.x(), 1.6, 0.09);
}

}  // namespace
}  // namespace dockyard::rocky7
