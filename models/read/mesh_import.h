// The call of assimp, restricted to the allowed formats and to the mesh's own folder. It may crash
// or take any time and memory on a hostile file: only mesh_child.h calls it, in a process of its
// own.
#pragma once

#include <filesystem>
#include <string>

#include "models/parts/mesh.h"

namespace dockyard {

/// The triangles of a file that CheckMeshFormat has let pass.
/// @param bytes      what the importer sees as the file
/// @param triangles  that the importer must find, -1: any number; it drops those whose index is out
///                   of range
/// Throws ConfigError as LoadMesh does.
TriangleMesh ImportMesh(const std::filesystem::path& file, std::string bytes, long triangles);

}  // namespace dockyard
