// Symmetric matrices of three rows, for eliminations by blocks.
#pragma once

#include <Eigen/Core>

namespace dockyard {

/// A symmetric matrix of three rows.
struct Symmetric {
  double xx, xy, xz, yy, yz, zz;
};

inline Symmetric SymmetricOf(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

/// Takes a^T b, which is symmetric, from s.
inline void TakeProduct(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b, Symmetric& s) {
  const double *p = a.data(), *q = b.data();  // by columns
  s.xx -= p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  s.xy -= p[0] * q[3] + p[1] * q[4] + p[2] * q[5];
  s.xz -= p[0] * q[6] + p[1] * q[7] + p[2] * q[8];
  s.yy -= p[3] * q[3] + p[4] * q[4] + p[5] * q[5];
  s.yz -= p[3] * q[6] + p[4] * q[7] + p[5] * q[8];
  s.zz -= p[6] * q[6] + p[7] * q[7] + p[8] * q[8];
}

inline Symmetric InverseOf(const Symmetric& s) {
  const double xx = s.yy * s.zz - s.yz * s.yz, xy = s.xz * s.yz - s.xy * s.zz,
               xz = s.xy * s.yz - s.xz * s.yy;
  const double d = 1.0 / (s.xx * xx + s.xy * xy + s.xz * xz);
  return {d * xx,
          d * xy,
          d * xz,
          d * (s.xx * s.zz - s.xz * s.xz),
          d * (s.xy * s.xz - s.xx * s.yz),
          d * (s.xx * s.yy - s.xy * s.xy)};
}

/// Of a tensor whose axes R turns: R I R^T.
inline Symmetric TurnedTensor(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I) {
  const Eigen::Matrix3d M = R.lazyProduct(I);
  const double *a = M.data(), *b = R.data();  // by columns
  return {a[0] * b[0] + a[3] * b[3] + a[6] * b[6], a[0] * b[1] + a[3] * b[4] + a[6] * b[7],
          a[0] * b[2] + a[3] * b[5] + a[6] * b[8], a[1] * b[1] + a[4] * b[4] + a[7] * b[7],
          a[1] * b[2] + a[4] * b[5] + a[7] * b[8], a[2] * b[2] + a[5] * b[5] + a[8] * b[8]};
}

inline Eigen::Matrix3d MatrixOf(const Symmetric& s) {
  Eigen::Matrix3d m;
  m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
  return m;
}

template <class V>
Eigen::Vector3d Product(const Symmetric& s, const V& v) {
  return {s.xx * v[0] + s.xy * v[1] + s.xz * v[2], s.xy * v[0] + s.yy * v[1] + s.yz * v[2],
          s.xz * v[0] + s.yz * v[1] + s.zz * v[2]};
}

}  // namespace dockyard
