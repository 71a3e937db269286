// STL files in text, checked before an importer sees them. assimp 5.2.5 accepts "1x" and "1,5" as
// numbers and a part of a file as a whole mesh, and reads no capitals.
#pragma once

#include <string>
#include <string_view>

namespace dockyard {

/// The text of the same facets, its words in small letters and its last lines complete. Read are
/// solids from "solid" to "endsolid", in any letters, of facets of three vertices of three numbers.
/// Behind the last vertex the file may end anywhere. Normals are not read: files state their own as
/// nan. Throws ConfigError with line and column.
std::string CheckedStl(std::string_view text, const std::string& file);

}  // namespace dockyard
