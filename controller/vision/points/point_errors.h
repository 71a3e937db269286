// Internal to the vision room. Errors of a body's points at an estimate, and how far they lie in
// sigmas of the pixels and of the survey.
#pragma once

#include <vector>

#include "controller/vision/pose_problem.h"

namespace dockyard {

/// Pixels of the same point of the body, by index.
using PointGroups = std::vector<std::vector<std::size_t>>;
PointGroups GroupsOf(const std::vector<PointPixel>& points);

/// The unknowns of FitPoints: pose, turn of the cameras and, for each camera, by how many sigmas of
/// CalibrationSpread its focal length, its centre along u and v and its radial term are off.
struct PointEstimate {
  PoseEstimate pose;
  Eigen::Matrix<double, 8, 1> calibration = Eigen::Matrix<double, 8, 1>::Zero();
};

/// A pixel's error at an estimate, and its derivative by the place of its point.
struct PixelError {
  Eigen::Vector2d error_px = Eigen::Vector2d::Zero();
  Eigen::Matrix<double, 2, 3> by_point = Eigen::Matrix<double, 2, 3>::Zero();  // [px/m]
};
std::vector<PixelError> ErrorsOf(const std::vector<PointPixel>& points,
                                 const std::vector<CameraView>& views, const PointEstimate& at,
                                 bool fit_turn);

/// Squared Mahalanobis length of the errors of some pixels of one point: chi-square with two
/// degrees of freedom for each, when pixels err by sigma_px and the point by survey_m.
double SquaredSigmas(const std::vector<PixelError>& errors, const std::vector<std::size_t>& pixels,
                     double sigma_px, double survey_m);

}  // namespace dockyard
