// The stated format of a mesh file, checked before any importer sees the file.
#pragma once

#include <filesystem>
#include <string>

namespace dockyard {

enum class MeshFormat { kStl, kObj, kDae, kGltf, kGlb };

struct MeshStatement {
  MeshFormat format;
  std::string bytes;  // for an importer
};

/// The format by extension, confirmed by the file's own bytes; throws ConfigError, naming the file.
/// The bytes come back without byte order mark, OBJ as of SimplifiedObj, STL in text as of
/// CheckedStl, Collada as of CheckedCollada.
MeshStatement CheckMeshFormat(const std::filesystem::path& file, std::string bytes);

}  // namespace dockyard
