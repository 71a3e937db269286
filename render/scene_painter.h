// Draws one scene: uploads its new parts, renders its shadow map, finds the surfaces in its views.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "render/flat_view.h"
#include "render/gl_mesh.h"
#include "render/gl_objects.h"
#include "render/ground_mesh.h"
#include "render/scene.h"
#include "render/shadow.h"
#include "render/surface_mesh.h"

namespace dockyard {

/// Throws std::invalid_argument for what logs and files bring: places that are not finite, poses
/// that are not rigid, a ground that cannot be drawn, too many objects. Checks all else.
void RequireSoundScene(const Scene& scene);

/// Views begin at this depth.
inline constexpr double kNear_m = 0.02;

class ScenePainter {
 public:
  explicit ScenePainter(const GlFunctions& gl);

  struct Detail {
    ShadowDetail shadow{};
    bool shadows = true;  // of the sun; false saves their map
    // Of the ground's fan, which stands under X_WR.p: views may show no other part.
    FanPart fan{};
    bool ground = true;  // false: the caller adds it to its views
  };
  /// Everything that the views share. The scene must outlive the calls of Paint that follow.
  void Prepare(const Scene& scene, const Pose3& X_WR) { Prepare(scene, X_WR, Detail{}); }
  void Prepare(const Scene& scene, const Pose3& X_WR, const Detail& detail);
  /// Fills a view whose rect and size are set, through a target that is made anew where it is too
  /// small. The far end of the view is 400 m, the near one 2 cm.
  void PaintInto(std::unique_ptr<GlViewTarget>& target, const Pose3& X_WC, FlatView& view);
  /// Of the scene prepared last.
  const SunShadow& shadow() const { return shadow_; }

 private:
  struct Cached {
    std::shared_ptr<const RenderMesh> mesh;  // held, so that its address stays its own
    std::unique_ptr<GlMesh> buffers;
    Ball ball;
    bool used = false;
  };
  // One view being painted.
  struct Frustum {
    Pose3 X_WC, X_CW;
    TanRect rect;
    int width = 0, height = 0;
    Eigen::Matrix4d clip_from_C;
  };

  void UploadObjects(const Scene& scene);
  void UploadGround(const Scene& scene, const Pose3& X_WR, const FanPart& part);
  std::vector<Ball> Casters(const Scene& scene) const;
  void DrawCasters(GlProgram& program, const Eigen::Matrix4d& clip_from_U,
                   const ShadowWindow& window);
  SurfaceMesh TetherTube(const TetherView& body,
                         const std::function<double(const Eigen::Vector3d&)>& drawn) const;
  void Pose(GlProgram& program, const Frustum& frustum, const Pose3& X_WO) const;
  void Paint(const GlViewTarget& target, const Pose3& X_WC, FlatView& view);
  void PaintObjects(const Frustum& frustum);
  void PaintBoards(const Frustum& frustum);
  void PaintGround(const Frustum& frustum);
  bool FitThin(const Frustum& frustum, const TetherView& body, ThinLayer& layer) const;
  void PaintTether(const Frustum& frustum, const GlViewTarget& target, const TetherView& body,
                   ThinLayer& layer);

  const GlFunctions& gl_;
  ShadowMap shadow_map_;
  SunShadow shadow_;
  GlProgram object_, ground_, board_, thin_;
  std::optional<GlProgram> many_objects_;  // of scenes that need kManyObjects
  GlMesh ground_mesh_, tether_mesh_;
  std::vector<std::unique_ptr<GlMesh>> board_meshes_;  // the first are the scene's
  GlMesh empty_mesh_;  // core GL draws nothing without a vertex array
  std::map<const RenderMesh*, Cached> cache_;

  const Scene* scene_ = nullptr;
  Pose3 X_WP_;  // rover's place with the world's axes: origin of the meshes made anew for each pair
  ShadowFit fit_;
  Pose3 X_WF_;  // of the ground's fan
  FanPart fan_{};
  bool with_ground_ = true;
};

}  // namespace dockyard
