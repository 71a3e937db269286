// Rendered images of a board of tags before a camera, with the truth about them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// A board with one tag in its middle.
FiducialBoard OneTag(const std::string& family, int id, double size_m);

/// A pinhole without distortion.
Camera Pinhole(int width, int height, double horizontal_fov_rad);

/// Where a camera is before the board.
struct TagPlace {
  double range_m = 1.0;
  double yaw_rad = 0.0, pitch_rad = 0.0;  // from the board's normal, to its side and up
  double roll_rad = 0.0;                  // about the line of sight
  Eigen::Vector2d aim_rad{0, 0};          // of the board's middle off the axis, right and down
};

struct TagImage {
  GrayImage image;
  Camera camera;
  Pose3 X_CB;
};

/// @param key   the stream of the noise
/// @param view  its board is placed by `place`; what else it has, such as dust, stays
TagImage RenderTags(StereoRenderer& renderer, const BoardView& view, const Camera& camera,
                    const TagPlace& place, std::uint64_t key, double blur_sigma_px = 0.6);
TagImage RenderTags(StereoRenderer& renderer, const FiducialBoard& board, const Camera& camera,
                    const TagPlace& place, std::uint64_t key);

/// The image with a shade's edge over it: beyond a line through a pixel the light falls to a share
/// of what it was, along a penumbra of that width.
/// @param normal_rad  of the line, from x to y, towards the shade
GrayImage Shaded(const GrayImage& image, const Eigen::Vector2d& pixel, double normal_rad,
                 double penumbra_px, double share);

/// True pixels of a tag's corners.
std::array<Eigen::Vector2d, 4> TrueCorners(const TagImage& image, const SquareTag& tag);

}  // namespace dockyard
