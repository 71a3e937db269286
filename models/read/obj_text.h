// OBJ files as modelling programs write them, reduced to vertices and faces: the rest (normals,
// texture, materials, groups) has no part in a mesh here, and an importer refuses files for it.
#pragma once

#include <string>
#include <string_view>

namespace dockyard {

/// The lines "v x y z" and "f i j k ..." of an OBJ text, the latter with indices of vertices
/// counted from 1. Read are corners "7", "7/2", "7//3" and "7/2/3", whether or not the file has the
/// texture and normals that they name, indices counted back from the line (-1: the vertex before
/// it), lines continued by a backslash, and vertices with a weight or a colour. Faces of fewer than
/// three corners are left out, as points and lines are. Throws ConfigError with line and column: a
/// vertex of other than 3, 4, 6 or 7 numbers, a corner that is no index or names no vertex, no
/// faces, more vertices or faces than a mesh may have.
std::string SimplifiedObj(std::string_view text, const std::string& file);

}  // namespace dockyard
