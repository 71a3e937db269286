// Mass and inertia of a solid of even density.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/rigid/convex_body.h"

namespace dockyard {

struct SolidMass {
  double mass_kg = 0.0;
  Eigen::Vector3d p_com = Eigen::Vector3d::Zero();  // in the body's frame [m]
  Eigen::Matrix3d I_com = Eigen::Matrix3d::Zero();  // about it, in the body's axes [kg m^2]
};

/// Exact for the polyhedron: the sum over the tetrahedra of its triangles and one point.
SolidMass MassOf(const ConvexBody& body, double density_kg_m3);

/// Several solids as one.
SolidMass Together(const std::vector<SolidMass>& parts);

}  // namespace dockyard
