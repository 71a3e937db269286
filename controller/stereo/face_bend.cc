#include "controller/stereo/face_bend.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace dockyard {
namespace {

// Points further off the surface do not count: first off its plane, then off the quadric. A sphere
// of 8 cm falls away by 8 mm within 35 mm. Assumed, 6-12 and 2-4 mm.
constexpr double kOffPlane_m = 0.01, kOffQuadric_m = 0.003;
constexpr int kFitRounds = 3;
constexpr int kLeastPoints = 100;

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

Vector6d RowOf(const Eigen::Vector3d& p) {
  Vector6d row;
  row << 1.0, p.x(), p.y(), 0.5 * p.x() * p.x(), p.x() * p.y(), 0.5 * p.y() * p.y();
  return row;
}

// Within the radius of the plane's point, in a frame there whose z axis is the normal.
std::vector<Eigen::Vector3d> PointsAbout(const RectifiedPair& pair, const Disparities& disparities,
                                         const Pose3& X_RF, double radius_m) {
  const Eigen::Vector3d p_C = Inverse(pair.X_RC) * X_RF.p;
  const Eigen::Vector2d px = pair.centre_px + pair.focal_px * p_C.head<2>() / p_C.z();
  const int reach = static_cast<int>(std::ceil(pair.focal_px * radius_m / p_C.z()));
  const int u = static_cast<int>(std::lround(px.x())), v = static_cast<int>(std::lround(px.y()));
  const Pose3 X_FC = Inverse(X_RF) * pair.X_RC;
  std::vector<Eigen::Vector3d> points;
  for (int y = std::max(0, v - reach); y <= std::min(disparities.height - 1, v + reach); ++y) {
    for (int x = std::max(0, u - reach); x <= std::min(disparities.width - 1, u + reach); ++x) {
      const double disparity_px = disparities.at(x, y);
      if (!(disparity_px > 0.0)) continue;
      const Eigen::Vector3d p_F = X_FC * pair.Point(x, y, disparity_px);
      if (p_F.head<2>().norm() <= radius_m && std::abs(p_F.z()) < kOffPlane_m) {
        points.push_back(p_F);
      }
    }
  }
  return points;
}

}  // namespace

std::optional<Eigen::Matrix3d> BendAbout(const RectifiedPair& pair, const Disparities& disparities,
                                         const FacePlane& plane, double radius_m) {
  Eigen::Matrix3d axes;
  axes.col(2) = plane.normal;
  axes.col(0) = plane.normal.unitOrthogonal();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  const Pose3 X_RF{axes, plane.p};
  if ((Inverse(pair.X_RC) * plane.p).z() <= radius_m) return std::nullopt;
  const std::vector<Eigen::Vector3d> points = PointsAbout(pair, disparities, X_RF, radius_m);
  Vector6d fit = Vector6d::Zero();
  double within_m = kOffPlane_m;
  for (int round = 0; round < kFitRounds; ++round) {
    Matrix6d A = Matrix6d::Zero();
    Vector6d b = Vector6d::Zero();
    int used = 0;
    for (const Eigen::Vector3d& p : points) {
      const Vector6d row = RowOf(p);
      if (std::abs(p.z() - row.dot(fit)) > within_m) continue;
      A += row * row.transpose();
      b += p.z() * row;
      ++used;
    }
    if (used < kLeastPoints) return std::nullopt;
    fit = A.ldlt().solve(b);
    within_m = kOffQuadric_m;
  }
  // The normal of z(x, y) is (-dz/dx, -dz/dy, 1).
  Eigen::Matrix3d bend_F = Eigen::Matrix3d::Zero();
  bend_F.topLeftCorner<2, 2>() << -fit[3], -fit[4], -fit[4], -fit[5];
  return Eigen::Matrix3d(axes * bend_F * axes.transpose());
}

}  // namespace dockyard
