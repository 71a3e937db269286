#include "controller/vision/points/point_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "controller/base/check.h"
#include "controller/vision/descend.h"
#include "controller/vision/pose_linear.h"

namespace dockyard {

constexpr int kSought = 17;  // 6 of the pose, 3 of the turn, 4 of each camera's calibration
// Descend finds it by its argument, so not in the namespace below.
static PointEstimate Moved(const PointEstimate& at, const Eigen::Matrix<double, kSought, 1>& step) {
  return {.pose = Moved(at.pose, PoseStep(step.head<9>())),
          .calibration = at.calibration + step.tail<8>()};
}

namespace {

using Matrix17 = Eigen::Matrix<double, kSought, kSought>;
using Vector17 = Eigen::Matrix<double, kSought, 1>;
// Where Huber's loss turns linear, in sigmas of a pixel; 2 leaves 97 % of good points' weight (86 %
// lie within 2 of Rayleigh's distribution). Assumed, 1.5-4.
constexpr double kHuberSigmas = 2.0;

struct Equations {
  Matrix17 A;
  Vector17 b;  // A step = -b
};

class Problem {
 public:
  Problem(const std::vector<PointPixel>& points, const std::vector<CameraView>& views,
          const PointFitOptions& options, const RefineOptions& refine)
      : surveyed_(points),
        places_(points),
        groups_(GroupsOf(points)),
        options_(options),
        problem_(places_, views, refine) {}

  /// Robust sum of squares; with `equations` their normal equations too.
  double Cost(const PointEstimate& at, Equations* equations = nullptr);
  double Squares(const PointEstimate& at);  // not robust
  double UpdateOffsets(const PointEstimate& at) { return problem_.UpdateOffsets(at.pose); }
  const PoseProblem& pose() const { return problem_; }
  void ToSurvey() { places_ = surveyed_; }

 private:
  /// One pixel at the places as they are now.
  struct Rows {
    Eigen::Vector2d error;
    Eigen::Matrix<double, 2, kSought> by_step;
    Eigen::Matrix<double, 2, 3> by_point;
  };
  Rows RowsOf(const PointEstimate& at, std::size_t i) const;
  /// Moves the points of a group to where pixels and survey together have it; returns the sum of
  /// squares of both.
  double Settle(const PointEstimate& at, const std::vector<std::size_t>& group);
  double Survey(const std::vector<std::size_t>& group) const {
    const double own = surveyed_[group[0]].survey_m;
    return options_.survey_share * (own >= 0.0 ? own : options_.survey_m);
  }
  void Add(const PointEstimate& at, const std::vector<std::size_t>& group, double weight,
           Equations* equations) const;
  double AddPriors(const PointEstimate& at, Equations* equations) const;

