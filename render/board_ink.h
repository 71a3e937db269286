// The printed board for one camera: which share of a pixel is ink, to a hair. No GL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "render/flat_view.h"
#include "render/scene.h"
#include "render/shading.h"

namespace dockyard {

/// Points of the tan plane where the corners of a pixel look: 00, 10, 01, 11.
using PixelCorners = std::array<Tan, 4>;

class BoardShader {
 public:
  BoardShader(const Scene& scene, const Pose3& X_WC, Channel channel);

  /// Radiance of a pixel that sees nothing but the board; share: of the sun.
  float operator()(const PixelCorners& corners, float share) const;
  /// Share of the pixel that is ink: each edge as its tangent, on four parts of an edge pixel.
  float InkShare(const PixelCorners& corners) const;

 private:
  struct Mark {
    float x, y, along_x, along_y;
  };
  Eigen::Vector2f ToBoard(Tan tan) const;
  float InkAt(const Mark& mark, const Eigen::Vector2f& p, const Eigen::Vector2f& step_x,
              const Eigen::Vector2f& step_y) const;

  std::vector<Mark> marks_;
  Eigen::Matrix3f board_from_tan_;  // homogeneous
  bool printed_side_ = true;
  float radius_, half_length_, half_width_;
  float white_sun_, white_around_, black_sun_, black_around_;  // radiance
};

}  // namespace dockyard
