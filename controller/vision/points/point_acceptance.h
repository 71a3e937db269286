// Internal to the vision room. Decides whether a pose from given points is accepted.
#pragma once

#include <optional>
#include <vector>

#include "controller/vision/board/locate.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

/// How many different points of the body the chosen pixels show; with `view` >= 0 in that image.
std::size_t DistinctPoints(const std::vector<PointPixel>& points, const std::vector<bool>& chosen,
                           int view = -1);

/// The expected number of poses with as many agreeing points as this one, if every point's name
/// were drawn at random (the number of false alarms of Moisan and Stival, IJCV 57(3), 2004). Each
/// triple gives up to four poses. Each further point falls within the largest error with a
/// probability equal to the area of this circle over the area of the box about the points. The
/// least of the images.
/// @param error_px  by pixel, the survey's error not taken out
double ExpectedAccidents(const std::vector<PointPixel>& points, const std::vector<bool>& inlier,
                         const std::vector<double>& error_px);

/// None: accepted. kTooFewFiducials: fewer than four points agree. kNoCorrespondence: fewer than
/// half agree, or chance explains it. kCamerasDisagree: one image has half of its points in
/// agreement, the other with four or more has not. kUncertain: the covariance is not positive, or 1
/// sigma exceeds 30 deg or half the distance.
std::optional<PoseFailure> JudgePoints(const std::vector<PointPixel>& points,
                                       const std::vector<bool>& inlier,
                                       const std::vector<double>& error_px,
                                       const std::vector<CameraView>& views,
                                       const RefinedPose& fit);

}  // namespace dockyard
