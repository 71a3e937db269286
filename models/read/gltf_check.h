// A glTF 2.0 document judged before an importer sees it. assimp 5.2.5 parses JSON recursively,
// allocates what counts and lengths state, and follows nodes wherever they lead.
#pragma once

#include <string>
#include <string_view>

namespace dockyard {

/// Why the JSON text is refused, empty when it is not: nested deeper than 64 levels outside
/// strings, no version 2, lengths and counts beyond what a mesh file may have, more than 16 million
/// elements over all accessors named, nodes with two parents, in a circle or deeper than 64 levels,
/// and what is not read: skins, morph targets, sparse accessors, compressed geometry. One pass;
/// whether the text is sound JSON is left to the importer.
std::string GltfObjection(std::string_view json);

}  // namespace dockyard
