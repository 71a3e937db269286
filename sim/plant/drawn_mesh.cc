#include "sim/plant/drawn_mesh.h"

namespace dockyard {

std::shared_ptr<const RenderMesh> DrawnMesh(const TriangleMesh& mesh) {
  auto drawn = std::make_shared<RenderMesh>();
  for (const Eigen::Vector3d& v : mesh.vertices) drawn->vertices.push_back(v.cast<float>());
  drawn->triangles = mesh.triangles;
  return drawn;
}

}  // namespace dockyard
