#include "controller/vision/pose_problem.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr double kUnseen_px = 1e3;  // error of a point that the pose puts out of sight

Eigen::Matrix3d Turn(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  if (angle < 1e-14) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

}  // namespace

PoseEstimate Moved(const PoseEstimate& at, const PoseStep& step) {
  return {.X_RB = {at.X_RB.R * Turn(step.head<3>()), at.X_RB.p + step.segment<3>(3)},
          .turn_rad = at.turn_rad + step.tail<3>()};
}

PoseProblem::PoseProblem(const std::vector<PointPixel>& points,
                         const std::vector<CameraView>& views, const RefineOptions& options)
    : points_(points), views_(views), options_(options) {
  joint_ = options.fit_turn && views.size() == 2;
  offsets_.assign(points.size(), Eigen::Vector2d::Zero());
  if (!joint_) return;
  // Square root of the prior's information: errors of unit variance.
  const Eigen::LLT<Eigen::Matrix3d> information(options.turn.covariance.inverse());
  DOCKYARD_CHECK(information.info() == Eigen::Success);
  prior_root_ = information.matrixU();
}

std::array<PoseProblem::PosedCamera, 2> PoseProblem::PosedCameras(const PoseEstimate& at) const {
  std::array<PosedCamera, 2> posed_cameras;
  for (std::size_t v = 0; v < views_.size(); ++v) {
    PosedCamera& posed = posed_cameras[v];
    const Pose3& X_RC = views_[v].X_RC;
    posed.R_CR = X_RC.R.transpose();
    posed.turn_by_step.setZero();
    if (views_.size() == 2) {
      const double half = v == 0 ? -0.5 : 0.5;
      posed.R_CR = Turn(half * at.turn_rad).transpose() * posed.R_CR;
      // Right Jacobian of the rotation vector, to first order: the turn is below 1 deg.
      posed.turn_by_step =
          half * (Eigen::Matrix3d::Identity() - 0.5 * half * CrossMatrix(at.turn_rad));
    }
    posed.p_CR = -(posed.R_CR * X_RC.p);
    posed.R_CB = posed.R_CR * at.X_RB.R;
    posed.p_CB = posed.R_CR * at.X_RB.p + posed.p_CR;
  }
  return posed_cameras;
}

double PoseProblem::Sigma(std::size_t point) const {
  const double own = points_[point].sigma_px;
  return own > 0.0 ? own : options_.sigma_px;
}

Eigen::Vector2d PoseProblem::Error(const PosedCamera& posed, std::size_t i,
                                   PixelJacobian* J) const {
  const PointPixel& point = points_[i];
  const Camera& camera = views_[static_cast<std::size_t>(point.view)].camera;
  const Eigen::Vector3d p_C = posed.R_CB * point.p_B + posed.p_CB;
  const auto pixel = J ? camera.Project(p_C, *J) : camera.Project(p_C);
  if (!pixel || p_C.z() <= -0.3 * p_C.norm()) {
    if (J) J->setZero();
    return {kUnseen_px, kUnseen_px};
  }
  return *pixel + offsets_[i] - point.pixel;
}

void PoseProblem::Steps(const PosedCamera& posed, std::size_t i, const PixelJacobian& J,
                        Eigen::Matrix<double, 2, 9>* by_step) const {
  const PointPixel& point = points_[i];
  by_step->leftCols<3>() = -(J * posed.R_CB) * CrossMatrix(point.p_B);
  by_step->middleCols<3>(3) = J * posed.R_CR;
  if (joint_) {
    const Eigen::Vector3d p_C = posed.R_CB * point.p_B + posed.p_CB;
    by_step->rightCols<3>() = J * CrossMatrix(p_C) * posed.turn_by_step;
  } else {
    by_step->rightCols<3>().setZero();
  }
}

