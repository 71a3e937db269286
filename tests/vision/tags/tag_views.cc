#include "vision/tags/tag_views.h"

#include <algorithm>
#include <cmath>

#include "controller/vision/tags/tag_code.h"
#include "render/scene_samples.h"

namespace dockyard {

FiducialBoard OneTag(const std::string& family, int id, double size_m) {
  FiducialBoard board{.width_m = 2.0 * size_m, .height_m = 2.0 * size_m, .fiducials = {}};
  board.tags.push_back({.family = family, .id = id, .size_m = size_m});
  SetTagCells(board);
  return board;
}

Camera Pinhole(int width, int height, double horizontal_fov_rad) {
  const double f = 0.5 * width / std::tan(0.5 * horizontal_fov_rad);
  return {width, height,
          BrownPinhole{.fx = f, .fy = f, .cx = 0.5 * (width - 1), .cy = 0.5 * (height - 1)}};
}

TagImage RenderTags(StereoRenderer& renderer, const BoardView& view, const Camera& camera,
                    const TagPlace& place, std::uint64_t key, double blur_sigma_px) {
  Scene scene = BoardOnly();
  const Pose3 X_WB = scene.boards[0].X_WB;
  scene.boards[0] = view;
  scene.boards[0].X_WB = X_WB;
  // The camera before the board, then turned off the line of sight.
  const Pose3 X_BS{RotY(place.yaw_rad) * RotX(place.pitch_rad) * RotZ(place.roll_rad),
                   Eigen::Vector3d::Zero()};
  const Pose3 X_SC{RotY(-place.aim_rad.x()) * RotX(place.aim_rad.y()),
                   Eigen::Vector3d(0, 0, -place.range_m)};
  const Pose3 X_BC = X_BS * X_SC;
  const StereoRig rig{.left = camera,
                      .right = camera,
                      .X_RL = X_WB * X_BC,
                      .X_RQ = X_WB * X_BC * Pose3::Translation(0.05, 0, 0)};
  SensorOptions sensor;
  sensor.blur_sigma_px = blur_sigma_px;
  sensor.noise_key = key;
  return {.image = renderer.Render(scene, rig, {}, sensor).left,
          .camera = camera,
          .X_CB = Inverse(X_BC)};
}

TagImage RenderTags(StereoRenderer& renderer, const FiducialBoard& board, const Camera& camera,
                    const TagPlace& place, std::uint64_t key) {
  return RenderTags(renderer, BoardView{.board = board, .X_WB = {}, .dusty_spots = {}}, camera,
                    place, key);
}

GrayImage Shaded(const GrayImage& image, const Eigen::Vector2d& pixel, double normal_rad,
                 double penumbra_px, double share) {
  GrayImage shaded = image;
  const Eigen::Vector2d normal(std::cos(normal_rad), std::sin(normal_rad));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double into = normal.dot(Eigen::Vector2d(x, y) - pixel) / penumbra_px + 0.5;
      const double light = 1.0 - (1.0 - share) * std::clamp(into, 0.0, 1.0);
      shaded.pixels[static_cast<std::size_t>(y * image.width + x)] =
          static_cast<std::uint8_t>(std::lround(light * image.at(x, y)));
    }
  }
  return shaded;
}

std::array<Eigen::Vector2d, 4> TrueCorners(const TagImage& image, const SquareTag& tag) {
  std::array<Eigen::Vector2d, 4> pixels;
  const auto corners_B = CornersOf(tag);
  for (std::size_t k = 0; k < 4; ++k) {
    pixels[k] = *image.camera.Project(image.X_CB *
                                      Eigen::Vector3d(corners_B[k].x(), corners_B[k].y(), 0.0));
  }
  return pixels;
}

}  // namespace dockyard
