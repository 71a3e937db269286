// The triangles of glTF 2.0 documents. assimp 5.2.5 reads beyond buffers whose lengths do not add
// up, leaves faces out and takes other files than the one that a document names.
#pragma once

#include <filesystem>
#include <string_view>

#include "models/parts/mesh.h"

namespace dockyard {

/// All triangles of the document's scene, in its root frame. A buffer is the file's own, data in
/// base64, or a .bin file in the same folder. Refused are skins, morph targets, sparse accessors
/// and compressed geometry. A hostile file may take any time, memory and depth: only for a process
/// of its own (mesh_child.h). Throws ConfigError, naming the file.
/// @param binary  a .glb file (Khronos, glTF 2.0, 4.4), else the JSON text
TriangleMesh ReadGltf(const std::filesystem::path& file, std::string_view bytes, bool binary);

}  // namespace dockyard
