// The share of the sun's disc that a place sees, from the shadow map. No GL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "controller/geometry/pose.h"
#include "render/four_floats.h"
#include "render/shadow_blocks.h"
#include "render/surface_mesh.h"

namespace dockyard {

/// A square of the plane across the sun's rays.
struct ShadowWindow {
  Eigen::Vector2d center_m{0, 0};  // in light axes U
  double half_m = 1.0;
  int texels = 0;  // a side
  int column = 0;  // where it begins in the atlas

  double texel_m() const { return 2.0 * half_m / texels; }
};

/// Light axes U: z towards the sun; origin at the interest, so that floats stay small.
struct ShadowFit {
  Pose3 X_WU;
  ShadowWindow coarse, fine;
  double top_m = 1.0, bottom_m = 0.0;  // along z, all casters in between
};

inline constexpr int kCoarseTexels = 1536;
inline constexpr int kFineTexels = 768;
/// With a few columns more: rows a multiple of 4 KB apart would share the first cache's places.
constexpr int AtlasWidth(int coarse_texels, int fine_texels) {
  return coarse_texels + fine_texels + 16;
}
inline constexpr int kAtlasWidth = AtlasWidth(kCoarseTexels, kFineTexels),
                     kAtlasHeight = kCoarseTexels;

/// How fine the map is and how much it covers. Texels: multiples of 8.
struct ShadowDetail {
  int coarse_texels = kCoarseTexels, fine_texels = kFineTexels;
  double near_m = 4.0;  // round robot and interest, what the cameras see in detail
};

/// casters_W: balls round everything that casts. interest: the board's centre and half diagonal,
/// or another ball of interest. The fine window keeps texels of at most 3 mm on boards up to 1.9 m
/// across.
ShadowFit FitShadow(const std::vector<Ball>& casters_W, const Ball& interest_W, const Pose3& X_WR,
                    const Eigen::Vector3d& to_sun_W, const ShadowDetail& detail = {});

class SunShadow {
 public:
  /// Takes a new map: depth 0 at fit.top_m towards the sun, 1 at fit.bottom_m and without a
  /// caster.
  void Take(const ShadowFit& fit, double sun_angular_diameter_rad);
  /// No map: all places see the whole sun.
  void TakeNone(const ShadowFit& fit);
  /// Of the map taken last: a plane in U in which many places lie, the board's. What stands over it
  /// is bounded tile by tile, so that its sunlit parts need no points.
  void TakePlane(const Eigen::Vector3d& p_U, const Eigen::Vector3d& normal_U);
  /// Room for the map, row by row; of kAtlasWidth x kAtlasHeight until Resize.
  std::vector<float>& depth() { return depth_; }
  /// Room for a map of this fit: AtlasWidth(...) x coarse texels.
  void Resize(const ShadowFit& fit);
  const ShadowFit& fit() const { return fit_; }

  /// How a surface rises towards the sun along U's x and y.
  struct Slopes {
    float x = 0.0f, y = 0.0f;
  };
  /// n: its normal in U. A surface that the sun grazes is taken as less steep than it is.
  static Slopes SlopesOf(const Eigen::Vector3f& n) {
    const float per_z = -1.0f / (n.z() > kLeastCosine ? n.z() : kLeastCosine);
    return {n.x() * per_z, n.y() * per_z};
  }
  static constexpr float kLeastCosine = 0.12f;
  /// Share of the sun in sight of a place on a surface.
  struct Place {
    Eigen::Vector3f p;  // in U
    Slopes slopes;      // of the surface
    float bias_m;       // how far over the surface a caster counts
    float blur_m;       // radius over which the share is averaged: the pixel's own
    // How long the pixel's footprint is, where that is much more than its width; else zero.
    Eigen::Vector3f length{0, 0, 0};
    // Of the image: neighbouring pixels turn the points of the sun's disc by different angles.
    int pixel_x, pixel_y;
    bool in_plane = false;  // in that of TakePlane
  };
  static constexpr int kMostPoints = 16;
  /// searches, points: of the disc, to find casters and to measure their cover; 1 to kMostPoints.
  float Share(const Place& place, int searches, int points) const {
    const float plain = Plain(place);
    return plain >= 0.0f ? plain : Partly(place, searches, points);
  }
  /// The share where all casters near agree, without any point; else -1.
  float Plain(const Place& place) const;
  /// The share by points, whatever the result of Plain.
  float Partly(const Place& place, int searches, int points) const;

