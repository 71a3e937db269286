// Draws one scene: uploads what is new, renders its shadow map, paints views of it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "render/fisheye_warp.h"
#include "render/gl_mesh.h"
#include "render/gl_objects.h"
#include "render/ground_mesh.h"
#include "render/scene.h"
#include "render/shadow.h"
#include "render/surface_mesh.h"

namespace dockyard {

/// Throws std::invalid_argument naming what in the scene cannot be drawn.
void RequireSoundScene(const Scene& scene);

/// Points of the sun's disc per flat pixel that lies near a shadow's edge.
struct ShadowEffort {
  int searches = 6, taps = 12;
};

class ScenePainter {
 public:
  explicit ScenePainter(const GlFunctions& gl);

  /// Everything that both views share. The scene must outlive the calls of Paint that follow.
  void Prepare(const Scene& scene, const Pose3& X_WR);
  /// Paints into the bound framebuffer's lower left width x height pixels, row 0 at the top of the
  /// camera's view. The far end of the view is 400 m, the near one 2 cm.
  void Paint(const Pose3& X_WC, const TanRect& rect, int width, int height, ShadowEffort effort);

 private:
  struct Cached {
    std::shared_ptr<const RenderMesh> mesh;  // held, so that its address stays its own
    std::unique_ptr<GlMesh> buffers;
    Ball ball;
    bool used = false;
  };
  struct Eye;

  void UploadObjects(const Scene& scene);
  void UploadGround(const Scene& scene, const Pose3& X_WR);
  void UploadRelief(const Scene& scene);
  void UploadFan(const Scene& scene);
  std::vector<Ball> Casters(const Scene& scene) const;
  void DrawCasters(GlProgram& program, const Eigen::Matrix4d& clip_from_U,
                   const ShadowWindow& window);
  SurfaceMesh TetherTube(const std::function<double(const Eigen::Vector3d&)>& drawn);
  void BeginProgram(GlProgram& program, double bias_m);
  void Pose(GlProgram& program, const Eye& eye, const Pose3& X_WO) const;
  void PaintObjects(const Eye& eye);
  void PaintBoard(const Eye& eye);
  void PaintGround(const Eye& eye);
  void PaintPart(const Eye& eye, GlProgram& program, const FanPart& part, const GlMesh& mesh);
  void PaintSky(const Eye& eye);
  void PaintTether(const Eye& eye);

  const GlFunctions& gl_;
  ShadowMap shadow_map_;
  GlProgram surface_, open_ground_, shaded_ground_, board_, sky_;
  GlMesh open_mesh_, shaded_mesh_, board_mesh_, tether_mesh_;
  GlTexture relief_, soil_, lumps_;
  GlMesh empty_mesh_;  // core GL draws nothing without a vertex array
  std::map<const RenderMesh*, Cached> cache_;
  std::optional<std::uint64_t> soil_seed_, relief_key_;

  const Scene* scene_ = nullptr;
  ShadowEffort effort_;
  Pose3 X_WP_;  // rover's place with the world's axes: origin of what is built anew for each pair
  ShadowFit fit_;
  Pose3 X_WF_;  // of the ground's fan
  GroundFan fan_;
  FanParts parts_;
};

}  // namespace dockyard
