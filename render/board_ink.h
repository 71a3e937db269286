// The printed board for one camera: the exact share of each pixel that is ink. No GL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/bent_plate.h"
#include "render/pixel_row.h"
#include "render/scene.h"
#include "render/scene_light.h"
#include "render/shading.h"
#include "render/tag_ink.h"

namespace dockyard {

/// Share of the face covered with dust at a place of the board [m]: patches of 2 and 8 cm about the
/// mean (assumed).
float DustShare(const BoardView& board, const Eigen::Vector2f& p_B);

/// Radiance of a board's paints: in the whole sun, the part that the sun adds, and without it.
template <typename Value>
struct BoardLight {
  struct Paint {
    Value sun{}, around{};
  };
  Paint white, black, dust;
};

class BoardShader {
 public:
  /// board must outlive this.
  BoardShader(const BoardView& board, const Pose3& X_WC);

  template <typename Value>
  BoardLight<Value> LightOf(const typename SceneLight<Value>::Paints& paints,
                            const SunAndSky& sky) const {
    const auto to_sun = static_cast<float>(normal_W_.dot(sky.to_sun_W));
    const auto to_zenith = static_cast<float>(normal_W_.z());
    const auto paint = [&](const SurfaceLight<Value>& on) {
      const Value around = Shade(on.sun, on.sky, on.bounce, to_sun, to_zenith, 0.0f);
      const Value all = Shade(on.sun, on.sky, on.bounce, to_sun, to_zenith, 1.0f);
      return typename BoardLight<Value>::Paint{.sun = all - around, .around = around};
    };
    return {paint(paints.white), paint(paints.black), paint(paints.dust)};
  }

  /// Radiance of a pixel that shows nothing but the board; share: of the sun.
  template <typename Value>
  Value At(const PixelCorners& corners, float share, const BoardLight<Value>& light) const {
    const float ink = InkShare(corners);
    const Value clean = (1.0f - ink) * (light.white.around + share * light.white.sun) +
                        ink * (light.black.around + share * light.black.sun);
    if (!Dusty()) return clean;
    return clean + DustAt(corners) * (light.dust.around + share * light.dust.sun - clean);
  }
  /// Of pixels first to first + count - 1 of a row, at most kBoardAtOnce; shares: of the sun.
  template <typename Value>
  void Row(const PixelRow& row, int first, int count, const float* shares,
           const BoardLight<Value>& light, Value* radiance) const {
    std::uint8_t near[kBoardAtOnce];
    NearMarks(row, first, count, near);
    const bool dusty = Dusty();
    for (int i = 0; i < count; ++i) {
      radiance[i] = dusty || near[i] != 0 ? At(row.At(first + i).corners(), shares[i], light)
                                          : light.white.around + shares[i] * light.white.sun;
    }
  }
  /// Share of the pixel that is ink. Discs: each edge as its tangent, on four parts of an edge
  /// pixel; tags: areas of polygons. Less what has flaked off.
  float InkShare(const PixelCorners& corners) const;
  /// Of the side that the camera faces; of a bent board in the mean.
  const Eigen::Vector3d& normal_W() const { return normal_W_; }
  bool bent() const { return bent_.has_value(); }
  /// Where a ray meets a bent board, and its normal there on the camera's side, in the camera's
  /// frame.
  struct Spot {
    Eigen::Vector3f p_C, n_C;
  };
  Spot SpotAt(Tan tan) const;

 private:
  struct Mark {
    float x, y, along_x, along_y;
  };
  Eigen::Vector2f ToBoard(Tan tan) const;
  float DiscShare(const PixelCorners& corners) const;
  float TagShare(const std::array<Eigen::Vector2f, 4>& footprint_B) const;
  std::array<Eigen::Vector2f, 4> Footprint(const PixelCorners& corners) const;
  float DustAt(const PixelCorners& corners) const;
  bool Dusty() const {
    return printed_side_ && (view_.dust_cover > 0.0 || !view_.dusty_spots.empty());
  }
  /// Which of the pixels are so near a mark that they may hold ink: 1, else 0.
  void NearMarks(const PixelRow& row, int first, int count, std::uint8_t* near) const;
  float InkAt(const Mark& mark, const Eigen::Vector2f& p, const Eigen::Vector2f& step_x,
              const Eigen::Vector2f& step_y) const;

  std::vector<Mark> marks_;  // of tags: their middles, radius_ that of the largest
  std::vector<TagInk> tags_;
  Eigen::Matrix3f board_from_tan_;  // homogeneous
  std::optional<BentPlate> bent_;   // of a bent board
  Pose3 X_BC_;
  bool printed_side_ = true;
  float radius_, half_length_, half_width_;
  Eigen::Vector3d normal_W_;
  const BoardView& view_;
};

}  // namespace dockyard
