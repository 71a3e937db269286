// Pose of any body from pixels of its points, outliers among them: the pipelines' estimators
// without their detection.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/base/result.h"
#include "controller/io/vision_settings.h"
#include "controller/vision/board/locate.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

struct PointOptions {
  double survey_m = 0.0;   // 1 sigma of a point's place on the body, one axis [m]
  double sigma_px = 0.15;  // of a pixel, one axis, at least; assumed, 0.1-0.3
};

struct PointPose {
  // `misfit` with the pixels' noise as stated in PointOptions, and the survey's error as stated or
  // as the residuals lower it (survey_share below 1).
  RefinedPose fit;
  std::vector<bool> inlier;       // by point
  std::string method;             // "stereo", "left", "right"
  std::optional<Pose3> other_RB;  // a plane seen by one camera: the other pose that fits nearly
  double other_cost = 0.0;        // RefinedPose::cost of it
  double sigma_px = 0.0;          // noise of the pixels, from the residuals
  double survey_share = 1.0;      // factor on the stated survey error, likewise
};

/// dockyard: it starts from the pose of three points that the others fit best (FindConsensus).
/// Rounds of the joint fit (FitPoints) follow, on the points within 4 sigmas. The scale of the
/// sigmas comes from the median over all pixels, never from the kept ones alone: the pixels' noise
/// or the survey's error, whichever explains the errors better, is raised above the stated value.
/// For the covariance the noise is taken from all points that agree, and the survey's error may
/// come out below the stated value. JudgePoints then accepts or refuses: at least four different
/// points and half of all must agree, in each image that shows four or more, and more than chance
/// explains. When each camera's points agree by themselves but not together, the result is
/// kCamerasDisagree.
///
/// tsai2013: with both cameras, it triangulates the points that both see and makes a rigid fit;
/// with one, it takes the planar pose under the linear model. No point is left out, the survey's
/// error is not used, and a body that is no plane gives kNoCorrespondence.
/// @param rig  left camera: view 0 of the points, right camera: view 1; one may have no points
Result<PointPose, PoseFailure> PoseFromPoints(const std::vector<PointPixel>& points,
                                              const StereoRig& rig, const VisionSettings& settings,
                                              const PointOptions& options = {});

}  // namespace dockyard
