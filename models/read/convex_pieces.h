// Convex solids in place of a mesh that has hollows: contacts are found between convex solids.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "models/parts/mesh.h"

namespace dockyard {

/// Parting a mesh takes a time that grows with the square of its triangles: 0.6 s for these.
inline constexpr std::size_t kMostPartedTriangles = 512;
/// How deep hollows may be filled, over the diagonal of the box about the mesh; measured on a
/// funnel 0.035.
inline constexpr double kFilledHollow = 0.04;

/// Whether no hollow is deeper than kFilledHollow. It asks 1000 triangles and 20000 vertices at
/// most, spread evenly over those of the mesh.
bool IsConvex(const TriangleMesh& mesh);

/// Whether all points lie within 1e-4 of the diagonal of a plane: no solid.
bool IsFlat(const std::vector<Eigen::Vector3d>& points);

/// The corners of convex solids that fill the mesh, by hierarchical approximate decomposition
/// (Mamou and Ghorbel, ICIP 2009, in Bullet's library HACD). Each time the same; one piece, the
/// mesh's hull, where there are no others that all have a thickness. The mesh has a triangle and at
/// most kMostPartedTriangles.
std::vector<std::vector<Eigen::Vector3d>> ConvexPieces(const TriangleMesh& mesh);

}  // namespace dockyard
