#include "controller/vision/p3p.h"

#include <Eigen/LU>
#include <cmath>

#include "controller/geometry/decompositions.h"
#include "controller/vision/stereo_pose.h"

namespace dockyard {
namespace {

/// Real roots of a4 x^4 + ... + a0, by the companion matrix.
std::vector<double> RealRoots(const std::array<double, 5>& a) {
  if (!(std::abs(a[4]) > 1e-14)) return {};
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.bottomLeftCorner<3, 3>().setIdentity();
  for (int i = 0; i < 4; ++i) companion(i, 3) = -a[static_cast<std::size_t>(i)] / a[4];
  if (!companion.allFinite()) return {};
  const GeneralEigen eigen = EigenOf(companion);
  std::vector<double> roots;
  for (int i = 0; i < 4; ++i) {
    const std::complex<double> root = eigen.values(i);
    if (std::abs(root.imag()) < 1e-4 * (1.0 + std::abs(root.real()))) roots.push_back(root.real());
  }
  return roots;
}

}  // namespace

std::vector<Pose3> PosesFromThreePoints(const std::array<Eigen::Vector3d, 3>& points_B,
                                        const std::array<Eigen::Vector3d, 3>& sights_C) {
  const auto& p = points_B;
  const double a2 = (p[1] - p[2]).squaredNorm(), b2 = (p[0] - p[2]).squaredNorm(),
               c2 = (p[0] - p[1]).squaredNorm();
  const double area = (p[1] - p[0]).cross(p[2] - p[0]).norm();
  if (!(area > 1e-9 * (a2 + b2 + c2))) return {};
  const double ca = sights_C[1].dot(sights_C[2]), cb = sights_C[0].dot(sights_C[2]),
               cg = sights_C[0].dot(sights_C[1]);
  // Haralick et al., eqs. 7 to 12: v = s3 / s1, u = s2 / s1.
  const double d = (a2 - c2) / b2, e = (a2 + c2) / b2;
  const std::array<double, 5> quartic{
      (1 + d) * (1 + d) - 4 * a2 / b2 * cg * cg,
      4 * (-d * (1 + d) * cb + 2 * a2 / b2 * cg * cg * cb - (1 - e) * ca * cg),
      2 * (d * d - 1 + 2 * d * d * cb * cb + 2 * (b2 - c2) / b2 * ca * ca - 4 * e * ca * cb * cg +
           2 * (b2 - a2) / b2 * cg * cg),
      4 * (d * (1 - d) * cb - (1 - e) * ca * cg + 2 * c2 / b2 * ca * ca * cb),
      (d - 1) * (d - 1) - 4 * c2 / b2 * ca * ca};
  std::vector<Pose3> poses;
  for (const double v : RealRoots(quartic)) {
    const double denominator = 2 * (cg - v * ca);
    if (std::abs(denominator) < 1e-12) continue;
    const double u = ((d - 1) * v * v - 2 * d * cb * v + 1 + d) / denominator;
    const double square = b2 / (1 + v * v - 2 * v * cb);
    if (!(square > 0.0) || !(u > 0.0) || !(v > 0.0)) continue;
    const double s = std::sqrt(square);
    const auto pose =
        FitRigid({p[0], p[1], p[2]}, {s * sights_C[0], u * s * sights_C[1], v * s * sights_C[2]});
    if (pose) poses.push_back(*pose);
  }
  return poses;
}

}  // namespace dockyard
