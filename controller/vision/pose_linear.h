// Internal to the vision room. Shared by the fits of pose_refine.h and point_fit.h: covariance and
// errors of an estimate.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/vision/pose_problem.h"

namespace dockyard {

constexpr int kMostNuisance = 8;  // calibration terms of two cameras
constexpr int kMost = 9 + kMostNuisance;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;
using StateColumn = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;

/// The upper 6x6 of a step's covariance as RefinedPose gives it, the pair's mounting added.
Matrix6d PoseCovariance(const Square& step, const Pose3& X_RB, double mounting_rad);

/// Sets rms_px, view_rms_px and mark_error_px.
void AddErrors(const PoseProblem& problem, const PoseEstimate& at, std::size_t views,
               const std::vector<PointPixel>& points, RefinedPose* refined);

}  // namespace dockyard
