// The stated format of a mesh file, checked before any importer sees the file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace dockyard {

enum class MeshFormat { kStl, kObj, kDae, kGltf, kGlb };

struct MeshStatement {
  MeshFormat format;
  long triangles = -1;  // as a glTF document states them; -1: not known
};

/// The format by extension, confirmed by the file's own bytes; throws ConfigError, naming the file.
MeshStatement CheckMeshFormat(const std::filesystem::path& file, std::string_view bytes);

}  // namespace dockyard
