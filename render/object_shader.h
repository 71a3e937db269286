// Shares of the sun on objects and boards for one camera, and the stains of objects. No GL.
#pragma once

#include <array>
#include <vector>

#include "render/flat_view.h"
#include "render/ground_horizon.h"
#include "render/object_stains.h"
#include "render/pixel_row.h"
#include "render/scene.h"
#include "render/sun_shadow.h"

namespace dockyard {

/// So many pixels that each met one facet of an object are shaded at once at most.
inline constexpr int kFacetsAtOnce = kBoardAtOnce;

/// Those pixels: the facet's normal in light axes, where the view's rays point, and 1/z there.
struct FacetRow {
  std::array<float, kFacetsAtOnce> n_x, n_y, n_z, from_x, from_y, inverse_depth;
};

class ObjectShader {
 public:
  /// scene and shadow must outlive this. highest_m: of the scene's ground.
  ObjectShader(const Scene& scene, double highest_m, const SunShadow& shadow, const Pose3& X_WC);

  /// Albedo of an object over its mean where the view's ray (tan, 1) meets it, in a pixel of the
  /// image whose own ray is (ray, 1); n: its normal in light axes.
  float Stain(std::size_t object, Tan tan, Tan ray, float inverse_depth, const Eigen::Vector3f& n,
              const Pixel& pixel) const;
  bool HasStains(std::size_t object) const { return stains_[object].any(); }
  /// Share of the sun in sight of an object where the ray meets it; n: its normal in light axes.
  float SunShare(Tan tan, float inverse_depth, const Eigen::Vector3f& n, const Pixel& pixel) const;
  /// The same where the ray meets a board's plane.
  float BoardShare(std::size_t board, Tan tan, const Pixel& pixel) const;
  /// The same of pixels first to first + count - 1 of a row, at most kBoardAtOnce, all of whose
  /// rays met the board.
  void BoardShares(std::size_t board, const PixelRow& row, int first, int count,
                   float* shares) const;
  /// SunShare of pixels first to first + count - 1 of a row, at most kFacetsAtOnce, each of which
  /// met one facet. Where a normal is turned away from the sun the share has no meaning.
  void FacetShares(const FacetRow& facets, const PixelRow& row, int first, int count,
                   float* shares) const;
  /// 1/z of a board's plane: the product with (tan, 1).
  const Eigen::Vector3f& BoardPlane(std::size_t board) const { return boards_[board].plane_C; }

 private:
  struct Board {
    Eigen::Vector3f n_U;  // of the side that the camera faces
    Eigen::Vector3f plane_C;
    bool in_plane;  // of the shadow's TakePlane
  };
  // Places on surfaces, in the camera's frame, and how the surfaces rise towards the sun.
  struct Places {
    std::array<float, kBoardAtOnce> x, y, z, slope_x, slope_y;
  };
  struct Fineness {
    float bias_m;
    int searches, points;
    bool in_plane = false;
  };
  // Share of each place, whose pixels begin at `first` of a row.
  void SharesAt(const Places& places, const Fineness& fineness, const PixelRow& row, int first,
                int count, float* shares) const;
  float Share(Tan tan, float inverse_depth, const Eigen::Vector3f& n, float bias,
              const Pixel& pixel, int searches, int points, bool in_plane = false) const;

  const SunShadow& shadow_;
  GroundHorizon horizon_;
  std::vector<ObjectStains> stains_;
  std::vector<Board> boards_;
  Eigen::Matrix3f R_UC_, R_GC_;
  Eigen::Vector3f p_UC_, p_GC_;
};

}  // namespace dockyard
