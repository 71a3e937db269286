// The share of the sun's disc that a place sees, from the shadow map. No GL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "controller/geometry/pose.h"
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

/// Light axes U: z towards the sun; origin near the board, so that floats stay small.
struct ShadowFit {
  Pose3 X_WU;
  ShadowWindow coarse, fine;
  double top_m = 1.0, bottom_m = 0.0;  // along z, all casters in between
};

inline constexpr int kCoarseTexels = 1536;
inline constexpr int kFineTexels = 768;
inline constexpr int kAtlasWidth = kCoarseTexels + kFineTexels, kAtlasHeight = kCoarseTexels;

/// casters_W: balls round everything that casts. board: its centre and half diagonal. The fine
/// window keeps texels of at most 3 mm on boards up to 1.9 m across.
ShadowFit FitShadow(const std::vector<Ball>& casters_W, const Ball& board_W, const Pose3& X_WR,
                    const Eigen::Vector3d& to_sun_W);

class SunShadow {
 public:
  /// Takes a new map: depth 0 at fit.top_m towards the sun, 1 at fit.bottom_m and without a
  /// caster.
  void Take(const ShadowFit& fit, double sun_angular_diameter_rad);
  /// Of the map taken last: a plane in U in which many places lie, the board's. What stands over it
  /// is bounded tile by tile, so that its sunlit parts need no points.
  void TakePlane(const Eigen::Vector3d& p_U, const Eigen::Vector3d& normal_U);
  /// Room for the map, kAtlasWidth x kAtlasHeight, row by row.
  std::vector<float>& depth() { return depth_; }
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

  SunShadow();

 private:
  struct Bounds {
    float highest = 0.0f, lowest = 0.0f;  // caster over a tile and those around it, along U's z [m]
  };
  struct Window {
    float center_x, center_y, texel_m, per_texel, middle, last;
    int column;
  };
  static constexpr int kTurns = 256;
  /// Points of a disc of radius 1, side by side, so that four go at once.
  struct Disc {
    std::array<float, kMostPoints> x{}, y{};
  };

  static int Turn(int pixel_x, int pixel_y);
  void ReduceTiles();
  // Bounds over each tile and those around it.
  static void Spread(std::vector<Bounds>& tiles, std::vector<Bounds>& room, int wide, int high);
  // A place in a window of the map; none: outside.
  struct Spot {
    const Window* window = nullptr;
    float x = 0.0f, y = 0.0f;  // in its texels
    float sway = 0.0f;         // how far the surface leaves the level within its bounds
  };
  Spot SpotOf(const Place& place) const;
  const Bounds& BoundsAt(const Spot& spot) const;
  float Penumbra(const Spot& spot, const Place& place, float reach, int searches, int points) const;
  // How far the texels at the first points of a disc about the spot stand over the place's plane.
  void Gaps(const Spot& spot, const Place& place, int points, float radius, float* gaps) const;

  ShadowFit fit_;
  std::array<Eigen::Vector2f, kTurns> turns_;  // cosine and sine
  std::array<Disc, kMostPoints + 1> discs_;    // by the count of their points
  std::vector<float> depth_ = std::vector<float>(std::size_t{kAtlasWidth} * kAtlasHeight, 1.0f);
  std::vector<Bounds> tiles_, around_;
  std::vector<Bounds> plane_tiles_;  // of the fine window, heights over the plane; empty: no plane
  Window coarse_{}, fine_{};
  float top_ = 0.0f, range_ = 1.0f, sun_radius_ = 0.0f;
};

}  // namespace dockyard
