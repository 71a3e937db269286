// The check of a glTF 2.0 document before an importer sees it. assimp 5.2.5 parses JSON
// recursively, allocates memory as counts and lengths state, and follows nodes wherever they lead.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dockyard {

struct GltfFindings {
  std::string objection;  // why the document is refused; empty when it is not
  long triangles = 0;     // as its primitives state them
};

/// Refused are: nesting deeper than 64 levels outside strings, no version 2, a key given twice,
/// lengths and counts beyond those of any mesh file, more than 16 million elements over all
/// accessors named, nodes with two parents, in a circle or deeper than 64 levels, what
/// LayoutObjection refuses, buffers that are not beside the file, and features that are not read:
/// skins, morph targets, sparse accessors, compressed geometry. One pass; the importer checks
/// whether the text is valid JSON.
/// @param own_bytes  of the GLB's own buffer, 0 without one
GltfFindings CheckGltf(std::string_view json, std::size_t own_bytes);

}  // namespace dockyard
