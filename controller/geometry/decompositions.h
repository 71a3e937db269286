// The decompositions of small matrices that estimation needs, compiled once: Eigen's solvers are
// slow to compile.
#pragma once

#include <Eigen/Core>
#include <complex>

namespace dockyard {

/// A = U diag(values) V^T, values descending and not negative.
struct Svd3 {
  Eigen::Matrix3d U, V;
  Eigen::Vector3d values;
};
Svd3 Svd(const Eigen::Matrix3d& A);

/// The rotation nearest to A in the Frobenius norm (Umeyama 1991, lemma).
Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& A);
Eigen::Matrix3d NearestRotation(const Svd3& svd);

/// A symmetric matrix's eigenvalues, ascending, and its eigenvectors as columns of unit length.
struct SymmetricEigen3 {
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
};
SymmetricEigen3 EigenOfSymmetric(const Eigen::Matrix3d& A);

/// Up to 4 x 4, without memory from the heap.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;

/// Any real matrix's eigenvalues and eigenvectors (columns), in no order; complex ones in pairs.
struct GeneralEigen {
  Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 1, 0, 4, 1> values;
  Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4> vectors;
};
GeneralEigen EigenOf(const SmallMatrix& A);

}  // namespace dockyard
