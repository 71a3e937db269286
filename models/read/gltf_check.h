// The check of a glTF 2.0 document before an importer sees it. assimp 5.2.5 parses JSON
// recursively, allocates memory as counts and lengths state, and follows nodes wherever they lead.
#pragma once

#include <string>
#include <string_view>

namespace dockyard {

/// Why the JSON text is refused, empty when it is not: nested deeper than 64 levels outside
/// strings, no version 2, lengths and counts beyond those of any mesh file, more than 16 million
/// elements over all accessors named, nodes with two parents, in a circle or deeper than 64 levels,
/// and features that are not read: skins, morph targets, sparse accessors, compressed geometry. One
/// pass; the importer checks whether the text is valid JSON.
std::string GltfObjection(std::string_view json);

}  // namespace dockyard
