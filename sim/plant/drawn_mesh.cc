#include "sim/plant/drawn_mesh.h"

namespace dockyard {

std::shared_ptr<const RenderMesh> DrawnMesh(const TriangleMesh& mesh) {
  auto drawn = std::make_shared<RenderMesh>();
  for (const Eigen::Vector3d& v : mesh.vertices) drawn->vertices.push_back(v.cast<float>());
  drawn->triangles = mesh.triangles;
  return drawn;
}

std::vector<DrawnPart> DrawnParts(const std::vector<Visual>& visuals) {
  std::vector<DrawnPart> parts;
  for (const Visual& visual : visuals) {
    parts.push_back({DrawnMesh(*visual.mesh), visual.X_LV, visual.rgb});
  }
  return parts;
}

void AddParts(const std::vector<DrawnPart>& parts, const Pose3& X_WL,
              std::vector<SceneObject>& objects) {
  for (const DrawnPart& part : parts) {
    objects.push_back({part.mesh, X_WL * part.X_LV, part.albedo, part.material});
  }
}

}  // namespace dockyard