  /// Places side by side, as arrays: see Place.
  struct Places {
    const float *p_x, *p_y, *p_z, *slope_x, *slope_y;
    const float* blur_m = nullptr;  // with it, of places without a length, more is found
  };
  /// What Plain gives for each of count places with one bias; with a blur also what blocks of
  /// texels tell.
  void PlainOf(const Places& places, int count, float bias_m, bool in_plane, float* shares) const;

  SunShadow();

 private:
  static constexpr int kTile = 8;                      // texels a side
  static constexpr int kSpread = 2;                    // tiles round a place that its bounds cover
  static constexpr float kMaxReach = kTile * kSpread;  // texels
  static constexpr float kBoundsReach = kTile * (kSpread + 1);  // texels
  static constexpr float kEdge = kMaxReach + 2.0f;  // texels next to the border, not used
  static constexpr float kNoCaster = ShadowBlocks::kNoCaster;
  struct Bounds {
    float highest = 0.0f, lowest = 0.0f;  // caster over a tile and those around it, along U's z [m]
  };
  struct Window {
    float center_x, center_y, texel_m, per_texel, middle, last;
    int column;
  };
  static constexpr int kTurns = 256;
  static constexpr int kMostFours = kMostPoints / 4;
  /// Points of a disc of radius 1, four at once.
  struct Disc {
    std::array<Four, kMostFours> x{}, y{};
  };
  using Gaps = std::array<Four, kMostFours>;

  static int Turn(int pixel_x, int pixel_y);
  void ReduceTiles();
  // Bounds over each tile and those up to so many tiles away. from and to may be one.
  static void Spread(const std::vector<Bounds>& from, int tiles, int wide, int high,
                     std::vector<Bounds>& room, std::vector<Bounds>& to);
  // A place in a window of the map; none: outside.
  struct Spot {
    const Window* window = nullptr;
    float x = 0.0f, y = 0.0f;  // in its texels
    float sway = 0.0f;         // how far the surface leaves the level within its bounds
  };
  Spot SpotOf(const Place& place) const;
  std::size_t TileAt(const Spot& spot) const;
  // The share where all casters as near as the points can lie agree, without any point; else -1.
  float PlainNear(const Spot& spot, const Place& place, float reach) const;
  // The same by a block of texels, where the place before had the surface's slopes. x, y: as of a
  // spot.
  float PlainInBlock(float x, float y, float z_m, const ShadowBlocks::Rises& rises, float bias_m,
                     float reach) const;
  float Penumbra(const Spot& spot, const Place& place, const Eigen::Vector2f& turn, float reach,
                 int searches, int points) const;
  // How far the texels at the first points of a disc about the spot stand over the place's plane;
  // beyond those, as if without a caster. turn: cosine and sine by which the disc is turned.
  void FindGaps(const Spot& spot, const Place& place, const Eigen::Vector2f& turn, int points,
                float radius, Gaps& gaps) const;

  ShadowFit fit_;
  std::array<Eigen::Vector2f, kTurns> turns_;  // cosine and sine
  std::array<Disc, kMostPoints + 1> discs_;    // by the count of their points
  std::vector<float> depth_ = std::vector<float>(std::size_t{kAtlasWidth} * kAtlasHeight, 1.0f);
  int width_ = kAtlasWidth, height_ = kAtlasHeight;  // of the map
  int tiles_wide_ = kAtlasWidth / kTile, tiles_high_ = kAtlasHeight / kTile;
  int plane_tiles_side_ = kFineTexels / kTile;       // of the fine window
  std::vector<Bounds> tiles_, near_tiles_, around_;  // near: over a tile and those next to it
  std::vector<float> nearest_, farthest_;            // of a row of tiles, texel by texel
  std::vector<Bounds> plane_tiles_;  // of the fine window, heights over the plane; empty: no plane
  mutable ShadowBlocks blocks_;      // kept for speed: what places see does not depend on it
  Window coarse_{}, fine_{};
  float top_ = 0.0f, range_ = 1.0f, sun_radius_ = 0.0f;
};

}  // namespace dockyard
