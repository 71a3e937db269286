#include "controller/vision/stereo_pose.h"

#include <Eigen/LU>

#include "controller/base/check.h"
#include "controller/geometry/decompositions.h"

namespace dockyard {

std::optional<Eigen::Vector3d> Triangulate(const StereoRig& rig, const Eigen::Vector2d& left_px,
                                           const Eigen::Vector2d& right_px) {
  const LensRay left = rig.left.Ray(left_px), right = rig.right.Ray(right_px);
  const Eigen::Vector3d a = rig.X_RL.R * left.direction, b = rig.X_RQ.R * right.direction;
  const Eigen::Vector3d from_left = rig.X_RL * left.origin, from_right = rig.X_RQ * right.origin;
  const Eigen::Vector3d base = from_right - from_left;
  // Least |from_left + s a - from_right - t b|^2 over s and t.
  const double ab = a.dot(b), det = 1.0 - ab * ab;
  if (det < 1e-10) return std::nullopt;
  const double s = (base.dot(a) - ab * base.dot(b)) / det;
  const double t = (ab * base.dot(a) - base.dot(b)) / det;
  if (s <= 0.0 || t <= 0.0) return std::nullopt;
  return Eigen::Vector3d(0.5 * (from_left + s * a + from_right + t * b));
}

std::optional<Pose3> FitRigid(const std::vector<Eigen::Vector3d>& points_B,
                              const std::vector<Eigen::Vector3d>& points_A) {
  DOCKYARD_CHECK(points_A.size() == points_B.size());
  if (points_A.size() < 3) return std::nullopt;
  const double n = static_cast<double>(points_A.size());
  Eigen::Vector3d mean_a = Eigen::Vector3d::Zero(), mean_b = mean_a;
  for (std::size_t i = 0; i < points_A.size(); ++i) {
    mean_a += points_A[i] / n;
    mean_b += points_B[i] / n;
  }
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points_A.size(); ++i) {
    M += (points_A[i] - mean_a) * (points_B[i] - mean_b).transpose();
  }
  const Svd3 svd = Svd(M);
  if (!(svd.values(1) > 1e-9 * svd.values(0))) return std::nullopt;
  const Eigen::Matrix3d R_AB = NearestRotation(svd);
  return Pose3{.R = R_AB, .p = mean_a - R_AB * mean_b};
}

std::optional<Pose3> StereoPose(const StereoRig& rig, const FiducialBoard& board,
                                const std::vector<Eigen::Vector2d>& centres_left,
                                const std::vector<Eigen::Vector2d>& centres_right) {
  DOCKYARD_CHECK(centres_left.size() == board.fiducials.size());
  DOCKYARD_CHECK(centres_right.size() == board.fiducials.size());
  std::vector<Eigen::Vector3d> points_B, points_R;
  for (std::size_t id = 0; id < board.fiducials.size(); ++id) {
    const auto p_R = Triangulate(rig, centres_left[id], centres_right[id]);
    if (!p_R) continue;
    const Eigen::Vector2d& p = board.fiducials[id].p_BF;
    points_B.emplace_back(p.x(), p.y(), 0.0);
    points_R.push_back(*p_R);
  }
  return FitRigid(points_B, points_R);
}

std::vector<CameraView> Views(const StereoRig& rig) {
  return {{.camera = rig.left, .X_RC = rig.X_RL}, {.camera = rig.right, .X_RC = rig.X_RQ}};
}

}  // namespace dockyard
