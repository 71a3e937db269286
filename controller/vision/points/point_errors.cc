#include "controller/vision/points/point_errors.h"

#include <Eigen/Cholesky>

namespace dockyard {

PointGroups GroupsOf(const std::vector<PointPixel>& points) {
  PointGroups groups;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool known = false;
    for (auto& group : groups) {
      if (points[group[0]].p_B != points[i].p_B) continue;
      group.push_back(i);
      known = true;
      break;
    }
    if (!known) groups.push_back({i});
  }
  return groups;
}

std::vector<PixelError> ErrorsOf(const std::vector<PointPixel>& points,
                                 const std::vector<CameraView>& views, const PointEstimate& at,
                                 bool fit_turn) {
  RefineOptions refine;
  refine.sigma_px = 1.0;
  refine.fit_turn = fit_turn;
  std::vector<PointPixel> unweighted = points;
  for (PointPixel& point : unweighted) point.sigma_px = 0.0;
  PoseProblem problem(unweighted, views, refine);
  problem.UpdateOffsets(at.pose);
  std::vector<PixelError> errors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PoseProblem::PointRows rows = problem.Rows(at.pose, i);
    const Eigen::Vector4d calibration = at.calibration.segment<4>(4 * points[i].view);
    errors.push_back({.error_px = rows.error + rows.by_calibration * calibration,
                      .by_point = rows.by_step.middleCols<3>(3) * at.pose.X_RB.R});
  }
  return errors;
}

double SquaredSigmas(const std::vector<PixelError>& errors, const std::vector<std::size_t>& pixels,
                     double sigma_px, double survey_m) {
  const double information = 1.0 / (sigma_px * sigma_px);
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (const std::size_t i : pixels) {
    const PixelError& error = errors[i];
    squares += information * error.error_px.squaredNorm();
    A += information * error.by_point.transpose() * error.by_point;
    b += information * error.by_point.transpose() * error.error_px;
  }
  if (!(survey_m > 0.0)) return squares;
  A.diagonal().array() += 1.0 / (survey_m * survey_m);
  return squares - b.dot(A.llt().solve(b));
}

}  // namespace dockyard
