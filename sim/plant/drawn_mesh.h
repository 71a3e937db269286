// A model's meshes as the renderer takes them.
#pragma once

#include <memory>
#include <vector>

#include "models/parts/mesh.h"
#include "render/scene.h"

namespace dockyard {

std::shared_ptr<const RenderMesh> DrawnMesh(const TriangleMesh& mesh);

/// A part of a link, in its frame L.
struct DrawnPart {
  std::shared_ptr<const RenderMesh> mesh;
  Pose3 X_LV;
  Eigen::Vector3d albedo;
  int material = 0;  // see SceneObject
};
std::vector<DrawnPart> DrawnParts(const std::vector<Visual>& visuals);
/// Adds the parts of a link at X_WL.
void AddParts(const std::vector<DrawnPart>& parts, const Pose3& X_WL,
              std::vector<SceneObject>& objects);

}  // namespace dockyard
