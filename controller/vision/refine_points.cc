#include "controller/vision/descend.h"
#include "controller/vision/pose_refine.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <optional>

#include "controller/base/check.h"
#include "controller/vision/pose_linear.h"
#include "controller/vision/pose_problem.h"

namespace dockyard {
namespace {

/// All errors about the optimum, linear: A over the step and the calibration terms of all views.
struct Linear {
  Square step;           // normal matrix of the step, Huber's weights and prior included
  Square to_nuisance;    // weighted, step against calibration
  Square all;            // step and calibration together, without weights
  StateColumn b;         // of the same
  double squares = 0.0;  // of all errors
};

Linear Linearise(const PoseProblem& problem, const PoseEstimate& at, std::size_t views,
                 const std::vector<PointPixel>& points) {
  const int nuisance = 4 * static_cast<int>(views), n = 9 + nuisance;
  Linear linear{.step = Square::Zero(9, 9),
                .to_nuisance = Square::Zero(9, nuisance),
                .all = Square::Zero(n, n),
                .b = StateColumn::Zero(n)};
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const PoseProblem::PointRows rows = problem.Rows(at, i);
    const int own = 4 * points[i].view;
    linear.step += rows.weight * rows.by_step.transpose() * rows.by_step;
    linear.to_nuisance.middleCols(own, 4) +=
        rows.weight * rows.by_step.transpose() * rows.by_calibration;
    Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, kMost> line =
        Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, kMost>::Zero(2, n);
    line.leftCols<9>() = rows.by_step;
    line.middleCols(9 + own, 4) = rows.by_calibration;
    linear.all += line.transpose() * line;
    linear.b += line.transpose() * rows.error;
    linear.squares += rows.error.squaredNorm();
  }
  if (problem.joint()) {
    const Eigen::Matrix3d information = problem.prior_root().transpose() * problem.prior_root();
    const Eigen::Vector3d prior = problem.PriorError(at);
    linear.step.bottomRightCorner(3, 3) += information;
    linear.all.block(6, 6, 3, 3) += information;
    linear.b.segment(6, 3) += problem.prior_root().transpose() * prior;
    linear.squares += prior.squaredNorm();
  } else {
    linear.step.bottomRightCorner(3, 3).setIdentity();
    linear.all.block(6, 6, 3, 3).setIdentity();
  }
  linear.all.bottomRightCorner(nuisance, nuisance).diagonal().array() += 1.0;
  linear.step.diagonal().array() += 1e-12;
  return linear;
}

/// Covariance of the step, calibration spread as in Schmidt's consider covariance (NASA TR R-135,
/// 1962): terms that are not estimated enter through their sensitivity.
Square StepCovariance(const Linear& linear, bool with_centre) {
  const Square P = linear.step.ldlt().solve(Square::Identity(9, 9));
  Square K = P * linear.to_nuisance;
  for (Eigen::Index c = 0; c < K.cols() && !with_centre; ++c) {
    if (c % 4 == 1 || c % 4 == 2) K.col(c).setZero();
  }
  return P + K * K.transpose();
}

}  // namespace

Matrix6d PoseCovariance(const Square& step, const Pose3& X_RB, double mounting_rad) {
  Matrix6d T = Matrix6d::Zero();  // (turn about B's axes, shift) -> (shift, turn about R's axes)
  T.block<3, 3>(0, 3) = Eigen::Matrix3d::Identity();
  T.block<3, 3>(3, 0) = X_RB.R;
  Matrix6d covariance = T * step.topLeftCorner<6, 6>() * T.transpose();
  Eigen::Matrix<double, 6, 3> mounting;  // a turn w of the pair: shift w x p, turn w
  mounting.topRows<3>() << 0, X_RB.p.z(), -X_RB.p.y(), -X_RB.p.z(), 0, X_RB.p.x(), X_RB.p.y(),
      -X_RB.p.x(), 0;
  mounting.bottomRows<3>() = Eigen::Matrix3d::Identity();
  covariance += mounting_rad * mounting_rad * mounting * mounting.transpose();
  return covariance;
}

namespace {

/// How well the errors agree with their own prediction: least squares over the step and the
/// calibration terms, each of unit variance. With true sigmas `misfit` is chi-square distributed.
void AddConsistency(const PoseProblem& problem, const PoseEstimate& at, const Linear& linear,
                    const std::vector<PointPixel>& points, RefinedPose* refined) {
  const StateColumn shift = -linear.all.ldlt().solve(linear.b);
  refined->misfit = std::max(0.0, linear.squares + linear.b.dot(shift));
  refined->freedom = 2 * static_cast<int>(problem.size()) - 6;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const PoseProblem::PointRows rows = problem.Rows(at, i);
    const Eigen::Vector2d left = rows.error + rows.by_step * shift.head(9) +
                                 rows.by_calibration * shift.segment(9 + 4 * points[i].view, 4);
    refined->mark_sigmas.push_back(left.norm());
  }
}

}  // namespace

void AddErrors(const PoseProblem& problem, const PoseEstimate& at, std::size_t views,
               const std::vector<PointPixel>& points, RefinedPose* refined) {
  refined->view_rms_px.assign(views, 0.0);
  std::vector<int> counts(views, 0);
  double sum = 0.0;
  const std::vector<Eigen::Vector2d> errors = problem.Errors(at);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const std::size_t view = static_cast<std::size_t>(points[i].view);
    refined->mark_error_px.push_back(errors[i].norm());
    refined->view_rms_px[view] += errors[i].squaredNorm();
    ++counts[view];
    sum += errors[i].squaredNorm();
  }
  for (std::size_t v = 0; v < views; ++v) {
    if (counts[v] > 0) refined->view_rms_px[v] = std::sqrt(refined->view_rms_px[v] / counts[v]);
  }
  refined->rms_px = std::sqrt(sum / static_cast<double>(errors.size()));
}

