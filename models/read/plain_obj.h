// OBJ files of nothing but points and triangles, as most tools for robots write them. An importer
// in a process of its own takes 15 ms a file, this a fifth of one; all other files go there.
#pragma once

#include <optional>
#include <string_view>

#include "models/parts/mesh.h"

namespace dockyard {

/// The mesh of a text whose lines are "v x y z", "f i j k", one name ("o") and comments. As
/// the importer gives it: numbers as floats, a vertex where a place is used first. None for any
/// other text, also a wrong one: the importer says what is wrong with it.
std::optional<TriangleMesh> PlainObj(std::string_view text);

}  // namespace dockyard
