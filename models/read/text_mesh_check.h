// Meshes in text, checked before an importer sees them. assimp 5.2.5 reads "1x" and "1,5" in some
// way, and a part of a file as a whole mesh. All throw ConfigError with line and column.
#pragma once

#include <string>
#include <string_view>

namespace dockyard {

/// Every line that begins with v holds three numbers, and a weight or a colour.
void CheckObjText(std::string_view text, const std::string& file);

/// Solids from "solid" to "endsolid", of facets of three vertices of three numbers. Normals are not
/// read: files state their own as nan.
void CheckStlText(std::string_view text, const std::string& file);

}  // namespace dockyard
