// Light of objects and thin bodies for one camera, and the board's share of the sun. No GL.
#pragma once

#include <vector>

#include "render/flat_view.h"
#include "render/ground_horizon.h"
#include "render/object_stains.h"
#include "render/pixel_row.h"
#include "render/scene.h"
#include "render/shading.h"
#include "render/sun_shadow.h"

namespace dockyard {

class ObjectShader {
 public:
  /// scene and shadow must outlive this. highest_m: of the scene's ground.
  ObjectShader(const Scene& scene, double highest_m, const SunShadow& shadow, const Pose3& X_WC,
               Channel channel);

  /// Radiance of an object where the view's ray (tan, 1) meets it, in a pixel of the image whose
  /// own ray is (ray, 1).
  float operator()(const Seen& seen, Tan tan, Tan ray, const Pixel& pixel) const;
  /// Albedo there over the object's mean albedo; n: its normal in light axes.
  float Stain(std::size_t object, Tan tan, Tan ray, float inverse_depth, const Eigen::Vector3f& n,
              const Pixel& pixel) const;
  /// Share of the sun where the ray meets the board's plane.
  float BoardShare(Tan tan, const Pixel& pixel) const;
  /// The same of pixels first to first + count - 1 of a row, at most kBoardAtOnce, all of whose
  /// rays met the board.
  void BoardShares(const PixelRow& row, int first, int count, float* shares) const;
  /// Radiance times cover of one of the scene's ThinBodies.
  float OfThin(std::size_t body, const Thin& thin, Tan tan, const Pixel& pixel) const;
  /// Share of the sun in sight of an object where the ray meets it; n: its normal in light axes.
  float SunShare(Tan tan, float inverse_depth, const Eigen::Vector3f& n, const Pixel& pixel) const;

 private:
  struct Floats {
    float sun, sky, bounce;
  };
  static Floats ToFloats(const Scene& scene, const Eigen::Vector3d& albedo, Channel channel);
  float Share(Tan tan, float inverse_depth, const Eigen::Vector3f& n, float bias,
              const Pixel& pixel, int searches, int points, bool of_board = false) const;

  const SunShadow& shadow_;
  GroundHorizon horizon_;
  SeenBits bits_;
  std::vector<Floats> thin_, objects_;
  std::vector<ObjectStains> stains_;
  Eigen::Matrix3f R_UC_, R_GC_;
  Eigen::Vector3f p_UC_, p_GC_, up_U_, n_board_U_, board_plane_C_;
};

}  // namespace dockyard
