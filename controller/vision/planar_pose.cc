#include "controller/vision/planar_pose.h"

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <utility>

#include "controller/geometry/decompositions.h"
#include "controller/vision/homography.h"

namespace dockyard {
namespace {

/// Rotation and translation out of H ~ [r1 r2 p].
std::optional<Pose3> Decompose(const Eigen::Matrix3d& H) {
  double scale = 2.0 / (H.col(0).norm() + H.col(1).norm());
  if (H(2, 2) < 0.0) scale = -scale;
  Eigen::Matrix3d M;
  M.col(0) = scale * H.col(0);
  M.col(1) = scale * H.col(1);
  M.col(2) = M.col(0).cross(M.col(1));
  if (!M.allFinite() || std::abs(M.determinant()) < 1e-12) return std::nullopt;
  return Pose3{.R = NearestRotation(M), .p = scale * H.col(2)};
}

std::optional<Pose3> StartFromHomography(const std::vector<MarkPixel>& marks, const Camera& camera,
                                         const FiducialBoard& board) {
  std::vector<Eigen::Vector3d> rays;
  for (const MarkPixel& mark : marks) rays.push_back(camera.Direction(mark.pixel));
  const TangentPlane plane = TangentPlaneAt(rays);
  std::vector<PlanePair> pairs;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    pairs.push_back({.board = board.fiducials[static_cast<std::size_t>(marks[i].id)].p_BF,
                     .image = plane.FromRay(rays[i])});
  }
  const std::optional<Eigen::Matrix3d> H = FitHomography(pairs);
  if (!H) return std::nullopt;
  const std::optional<Pose3> X_TB = Decompose(*H);
  if (!X_TB) return std::nullopt;
  return Pose3{plane.R_TC.transpose(), Eigen::Vector3d::Zero()} * *X_TB;
}

/// The other pose of the ambiguity: the board's normal mirrored about the line of sight to the
/// board's centre.
Pose3 Mirrored(const Pose3& X_CB) {
  const Eigen::Vector3d sight = X_CB.p.normalized(), normal = X_CB.R.col(2);
  const Eigen::Vector3d other = 2.0 * normal.dot(sight) * sight - normal;
  return {RotationBetween(normal, other) * X_CB.R, X_CB.p};
}

PlanarBranch Settle(const std::vector<MarkPixel>& marks, const Camera& camera,
                    const FiducialBoard& board, const Pose3& X_CB_start) {
  const RefinedPose refined = RefinePose(marks, {{.camera = camera, .X_RC = Pose3{}}}, board,
                                         X_CB_start, {.with_covariance = false});
  return {.X_CB = refined.X_RB, .rms_px = refined.rms_px, .cost = refined.cost};
}

}  // namespace

std::vector<PlanarBranch> PlanarPose(const std::vector<MarkPixel>& marks, const Camera& camera,
                                     const FiducialBoard& board) {
  if (marks.size() < 4) return {};
  const std::optional<Pose3> start = StartFromHomography(marks, camera, board);
  if (!start) return {};
  std::vector<PlanarBranch> branches{Settle(marks, camera, board, *start)};
  branches.push_back(Settle(marks, camera, board, Mirrored(branches[0].X_CB)));
  if (branches[1].cost < branches[0].cost) std::swap(branches[0], branches[1]);
  const double apart =
      Eigen::AngleAxisd(branches[0].X_CB.R.transpose() * branches[1].X_CB.R).angle();
  if (apart < Radians(0.5)) branches.pop_back();
  return branches;
}

}  // namespace dockyard
