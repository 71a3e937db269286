#include "controller/vision/pose_refine.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <optional>

#include "controller/base/check.h"

namespace dockyard {
namespace {

using State = Eigen::Matrix<double, 9, 1>;  // turn and shift of the body, relative turn
constexpr double kUnseenPx = 1e3;           // error of a point that the pose puts out of sight

Eigen::Matrix3d Turn(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  if (angle < 1e-14) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

/// The problem about a current estimate; a State is a step away from it.
class Problem {
 public:
  Problem(const std::vector<PointPixel>& points, const std::vector<CameraView>& views,
          const RefineOptions& options)
      : points_(points), views_(views), options_(options) {
    joint_ = options.fit_turn && views.size() == 2;
    offsets_.assign(points.size(), Eigen::Vector2d::Zero());
    // Square root of the prior's information: errors of unit variance.
    const Eigen::LLT<Eigen::Matrix3d> information(options.turn.covariance.inverse());
    DOCKYARD_CHECK(!joint_ || information.info() == Eigen::Success);
    prior_root_ = information.matrixU();
  }

  bool joint() const { return joint_; }
  int parameters() const { return joint_ ? 9 : 6; }
  int rows() const { return 2 * static_cast<int>(points_.size()) + (joint_ ? 3 : 0); }

  Pose3 CameraFromBody(int view, const Pose3& X_RB, const Eigen::Vector3d& turn) const {
    Pose3 X_RC = views_[static_cast<std::size_t>(view)].X_RC;
    if (views_.size() == 2) X_RC.R = X_RC.R * Turn((view == 0 ? -0.5 : 0.5) * turn);
    return Inverse(X_RC) * X_RB;
  }

  /// Errors over sigma: two for each point, then the relative turn's.
  Eigen::VectorXd Errors(const Pose3& X_RB, const Eigen::Vector3d& turn) const {
    Eigen::VectorXd errors(rows());
    std::vector<Pose3> X_CB;
    for (std::size_t v = 0; v < views_.size(); ++v) {
      X_CB.push_back(CameraFromBody(static_cast<int>(v), X_RB, turn));
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const PointPixel& point = points_[i];
      const std::size_t view = static_cast<std::size_t>(point.view);
      const Eigen::Vector3d p_C = X_CB[view] * point.p_B;
      const std::optional<Eigen::Vector2d> pixel = views_[view].camera.Project(p_C);
      Eigen::Vector2d error(kUnseenPx, kUnseenPx);
      if (pixel && p_C.z() > -0.3 * p_C.norm()) error = *pixel + offsets_[i] - point.pixel;
      errors.segment<2>(2 * static_cast<Eigen::Index>(i)) = error / options_.sigma_px;
    }
    if (joint_) errors.tail<3>() = prior_root_ * (turn - options_.turn.mean_rad);
    return errors;
  }

  /// Centre of the projected disc less projected centre, for the current pose.
  void UpdateOffsets(const Pose3& X_RB, const Eigen::Vector3d& turn) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const PointPixel& point = points_[i];
      if (point.disc_diameter_m <= 0.0) continue;
      const Camera& camera = views_[static_cast<std::size_t>(point.view)].camera;
      const Pose3 X_CB = CameraFromBody(point.view, X_RB, turn);
      const auto disc = ProjectDisc(camera, X_CB, point.p_B, point.disc_diameter_m);
      const auto centre = camera.Project(X_CB * point.p_B);
      offsets_[i] = disc && centre ? Eigen::Vector2d(*disc - *centre) : Eigen::Vector2d::Zero();
    }
  }

  /// Huber's loss on the length of each point's error; weights come out for reweighted least
  /// squares.
  double Cost(const Eigen::VectorXd& errors, Eigen::VectorXd* weights) const {
    if (weights) weights->setOnes(errors.size());
    double cost = joint_ ? errors.tail<3>().squaredNorm() : 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Index row = 2 * static_cast<Eigen::Index>(i);
      const double length = errors.segment<2>(row).norm();
      const double bend = options_.huber_sigmas;
      cost += length <= bend ? length * length : bend * (2.0 * length - bend);
      if (weights && length > bend) weights->segment<2>(row).setConstant(bend / length);
    }
    return cost;
  }

