#include "controller/vision/board/pose_gates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

// A third of the errors that count as wrong (0.3 m, 10 deg).
constexpr double kMostPlaceSigma_m = 0.1, kMostTurnSigma_rad = 10.0 / 3.0 * kPi / 180.0;

constexpr double kMostTurnSigmas = 5.0;

}  // namespace

bool IsUpright(const Eigen::Matrix3d& R_RB, const Eigen::Vector3d& up_R) {
  const double roll_sine = std::abs(R_RB.col(0).dot(up_R));
  const double lean_sine = std::abs(R_RB.col(2).dot(up_R));
  return -R_RB.col(1).dot(up_R) > 0.0 && roll_sine < std::sin(Radians(15.0)) &&
         lean_sine < std::sin(Radians(30.0));
}

bool IsUpright(const Pose3& X_RB, const Upright& rule, const Pose3& X_RC,
               const Eigen::Vector3d& up_R) {
  if (rule.against == Upright::Against::kPlumb) return IsUpright(X_RB.R, up_R);
  const Eigen::Vector3d sight = (X_RB.p - X_RC.p).normalized();
  const auto across = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(v - v.dot(sight) * sight);
  };
  const bool gravity = rule.against == Upright::Against::kGravity;
  const Eigen::Vector3d up = across(gravity ? up_R : Eigen::Vector3d(-X_RC.R.col(1)));
  const Eigen::Vector3d board_up = across(-X_RB.R.col(1));
  if (gravity && up.norm() < std::sin(Radians(15.0))) return false;
  return std::atan2(up.cross(board_up).norm(), up.dot(board_up)) <= rule.within_rad;
}

bool ShowsItsFace(const Pose3& X_CB) { return X_CB.p.z() > 0.0 && X_CB.R.col(2).dot(X_CB.p) > 0.0; }

double RmsGatePx(const Camera& camera, const Pose3& X_CB, double disc_diameter_m) {
  const double disc_px = camera.focal_px().x() * disc_diameter_m / std::max(X_CB.p.norm(), 0.1);
  return 2.0 + 0.02 * disc_px;
}

double ChiSquareLimit(int freedom) {
  constexpr double kNormalQuantile = 3.090;  // one in a thousand
  const double share = 2.0 / (9.0 * freedom);
  return freedom * std::pow(1.0 - share + kNormalQuantile * std::sqrt(share), 3);
}

std::optional<PoseFailure> Judge(const RefinedPose& fit, const std::vector<CameraView>& views,
                                 const LocateHints& hints, const Upright& rule) {
  for (const CameraView& view : views) {
    if (!ShowsItsFace(Inverse(view.X_RC) * fit.X_RB)) return PoseFailure::kBehindCamera;
  }
  const bool fits = fit.misfit <= ChiSquareLimit(fit.freedom);
  if (views.size() == 1 && !fits) return PoseFailure::kPoorFit;
  if (views.size() == 2) {
    // By the belief before the first sighting. One calibration in half a million is beyond five
    // sigma about any of three axes; one in five thousand is beyond four, and a rover with such
    // cameras would never dock.
    const CameraTurn at_first{};
    const Eigen::Vector3d sigmas =
        fit.turn.mean_rad.cwiseQuotient(at_first.covariance.diagonal().cwiseSqrt());
    const bool twisted = sigmas.cwiseAbs().maxCoeff() > kMostTurnSigmas;
    if (twisted || !fits) return PoseFailure::kCamerasDisagree;
  }
  const double place_m = std::sqrt(fit.covariance.topLeftCorner<3, 3>().trace());
  const double turn_rad = std::sqrt(fit.covariance.bottomRightCorner<3, 3>().trace());
  if (!(place_m < kMostPlaceSigma_m && turn_rad < kMostTurnSigma_rad)) {
    return PoseFailure::kUncertain;
  }
  if (!IsUpright(fit.X_RB, rule, views[0].X_RC, hints.up_R)) return PoseFailure::kNotUpright;
  return std::nullopt;
}

namespace {

bool IsPossible(const PlanarBranch& branch, const Pose3& X_RC, const LocateHints& hints,
                const Upright& rule) {
  return ShowsItsFace(branch.X_CB) && IsUpright(X_RC * branch.X_CB, rule, X_RC, hints.up_R);
}

/// Reprojection cost and squared deviation from the expected heading, both in sigmas squared.
double BranchScore(const PlanarBranch& branch, const Pose3& X_RC, const LocateHints& hints) {
  // How well odometry knows the heading against the board: assumed 5 deg (3-10), after a leg on
  // sand.
  constexpr double kExpectedSigma = 5.0 * kPi / 180.0;
  double score = branch.cost;
  if (hints.X_RB_expected) {
    const Pose3 X_RB = X_RC * branch.X_CB;
    const double cosine = X_RB.R.col(2).dot(hints.X_RB_expected->R.col(2));
    const double apart = std::acos(std::clamp(cosine, -1.0, 1.0)) / kExpectedSigma;
    score += apart * apart;
  }
  return score;
}

}  // namespace

std::optional<std::size_t> ChooseBranch(const std::vector<PlanarBranch>& branches,
                                        const Pose3& X_RC, const LocateHints& hints,
                                        const Upright& rule) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    if (!IsPossible(branches[i], X_RC, hints, rule)) continue;
    if (!best ||
        BranchScore(branches[i], X_RC, hints) < BranchScore(branches[*best], X_RC, hints)) {
      best = i;
    }
  }
  return best;
}

bool IsAmbiguous(const std::vector<PlanarBranch>& branches, std::size_t chosen, const Pose3& X_RC,
                 const LocateHints& hints, const Upright& rule, double noise) {
  constexpr double kClear = 9.0;  // three sigma between the branches
  // Branches nearer than this are one pose for any purpose here: half of "wrong" (10 deg).
  constexpr double kSame_rad = 5.0 * kPi / 180.0;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    if (i == chosen || !IsPossible(branches[i], X_RC, hints, rule)) continue;
    const Eigen::Matrix3d between = branches[i].X_CB.R.transpose() * branches[chosen].X_CB.R;
    if (Eigen::AngleAxisd(between).angle() < kSame_rad) continue;
    if (BranchScore(branches[i], X_RC, hints) <
        BranchScore(branches[chosen], X_RC, hints) + noise * kClear) {
      return true;
    }
  }
  return false;
}

}  // namespace dockyard
