// Pose of any body from pixels of its points, outliers among them: the pipelines' estimators
// without their detection.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/base/result.h"
#include "controller/io/vision_settings.h"
#include "controller/vision/locate.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

struct PointOptions {
  double survey_m = 0.0;   // 1 sigma of a point's place on the body, one axis [m]
  double sigma_px = 0.15;  // of a pixel, one axis, at least; assumed, 0.1-0.3
};

struct PointPose {
  RefinedPose fit;                // `misfit` with pixels and survey as stated in PointOptions
  std::vector<bool> inlier;       // by point
  std::string method;             // "stereo", "left", "right"
  std::optional<Pose3> other_RB;  // a plane seen by one camera: the other pose that fits nearly
  double other_cost = 0.0;        // RefinedPose::cost of it
  double sigma_px = 0.0;          // noise of the pixels as the residuals show it
  double survey_share = 1.0;      // of the survey's error as stated: the same
};

/// dockyard: the pose from three points that the others fit best (FindConsensus), then rounds of
/// the joint fit (FitPoints) with what lies within 4 sigmas of it, their scale taken from the
/// median over all pixels, never from the kept ones alone: the pixels' noise or the survey's error,
/// whichever explains the errors better, is raised above what is stated. For the covariance the
/// noise is taken from all that agree, and the survey's error may come out below what is stated.
/// JudgePoints then accepts or refuses: at least four different points
/// and half of all must agree, in each image that shows four or more, and more than accident
/// explains; when each camera's points agree by themselves but not together it is kEyesDisagree.
/// tsai2013: with both cameras, points that both see are triangulated and a rigid fit
/// made; with one, the planar pose under the linear model; no point is left out, the survey's error
/// is not used, and a body that is no plane gives kNoCorrespondence.
/// @param views  left and right; points name them by index, one may have none
Result<PointPose, PoseFailure> PoseFromPoints(const std::vector<PointPixel>& points,
                                              const StereoRig& rig, const VisionSettings& settings,
                                              const PointOptions& options = {});

}  // namespace dockyard