  /// How the errors move with what the calibration may be off by one sigma: focal length and centre
  /// of each camera.
  Eigen::MatrixXd CalibrationJacobian(bool with_centre) const {
    const Eigen::Index each = 3;
    Eigen::MatrixXd J =
        Eigen::MatrixXd::Zero(rows(), each * static_cast<Eigen::Index>(views_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const PointPixel& point = points_[i];
      const Eigen::Vector2d centre =
          views_[static_cast<std::size_t>(point.view)].camera.centre_px();
      const Eigen::Index row = 2 * static_cast<Eigen::Index>(i), column = each * point.view;
      J.block<2, 1>(row, column) = options_.spread.focal * (point.pixel - centre);
      if (!with_centre) continue;
      J.block<2, 2>(row, column + 1) = options_.spread.centre_px * Eigen::Matrix2d::Identity();
    }
    return J / options_.sigma_px;
  }

 private:
  const std::vector<PointPixel>& points_;
  const std::vector<CameraView>& views_;
  const RefineOptions& options_;
  bool joint_ = false;
  Eigen::Matrix3d prior_root_ = Eigen::Matrix3d::Identity();
  std::vector<Eigen::Vector2d> offsets_;
};

struct Estimate {
  Pose3 X_RB;
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
};

Estimate Moved(const Estimate& at, const State& step) {
  return {.X_RB = {at.X_RB.R * Turn(step.head<3>()), at.X_RB.p + step.segment<3>(3)},
          .turn = at.turn + step.tail<3>()};
}

Eigen::MatrixXd Jacobian(const Problem& problem, const Estimate& at,
                         const Eigen::VectorXd& errors) {
  constexpr double kStep = 1e-6;  // rad or m: rounding 1e-7 px against a curvature below 1e-6 px
  Eigen::MatrixXd J(problem.rows(), problem.parameters());
  for (int column = 0; column < problem.parameters(); ++column) {
    const Estimate moved = Moved(at, kStep * State::Unit(column));
    J.col(column) = (problem.Errors(moved.X_RB, moved.turn) - errors) / kStep;
  }
  return J;
}

/// Levenberg-Marquardt with fixed offsets.
Estimate Descend(const Problem& problem, Estimate at, int max_iterations) {
  double damping = 1e-3;
  Eigen::VectorXd weights;
  Eigen::VectorXd errors = problem.Errors(at.X_RB, at.turn);
  double cost = problem.Cost(errors, &weights);
  for (int i = 0; i < max_iterations; ++i) {
    const Eigen::MatrixXd J = Jacobian(problem, at, errors);
    const Eigen::MatrixXd A = J.transpose() * weights.asDiagonal() * J;
    const Eigen::VectorXd g = J.transpose() * weights.asDiagonal() * errors;
    bool better = false;
    double gain = 0.0;
    while (!better && damping < 1e8) {
      Eigen::MatrixXd damped = A;
      damped.diagonal() *= 1.0 + damping;
      damped.diagonal().array() += 1e-12;
      State step = State::Zero();
      step.head(problem.parameters()) = -damped.ldlt().solve(g);
      if (!step.allFinite()) return at;
      const Estimate moved = Moved(at, step);
      const Eigen::VectorXd moved_errors = problem.Errors(moved.X_RB, moved.turn);
      const double moved_cost = problem.Cost(moved_errors, nullptr);
      better = moved_cost < cost;
      damping *= better ? 0.2 : 8.0;
      if (!better) continue;
      gain = cost - moved_cost;
      at = moved;
      errors = moved_errors;
      cost = problem.Cost(errors, &weights);
    }
    if (!better || gain < 1e-9 * (1.0 + cost)) break;
  }
  return at;
}

/// Covariance of the state, calibration spread as in Schmidt's consider covariance (NASA TR R-135,
/// 1962): what is not estimated enters through its sensitivity.
Eigen::MatrixXd StateCovariance(const Problem& problem, const Estimate& at, bool with_centre) {
  const Eigen::VectorXd errors = problem.Errors(at.X_RB, at.turn);
  Eigen::VectorXd weights;
  problem.Cost(errors, &weights);
  const Eigen::MatrixXd J = Jacobian(problem, at, errors);
  Eigen::MatrixXd A = J.transpose() * weights.asDiagonal() * J;
  A.diagonal().array() += 1e-12;
  const Eigen::MatrixXd P =
      A.ldlt().solve(Eigen::MatrixXd::Identity(problem.parameters(), problem.parameters()));
  const Eigen::MatrixXd K =
      P * J.transpose() * weights.asDiagonal() * problem.CalibrationJacobian(with_centre);
  return P + K * K.transpose();
}

/// The upper 6x6 of a state's covariance as RefinedPose gives it, the pair's mounting added.
Matrix6d PoseCovariance(const Eigen::MatrixXd& state, const Pose3& X_RB, double mounting_rad) {
  Matrix6d T = Matrix6d::Zero();  // (turn about B's axes, shift) -> (shift, turn about R's axes)
  T.block<3, 3>(0, 3) = Eigen::Matrix3d::Identity();
  T.block<3, 3>(3, 0) = X_RB.R;
  Matrix6d covariance = T * state.topLeftCorner<6, 6>() * T.transpose();
  Eigen::Matrix<double, 6, 3> mounting;  // a turn w of the pair: shift w x p, turn w
  mounting.topRows<3>() << 0, X_RB.p.z(), -X_RB.p.y(), -X_RB.p.z(), 0, X_RB.p.x(), X_RB.p.y(),
      -X_RB.p.x(), 0;
  mounting.bottomRows<3>() = Eigen::Matrix3d::Identity();
  covariance += mounting_rad * mounting_rad * mounting * mounting.transpose();
  return covariance;
}

}  // namespace