  const std::vector<PointPixel>& surveyed_;
  std::vector<PointPixel> places_;  // the points where pixels and survey together have them
  PointGroups groups_;
  PointFitOptions options_;
  PoseProblem problem_;
};

Problem::Rows Problem::RowsOf(const PointEstimate& at, std::size_t i) const {
  const PoseProblem::PointRows of_pose = problem_.Rows(at.pose, i);
  const int own = 4 * places_[i].view;
  Rows rows;
  rows.error = of_pose.error + of_pose.by_calibration * at.calibration.segment<4>(own);
  rows.by_step.setZero();
  rows.by_step.leftCols<9>() = of_pose.by_step;
  rows.by_step.middleCols<4>(9 + own) = of_pose.by_calibration;
  // A shift of the body in R moves the pixel as one of the point does, turned into B.
  rows.by_point = of_pose.by_step.middleCols<3>(3) * at.pose.X_RB.R;
  return rows;
}

double Problem::Settle(const PointEstimate& at, const std::vector<std::size_t>& group) {
  const double survey = Survey(group);
  for (const std::size_t i : group) places_[i].p_B = surveyed_[i].p_B;
  double squares = 0.0;
  if (survey > 0.0) {
    Eigen::Matrix3d A = Eigen::Matrix3d::Identity() / (survey * survey);
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const std::size_t i : group) {
      const Rows rows = RowsOf(at, i);
      A += rows.by_point.transpose() * rows.by_point;
      b += rows.by_point.transpose() * rows.error;
    }
    const Eigen::Vector3d shift = -A.llt().solve(b);
    for (const std::size_t i : group) places_[i].p_B += shift;
    squares = shift.squaredNorm() / (survey * survey);
  }
  for (const std::size_t i : group) squares += RowsOf(at, i).error.squaredNorm();
  return squares;
}

void Problem::Add(const PointEstimate& at, const std::vector<std::size_t>& group, double weight,
                  Equations* equations) const {
  Matrix17 A = Matrix17::Zero();
  Vector17 b = Vector17::Zero();
  const double survey = Survey(group);
  Eigen::Matrix<double, kSought, 3> across = Eigen::Matrix<double, kSought, 3>::Zero();
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  Eigen::Vector3d own_b = Eigen::Vector3d::Zero();
  for (const std::size_t i : group) {
    const Rows rows = RowsOf(at, i);
    A.noalias() += rows.by_step.transpose() * rows.by_step;
    b.noalias() += rows.by_step.transpose() * rows.error;
    across.noalias() += rows.by_step.transpose() * rows.by_point;
    own.noalias() += rows.by_point.transpose() * rows.by_point;
    own_b.noalias() += rows.by_point.transpose() * rows.error;
  }
  if (survey > 0.0) {  // Schur's complement of the point's three unknowns
    const double information = 1.0 / (survey * survey);
    own.diagonal().array() += information;
    own_b += information * (places_[group[0]].p_B - surveyed_[group[0]].p_B);
    const Eigen::LLT<Eigen::Matrix3d> solve(own);
    A.noalias() -= across * solve.solve(across.transpose());
    b.noalias() -= across * solve.solve(own_b);
  }
  equations->A += weight * A;
  equations->b += weight * b;
}

double Problem::AddPriors(const PointEstimate& at, Equations* equations) const {
  double squares = at.calibration.squaredNorm();
  if (equations) {
    equations->A.diagonal().tail<8>().array() += 1.0;
    equations->b.tail<8>() += at.calibration;
  }
  if (problem_.joint()) {
    const Eigen::Vector3d prior = problem_.PriorError(at.pose);
    squares += prior.squaredNorm();
    if (!equations) return squares;
    const Eigen::Matrix3d& root = problem_.prior_root();
    equations->A.block<3, 3>(6, 6) += root.transpose() * root;
    equations->b.segment<3>(6) += root.transpose() * prior;
  } else if (equations) {
    equations->A.block<3, 3>(6, 6).setIdentity();
  }
  return squares;
}

double Problem::Cost(const PointEstimate& at, Equations* equations) {
  if (equations) {
    equations->A.setZero();
    equations->b.setZero();
  }
  double cost = 0.0;
  for (const auto& group : groups_) {
    const double bend = kHuberSigmas * std::sqrt(static_cast<double>(group.size()));
    const double length = std::sqrt(Settle(at, group));
    cost += length <= bend ? length * length : bend * (2.0 * length - bend);
    if (equations) Add(at, group, length <= bend ? 1.0 : bend / length, equations);
  }
  return cost + AddPriors(at, equations);
}

double Problem::Squares(const PointEstimate& at) {
  double squares = AddPriors(at, nullptr);
  for (const auto& group : groups_) squares += Settle(at, group);
  return squares;
}

}  // namespace

PointFit FitPoints(const std::vector<PointPixel>& points, const std::vector<bool>& chosen,
                   const std::vector<CameraView>& views, const PointEstimate& start,
                   const PointFitOptions& options) {
  std::vector<PointPixel> used;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (chosen[i]) used.push_back(points[i]);
  }
  DOCKYARD_CHECK(used.size() >= 3 && !views.empty() && views.size() <= 2);
  RefineOptions refine;
  refine.sigma_px = options.sigma_px;
  refine.fit_turn = options.fit_turn;
  Problem problem(used, views, options, refine);
  PointEstimate at = start;
  for (int round = 0; round < 4; ++round) {  // discs' offsets depend on the pose, but weakly
    const double change = problem.UpdateOffsets(at);
    if (round > 0 && change < 1e-3) break;
    at = Descend<Equations>(problem, at, round == 0 ? refine.max_iterations : 6, 1e-7);
  }
  PointFit found{.at = at, .fit = {.X_RB = at.pose.X_RB, .turn = refine.turn}};
  RefinedPose& fit = found.fit;
  Equations equations;
  fit.cost = problem.Cost(at, &equations);
  equations.A.diagonal().array() += 1e-12;
  const Matrix17 covariance = equations.A.ldlt().solve(Matrix17::Identity());
  fit.covariance =
      PoseCovariance(covariance.topLeftCorner<6, 6>(), at.pose.X_RB, refine.spread.mounting_rad);
  if (problem.pose().joint()) {
    fit.turn.mean_rad = at.pose.turn_rad;
    fit.turn.covariance = covariance.block<3, 3>(6, 6);
  }
  fit.misfit = problem.Squares(at);
  fit.freedom = 2 * static_cast<int>(used.size()) - 6;
  problem.ToSurvey();
  AddErrors(problem.pose(), at.pose, views.size(), used, &fit);
  return found;
}

}  // namespace dockyard
