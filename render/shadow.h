// The sun's shadow map: two windows in one picture, a fine one round the board and a coarse one
// over everything near, with bounds per tile that spare most pixels the search.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "controller/geometry/pose.h"
#include "render/gl_objects.h"
#include "render/scene.h"
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

/// casters_W: balls round everything that casts. board: its centre and half diagonal. The fine
/// window keeps texels of at most 4 mm on boards up to 2.5 m across.
ShadowFit FitShadow(const std::vector<Ball>& casters_W, const Ball& board_W, const Pose3& X_WR,
                    const Eigen::Vector3d& to_sun_W);

class ShadowMap {
 public:
  explicit ShadowMap(const GlFunctions& gl);

  /// draw(clip_from_W, texel_m): draws all casters through the depth program given to it.
  using DrawCasters = std::function<void(GlProgram&, const Eigen::Matrix4d& clip_from_U,
                                         const ShadowWindow& window)>;
  void Render(const ShadowFit& fit, const DrawCasters& draw);

  /// Whether the sun may be hidden from any ground in a box of the light's axes; never wrongly no.
  /// slope: of the ground against the light's plane.
  bool MayBeShaded(const ShadowFit& fit, const Eigen::AlignedBox3d& box_U, double slope) const;

  /// Binds the pictures and sets the uniforms of a shading program in use.
  void Apply(const ShadowFit& fit, GlProgram& program) const;

 private:
  void ReduceTiles(const ShadowFit& fit);
  bool WindowMayShade(const ShadowWindow& window, const Eigen::AlignedBox3d& box_U,
                      double slope) const;

  const GlFunctions& gl_;
  GlTexture depth_, tiles_, spread_;
  GlTextureTarget depth_target_, tiles_target_, spread_target_;
  std::vector<float> highest_;  // caster over each tile and its surroundings, along U's z [m]
  GlProgram depth_program_, bounds_program_, spread_program_;
};

}  // namespace dockyard
