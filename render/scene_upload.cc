// The upload of a scene to the GPU, and the conditions for uploading again.
#include "render/scene_painter.h"

namespace dockyard {

void ScenePainter::UploadObjects(const Scene& scene) {
  for (auto& [address, cached] : cache_) cached.used = false;
  for (const SceneObject& object : scene.objects) {
    Cached& cached = cache_[object.mesh.get()];
    cached.used = true;
    if (cached.buffers) continue;
    cached.mesh = object.mesh;
    cached.ball = BoundingBall(*object.mesh);
    auto buffers = std::make_unique<GlMesh>(gl_);
    buffers->Upload(WithNormals(*object.mesh));
    cached.buffers = std::move(buffers);
  }
  std::erase_if(cache_, [](const auto& entry) { return !entry.second.used; });
}

void ScenePainter::UploadGround(const Scene& scene, const Pose3& X_WR, const FanPart& part) {
  const GroundView& ground = scene.ground;
  const Eigen::Vector3d p_GR = Inverse(ground.X_WG) * X_WR.p;
  const GroundFan fan = MakeGroundFan(GroundHeight(ground), p_GR.x(), p_GR.y(), part);
  ground_mesh_.Upload(fan.vertices, fan.indices);
  fan_ = part;
  X_WF_ = ground.X_WG * Pose3::Translation(p_GR.x(), p_GR.y(), 0.0);
}

}  // namespace dockyard
