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

struct PointPose {
  RefinedPose fit;
  std::vector<bool> inlier;       // by point
  std::string method;             // "stereo", "left", "right"
  std::optional<Pose3> other_RB;  // a plane seen by one camera: the other pose that fits nearly
  double other_cost = 0.0;        // RefinedPose::cost of it
};

/// dockyard: consensus over poses from three points (all triples of a picture, at most 400 of
/// them), then the joint fit with Huber's loss, rounds of it with what lies within four robust
/// sigmas, their noise taken from the residuals (at least what our own detections have), so that
/// the covariance holds for anybody's points. At least four points must agree. tsai2013: with both
/// cameras, points that both see are triangulated and a rigid fit made; with one, the planar pose
/// under the linear model; no point is left out, and a body that is no plane gives
/// kNoCorrespondence.
/// @param views  left and right; points name them by index, one may have none
Result<PointPose, PoseFailure> PoseFromPoints(const std::vector<PointPixel>& points,
                                              const StereoRig& rig, const VisionSettings& settings);

}  // namespace dockyard
