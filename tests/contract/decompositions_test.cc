#include "controller/geometry/decompositions.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "controller/geometry/pose.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

Eigen::Vector3d RandomVector(RandomStream& random) {
  return {random.Normal(), random.Normal(), random.Normal()};
}

Eigen::Matrix3d RandomMatrix(RandomStream& random) {
  Eigen::Matrix3d A;
  A << RandomVector(random), RandomVector(random), RandomVector(random);
  return A;
}

TEST(Decompositions, SvdGivesTheMatrixBackFromOrthogonalFactors) {
  RandomStream random(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d A = RandomMatrix(random);
    const Svd3 svd = Svd(A);
    EXPECT_LT((svd.U * svd.values.asDiagonal() * svd.V.transpose() - A).norm(), 1e-13);
    EXPECT_LT((svd.U.transpose() * svd.U - Eigen::Matrix3d::Identity()).norm(), 1e-13);
    EXPECT_LT((svd.V.transpose() * svd.V - Eigen::Matrix3d::Identity()).norm(), 1e-13);
    EXPECT_GE(svd.values(0), svd.values(1));
    EXPECT_GE(svd.values(1), svd.values(2));
  }
}

TEST(Decompositions, NoTurnAboutTheNearestRotationIsNearer) {
  RandomStream random(2);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix3d A = RandomMatrix(random);  // mirrored ones too
    const Eigen::Matrix3d R = NearestRotation(A);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-13);
    for (int k = 0; k < 20; ++k) {
      const Eigen::AngleAxisd turn(0.2 * random.Normal(), RandomVector(random).normalized());
      EXPECT_LE((A - R).norm(), (A - turn * R).norm() + 1e-12);
    }
  }
}

TEST(Decompositions, EigenvectorsOfASymmetricMatrixAreStretchedByTheirValues) {
  RandomStream random(3);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix3d B = RandomMatrix(random), A = B + B.transpose();
    const SymmetricEigen3 eigen = EigenOfSymmetric(A);
    EXPECT_LT((A * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm(), 1e-12);
    EXPECT_LE(eigen.values(0), eigen.values(1));
    EXPECT_LE(eigen.values(1), eigen.values(2));
  }
}

TEST(Decompositions, EigenvaluesOfACompanionMatrixAreThePolynomialsRoots) {
  // (x - 1)(x + 2)(x^2 + 9) = x^4 + x^3 + 7 x^2 + 9 x - 18
  SmallMatrix companion = SmallMatrix::Zero(4, 4);
  companion.bottomLeftCorner(3, 3).setIdentity();
  companion.col(3) << 18.0, -9.0, -7.0, -1.0;
  const GeneralEigen eigen = EigenOf(companion);
  for (const std::complex<double> root :
       {std::complex<double>(1, 0), std::complex<double>(-2, 0), std::complex<double>(0, 3),
        std::complex<double>(0, -3)}) {
    EXPECT_LT((eigen.values.array() - root).abs().minCoeff(), 1e-12) << root;
  }
  for (int i = 0; i < 4; ++i) {
    const auto v = eigen.vectors.col(i);
    EXPECT_LT((companion.cast<std::complex<double>>() * v - eigen.values(i) * v).norm(), 1e-12);
  }
}

TEST(RotationBetween, BringsOneDirectionToTheOtherByTheAngleBetweenThem) {
  RandomStream random(4);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d a = RandomVector(random);
    const Eigen::Vector3d b = i % 4 == 0   ? Eigen::Vector3d(a + 1e-9 * RandomVector(random))
                              : i % 4 == 1 ? Eigen::Vector3d(-a + 1e-7 * RandomVector(random))
                                           : RandomVector(random);
    const Eigen::Matrix3d R = RotationBetween(a, b);
    EXPECT_LT((R * a.normalized() - b.normalized()).norm(), 1e-12);
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    const double turned = Eigen::AngleAxisd(R).angle();
    EXPECT_NEAR(turned, angle, 1e-7);
  }
}

TEST(RotationBetween, OppositeDirectionsTakeAHalfTurn) {
  const Eigen::Vector3d a(1.0, -2.0, 0.5);
  const Eigen::Matrix3d R = RotationBetween(a, -3.0 * a);
  EXPECT_LT((R * a + a).norm(), 1e-14);
  EXPECT_NEAR(R.determinant(), 1.0, 1e-14);
}

}  // namespace
}  // namespace dockyard
