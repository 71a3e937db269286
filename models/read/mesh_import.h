// The call of assimp, restricted to the allowed formats and to the mesh itself, or of the reader of
// glTF. It may crash or take any time and memory on a hostile file: only mesh_child.h calls it, in
// a process of its own.
#pragma once

#include <filesystem>

#include "models/parts/mesh.h"
#include "models/read/mesh_format.h"

namespace dockyard {

/// The triangles of a file that CheckMeshFormat has let pass. Throws ConfigError as LoadMesh does.
TriangleMesh ImportMesh(const std::filesystem::path& file, const MeshStatement& stated);

}  // namespace dockyard
