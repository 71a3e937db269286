// A model's mesh as the renderer takes it.
#pragma once

#include <memory>

#include "models/parts/mesh.h"
#include "render/scene.h"

namespace dockyard {

std::shared_ptr<const RenderMesh> DrawnMesh(const TriangleMesh& mesh);

}  // namespace dockyard