std::optional<Eigen::Vector2d> ProjectDisc(const Camera& camera, const Pose3& X_CB,
                                           const Eigen::Vector3d& p_BF, double diameter_m) {
  // A regular octagon with the disc's second moment: radius r sqrt(3 / (2 + cos(45 deg))). Its
  // image's centroid then differs from the disc's by the effect of the fourth moment alone.
  constexpr int kSides = 8;
  const double radius_m = 0.5 * diameter_m * std::sqrt(3.0 / (2.0 + std::sqrt(0.5)));
  std::array<Eigen::Vector2d, kSides> rim;
  const double h = std::sqrt(0.5);
  constexpr std::array<std::array<int, 2>, kSides> kDirections{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  for (std::size_t i = 0; i < kSides; ++i) {
    const double scale = radius_m * (i % 2 == 0 ? 1.0 : h);
    const Eigen::Vector3d out(scale * kDirections[i][0], scale * kDirections[i][1], 0.0);
    const auto pixel = camera.Project(X_CB * (p_BF + out));
    if (!pixel) return std::nullopt;
    rim[i] = *pixel;
  }
  double area = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  const Eigen::Vector2d origin = rim[0];
  for (std::size_t i = 0; i < kSides; ++i) {
    const Eigen::Vector2d a = rim[i] - origin, b = rim[(i + 1) % kSides] - origin;
    const double cross = a.x() * b.y() - a.y() * b.x();
    area += cross;
    moment += cross * (a + b);
  }
  if (std::abs(area) < 1e-12) return std::nullopt;
  return Eigen::Vector2d(origin + moment / (3.0 * area));
}

std::optional<Eigen::Vector2d> ProjectDisc(const Camera& camera, const Pose3& X_CB,
                                           const Fiducial& fiducial, double diameter_m) {
  return ProjectDisc(camera, X_CB, Eigen::Vector3d(fiducial.p_BF.x(), fiducial.p_BF.y(), 0.0),
                     diameter_m);
}

RefinedPose RefinePoints(const std::vector<PointPixel>& points,
                         const std::vector<CameraView>& views, const Pose3& X_RB_start,
                         const RefineOptions& options) {
  DOCKYARD_CHECK(points.size() >= 3 && !views.empty() && views.size() <= 2);
  PoseProblem problem(points, views, options);
  PoseEstimate at{.X_RB = X_RB_start, .turn_rad = options.turn.mean_rad};
  for (int round = 0; round < 4; ++round) {  // offsets depend on the pose, but weakly
    const double change = problem.UpdateOffsets(at);
    if (round > 0 && change < 1e-3) break;
    at = Descend<NormalEquations>(problem, at, round == 0 ? options.max_iterations : 6, 1e-9);
  }
  RefinedPose refined{.X_RB = at.X_RB, .turn = options.turn};
  if (problem.joint()) refined.turn.mean_rad = at.turn_rad;
  refined.cost = problem.Cost(at);
  AddErrors(problem, at, views.size(), points, &refined);
  if (!options.with_covariance) return refined;
  const Linear linear = Linearise(problem, at, views.size(), points);
  refined.covariance =
      PoseCovariance(StepCovariance(linear, true), at.X_RB, options.spread.mounting_rad);
  if (problem.joint()) {
    // A shift of the image centres acts as a turn and is estimated with it. The first belief
    // contains it, so it does not widen the next one.
    refined.turn.covariance = StepCovariance(linear, false).bottomRightCorner<3, 3>();
  }
  AddConsistency(problem, at, linear, points, &refined);
  return refined;
}

double MarkSigmaPx(const MarkPixel& mark, const CameraView& view, const FiducialBoard& board,
                   const Pose3& X_RB, const RefineOptions& options) {
  double sigma_px = std::hypot(mark.sigma_px, options.model_px);
  if (options.off_plane_m > 0.0) {
    const Eigen::Vector2d& p = board.fiducials[static_cast<std::size_t>(mark.id)].p_BF;
    const Pose3 X_CB = Inverse(view.X_RC) * X_RB;
    const auto on = view.camera.Project(X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0));
    const auto off = view.camera.Project(X_CB * Eigen::Vector3d(p.x(), p.y(), options.off_plane_m));
    if (on && off) sigma_px = std::hypot(sigma_px, (*off - *on).norm() / std::sqrt(2.0));
  }
  return sigma_px * options.noise_scale;
}

RefinedPose RefinePose(const std::vector<MarkPixel>& marks, const std::vector<CameraView>& views,
                       const FiducialBoard& board, const Pose3& X_RB_start,
                       const RefineOptions& options) {
  std::vector<PointPixel> points;
  for (const MarkPixel& mark : marks) {
    const Eigen::Vector2d& p = board.fiducials[static_cast<std::size_t>(mark.id)].p_BF;
    points.push_back(
        {.p_B = {p.x(), p.y(), 0.0},
         .view = mark.view,
         .pixel = mark.pixel,
         .disc_diameter_m = board.disc_diameter_m,
         .sigma_px = mark.sigma_px > 0.0
                         ? MarkSigmaPx(mark, views[static_cast<std::size_t>(mark.view)], board,
                                       X_RB_start, options)
                         : 0.0});
  }
  return RefinePoints(points, views, X_RB_start, options);
}

}  // namespace dockyard