double PoseProblem::UpdateOffsets(const PoseEstimate& at) {
  const std::array<PosedCamera, 2> posed_cameras = PosedCameras(at);
  double most = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PointPixel& point = points_[i];
    if (point.disc_diameter_m <= 0.0) continue;
    const Camera& camera = views_[static_cast<std::size_t>(point.view)].camera;
    const PosedCamera& posed = posed_cameras[static_cast<std::size_t>(point.view)];
    const Pose3 X_CB{posed.R_CB, posed.p_CB};
    const auto disc = ProjectDisc(camera, X_CB, point.p_B, point.disc_diameter_m);
    const auto centre = camera.Project(X_CB * point.p_B);
    const Eigen::Vector2d offset =
        disc && centre ? Eigen::Vector2d(*disc - *centre) : Eigen::Vector2d::Zero();
    most = std::max(most, (offset - offsets_[i]).norm());
    offsets_[i] = offset;
  }
  return most;
}

double PoseProblem::Cost(const PoseEstimate& at) const { return Cost(at, nullptr); }

double PoseProblem::Cost(const PoseEstimate& at, NormalEquations* normal) const {
  const std::array<PosedCamera, 2> posed_cameras = PosedCameras(at);
  const double bend = options_.huber_sigmas;
  double cost = 0.0;
  if (normal) {
    normal->A.setZero();
    normal->b.setZero();
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PosedCamera& posed = posed_cameras[static_cast<std::size_t>(points_[i].view)];
    PixelJacobian J;
    const double sigma = Sigma(i);
    const Eigen::Vector2d error = Error(posed, i, normal ? &J : nullptr) / sigma;
    const double length = error.norm();
    cost += length <= bend ? length * length : bend * (2.0 * length - bend);
    if (!normal) continue;
    const double weight = length <= bend ? 1.0 : bend / length;
    Eigen::Matrix<double, 2, 9> rows;
    Steps(posed, i, J, &rows);
    rows /= sigma;
    normal->A.noalias() += weight * rows.transpose() * rows;
    normal->b.noalias() += weight * rows.transpose() * error;
  }
  if (joint_) {
    const Eigen::Vector3d prior = PriorError(at);
    cost += prior.squaredNorm();
    if (normal) {
      normal->A.bottomRightCorner<3, 3>() += prior_root_.transpose() * prior_root_;
      normal->b.tail<3>() += prior_root_.transpose() * prior;
    }
  } else if (normal) {
    normal->A.bottomRightCorner<3, 3>().setIdentity();
  }
  return cost;
}

std::vector<Eigen::Vector2d> PoseProblem::Errors(const PoseEstimate& at) const {
  const std::array<PosedCamera, 2> posed_cameras = PosedCameras(at);
  std::vector<Eigen::Vector2d> errors;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    errors.push_back(Error(posed_cameras[static_cast<std::size_t>(points_[i].view)], i, nullptr));
  }
  return errors;
}

PoseProblem::PointRows PoseProblem::Rows(const PoseEstimate& at, std::size_t i) const {
  const PointPixel& point = points_[i];
  const PosedCamera posed = PosedCameras(at)[static_cast<std::size_t>(point.view)];
  PixelJacobian J;
  PointRows rows;
  const double sigma = Sigma(i);
  rows.error = Error(posed, i, &J) / sigma;
  rows.weight = std::min(1.0, options_.huber_sigmas / std::max(rows.error.norm(), 1e-12));
  Steps(posed, i, J, &rows.by_step);
  rows.by_step /= sigma;
  const Camera& camera = views_[static_cast<std::size_t>(point.view)].camera;
  const Eigen::Vector2d out = point.pixel - camera.centre_px();
  const double share = 2.0 * out.norm() / camera.width;  // of half the image's width
  rows.by_calibration.col(0) = options_.spread.focal * out;
  rows.by_calibration.middleCols<2>(1) = options_.spread.centre_px * Eigen::Matrix2d::Identity();
  rows.by_calibration.col(3) = options_.spread.radial_px * share * share * 2.0 / camera.width * out;
  rows.by_calibration /= sigma;
  return rows;
}

Eigen::Vector3d PoseProblem::PriorError(const PoseEstimate& at) const {
  return prior_root_ * (at.turn_rad - options_.turn.mean_rad);
}

}  // namespace dockyard
