#include "controller/custom/sighting_fix.h"

#include <algorithm>
#include <limits>

#include "controller/custom/level_pose.h"

namespace dockyard::custom {
namespace {

// Errors of lens and board move the branches' misfits by more than noise does. Assumed, 2-8.
constexpr double kMostMisfit = 4.0;

}  // namespace

Eigen::Vector3d UpIn(const ImuSample& imu) {
  return (RotY(imu.pitch_rad) * RotX(imu.roll_rad)).transpose() * Eigen::Vector3d::UnitZ();
}

std::vector<DockFix> FixesOf(const BoardSighting& sighting, const Nominal& nominal,
                             const Pose2& X_OR, const ImuSample& imu) {
  const Pose3& X_RC = nominal.cameras[static_cast<std::size_t>(sighting.camera)].X_RC;
  const Pose3& X_DB = nominal.boards[static_cast<std::size_t>(sighting.board)].X_DB;
  double least = std::numeric_limits<double>::infinity();
  for (const PoseBranch& branch : sighting.branches) least = std::min(least, branch.misfit);
  // Marks that err by more than predicted, as in a shade, err so in both branches.
  double excess = 1.0;
  if (!sighting.branches.empty() && sighting.branches[0].freedom > 0)
    excess = std::max(1.0, least / sighting.branches[0].freedom);
  const Eigen::Matrix3d R_OR = RotZ(X_OR.heading);
  std::vector<DockFix> fixes;
  for (PoseBranch branch : sighting.branches) {
    branch.covariance *= excess;
    const PlacedDock dock = PlaceDock(branch, X_RC, X_DB, nominal.height_m, imu);
    fixes.push_back(
        {.X_OD = X_OR * dock.X_HD,
         .covariance = R_OR * dock.covariance * R_OR.transpose(),
         .misfit = dock.floor_misfit + std::min((branch.misfit - least) / excess, kMostMisfit),
         .lasting = R_OR * dock.lasting * R_OR.transpose()});
  }
  return fixes;
}

SightingReport ReportOf(const BoardSighting& sighting, const Nominal& nominal) {
  const RobotCamera& camera = nominal.cameras[static_cast<std::size_t>(sighting.camera)];
  SightingReport report;
  report.reason = sighting.failure;
  report.method = camera.name;
  report.detected.assign(nominal.cameras.size(), 0);
  report.detected[static_cast<std::size_t>(sighting.camera)] = sighting.detected;
  report.marks = sighting.marks;
  report.reprojection_px = std::numeric_limits<double>::quiet_NaN();
  if (sighting.branches.empty()) return report;
  const PoseBranch& best = sighting.branches.front();
  report.reprojection_px = best.rms_px;
  report.X_RB = camera.X_RC * best.X_CB;
  Eigen::Matrix<double, 6, 6> J = Eigen::Matrix<double, 6, 6>::Zero();
  J.topLeftCorner<3, 3>() = J.bottomRightCorner<3, 3>() = camera.X_RC.R;
  report.covariance = J * best.covariance * J.transpose();
  return report;
}

}  // namespace dockyard::custom
