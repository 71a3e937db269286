#include "controller/geometry/decompositions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace dockyard {

Svd3 Svd(const Eigen::Matrix3d& A) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {.U = svd.matrixU(), .V = svd.matrixV(), .values = svd.singularValues()};
}

Eigen::Matrix3d NearestRotation(const Svd3& svd) {
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  if ((svd.U * svd.V.transpose()).determinant() < 0.0) signs.z() = -1.0;
  return svd.U * signs.asDiagonal() * svd.V.transpose();
}

Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& A) { return NearestRotation(Svd(A)); }

SymmetricEigen3 EigenOfSymmetric(const Eigen::Matrix3d& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(A);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

GeneralEigen EigenOf(const SmallMatrix& A) {
  const Eigen::EigenSolver<SmallMatrix> solver(A);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

}  // namespace dockyard
