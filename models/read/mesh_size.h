// How large a mesh is, for people: a mesh in millimetres shows by it.
#pragma once

#include <Eigen/Core>
#include <string>

#include "models/parts/mesh.h"

namespace dockyard {

/// The sides of the box that holds all vertices, along x, y and z.
Eigen::Vector3d ExtentOf(const TriangleMesh& mesh);

/// "1.2 x 0.8 x 0.4 m", three digits each.
std::string SizeText(const Eigen::Vector3d& extent_m);

/// A sentence that asks for the unit when the largest side is over 50 m or under 1 mm; else empty.
std::string UnitDoubt(const Eigen::Vector3d& extent_m);

}  // namespace dockyard
