// Internal to the vision room. Least squares of a body's pose on pixels of its points, when the
// points themselves are surveyed with an error that all pixels of a point share.
#pragma once

#include <vector>

#include "controller/vision/points/point_errors.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

struct PointFitOptions {
  double sigma_px = 0.15;     // of a pixel, one axis, where the point names none
  double survey_m = 0.0;      // of a point of the body, one axis, where the point names none
  double survey_share = 1.0;  // factor on every point's survey error
  bool fit_turn = true;       // of the cameras against each other; with two views only
};

struct PointFit {
  PointEstimate at;
  RefinedPose fit;  // `mark_sigmas` stays empty
};

/// Levenberg-Marquardt from the start on the chosen points, with Huber's loss on each point. Each
/// point's own place is three more unknowns about the survey's, eliminated from the equations
/// (Triggs et al., "Bundle adjustment - a modern synthesis", 2000, section 6.1); so the
/// two pixels of a point share its error. Calibration terms are unknowns under their spread.
/// @param chosen  by point; at least three of them
PointFit FitPoints(const std::vector<PointPixel>& points, const std::vector<bool>& chosen,
                   const std::vector<CameraView>& views, const PointEstimate& start,
                   const PointFitOptions& options);

}  // namespace dockyard
