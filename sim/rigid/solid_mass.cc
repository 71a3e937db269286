#include "sim/rigid/solid_mass.h"

#include <Eigen/LU>

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Inertia of what has this sum of m x x^T.
Matrix3d InertiaOf(const Matrix3d& squares) {
  return squares.trace() * Matrix3d::Identity() - squares;
}

}  // namespace

SolidMass MassOf(const ConvexBody& body, double density_kg_m3) {
  double volume = 0.0;
  Vector3d first = Vector3d::Zero();
  Matrix3d squares = Matrix3d::Zero();
  for (const auto& t : body.triangles) {
    Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = body.vertices[t[i]] - body.centre;
    const Vector3d sum = corners.rowwise().sum();
    const double part = corners.determinant() / 6.0;
    volume += part;
    first += part / 4.0 * sum;
    squares += part / 20.0 * (corners * corners.transpose() + sum * sum.transpose());
  }
  SolidMass solid;
  solid.mass_kg = density_kg_m3 * volume;
  const Vector3d com = first / volume;
  solid.p_com = body.centre + com;
  solid.I_com = density_kg_m3 * InertiaOf(squares - volume * com * com.transpose());
  return solid;
}

SolidMass Together(const std::vector<SolidMass>& parts) {
  SolidMass whole;
  for (const SolidMass& part : parts) {
    whole.mass_kg += part.mass_kg;
    whole.p_com += part.mass_kg * part.p_com;
  }
  whole.p_com /= whole.mass_kg;
  for (const SolidMass& part : parts) {
    const Vector3d off = part.p_com - whole.p_com;
    whole.I_com += part.I_com + part.mass_kg * InertiaOf(off * off.transpose());
  }
  return whole;
}

}  // namespace dockyard
