// The stated format of a mesh file, checked before any importer sees the file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace dockyard {

enum class MeshFormat { kStl, kObj, kDae, kGltf, kGlb };

/// The format by extension, confirmed by the file's own bytes; throws ConfigError, naming the file.
MeshFormat CheckedMeshFormat(const std::filesystem::path& file, std::string_view bytes);

}  // namespace dockyard