std::optional<Eigen::Vector2d> ProjectDisc(const Camera& camera, const Pose3& X_CB,
                                           const Eigen::Vector3d& p_BF, double diameter_m) {
  constexpr int kSides = 24;  // the polygon's centroid then follows the disc's to 1 % of the offset
  std::array<Eigen::Vector2d, kSides> rim;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * kPi * i / kSides;
    const auto pixel = camera.Project(
        X_CB * (p_BF + 0.5 * diameter_m * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0)));
    if (!pixel) return std::nullopt;
    rim[static_cast<std::size_t>(i)] = *pixel;
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
  DOCKYARD_CHECK(points.size() >= 3 && !views.empty());
  Problem problem(points, views, options);
  Estimate at{.X_RB = X_RB_start, .turn = options.turn.mean_rad};
  for (int round = 0; round < 3; ++round) {  // offsets depend on the pose, but weakly
    problem.UpdateOffsets(at.X_RB, at.turn);
    at = Descend(problem, at, round == 0 ? options.max_iterations : 6);
  }
  const Eigen::VectorXd errors = problem.Errors(at.X_RB, at.turn);
  RefinedPose refined{.X_RB = at.X_RB, .turn = options.turn};
  refined.cost = problem.Cost(errors, nullptr);
  const Eigen::MatrixXd state = StateCovariance(problem, at, true);
  refined.covariance = PoseCovariance(state, at.X_RB, options.spread.mounting_rad);
  if (problem.joint()) {
    // A shift of the image centres acts as a turn and is part of what is estimated: the first
    // belief holds it, so it does not widen the next one.
    refined.turn = {at.turn, StateCovariance(problem, at, false).bottomRightCorner<3, 3>()};
  }
  refined.view_rms_px.assign(views.size(), 0.0);
  std::vector<int> counts(views.size(), 0);
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double error =
        options.sigma_px * errors.segment<2>(2 * static_cast<Eigen::Index>(i)).norm();
    const std::size_t view = static_cast<std::size_t>(points[i].view);
    refined.mark_error_px.push_back(error);
    refined.view_rms_px[view] += error * error;
    ++counts[view];
    sum += error * error;
  }
  for (std::size_t v = 0; v < views.size(); ++v) {
    if (counts[v] > 0) refined.view_rms_px[v] = std::sqrt(refined.view_rms_px[v] / counts[v]);
  }
  refined.rms_px = std::sqrt(sum / static_cast<double>(points.size()));
  return refined;
}

RefinedPose RefinePose(const std::vector<MarkPixel>& marks, const std::vector<CameraView>& views,
                       const FiducialBoard& board, const Pose3& X_RB_start,
                       const RefineOptions& options) {
  std::vector<PointPixel> points;
  for (const MarkPixel& mark : marks) {
    const Eigen::Vector2d& p = board.fiducials[static_cast<std::size_t>(mark.id)].p_BF;
    points.push_back({.p_B = {p.x(), p.y(), 0.0},
                      .view = mark.view,
                      .pixel = mark.pixel,
                      .disc_diameter_m = board.disc_diameter_m});
  }
  return RefinePoints(points, views, X_RB_start, options);
}

}  // namespace dockyard
