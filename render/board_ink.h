// The printed board for one camera: the exact share of each pixel that is ink. No GL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "render/pixel_row.h"
#include "render/scene.h"
#include "render/shading.h"

namespace dockyard {

/// Share of the face covered with dust at a place of the board [m]: patches of 2 and 8 cm about the
/// mean (assumed).
float DustShare(const BoardView& board, const Eigen::Vector2f& p_B);

class BoardShader {
 public:
  BoardShader(const Scene& scene, const Pose3& X_WC, Channel channel);

  /// Radiance of a pixel that sees nothing but the board; share: of the sun.
  float operator()(const PixelCorners& corners, float share) const;
  /// Of pixels first to first + count - 1 of a row, at most kBoardAtOnce; shares: of the sun.
  void Row(const PixelRow& row, int first, int count, const float* shares, float* radiance) const;
  /// Share of the pixel that is ink: each edge as its tangent, on four parts of an edge pixel.
  float InkShare(const PixelCorners& corners) const;

 private:
  struct Mark {
    float x, y, along_x, along_y;
  };
  Eigen::Vector2f ToBoard(Tan tan) const;
  bool Dusty() const {
    return printed_side_ && (view_.dust_cover > 0.0 || !view_.dusty_spots.empty());
  }
  /// Which of the pixels are so near a mark that they may hold ink: 1, else 0.
  void NearMarks(const PixelRow& row, int first, int count, std::uint8_t* near) const;
  float InkAt(const Mark& mark, const Eigen::Vector2f& p, const Eigen::Vector2f& step_x,
              const Eigen::Vector2f& step_y) const;

  std::vector<Mark> marks_;
  Eigen::Matrix3f board_from_tan_;  // homogeneous
  bool printed_side_ = true;
  float radius_, half_length_, half_width_;
  float white_sun_, white_around_, black_sun_, black_around_, dust_sun_, dust_around_;  // radiance
  const BoardView& view_;
};

}  // namespace dockyard
