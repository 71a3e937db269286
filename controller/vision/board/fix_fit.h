// Internal to the vision room. Fits of a fix's marks, and the marks that contradict the others.
#pragma once

#include <vector>

#include "controller/vision/board/sighting_report.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

constexpr int kMinTogether = 6;      // marks of both images that give a pose when neither has five
constexpr int kMinSecondCamera = 2;  // marks in the other image that allow a joint fit
/// A mark contradicts the others when its error exceeds this multiple of its sigma (4e-5 of the
/// good ones do).
constexpr double kStraySigmas = 4.5;

/// What a fit needs in addition to the marks.
struct FitInputs {
  const std::vector<CameraView>& views;  // both
  const FiducialBoard& board;
  RefineOptions refine{};
};

long CountIn(const std::vector<MarkPixel>& marks, int view);

/// The fit of these marks, from the fix's pose and in its images.
Fix Refit(const FitInputs& inputs, const Fix& fix, const std::vector<MarkPixel>& marks,
          bool with_covariance = false);

/// The fit with its covariance, and without marks that contradict the rest: a disc half hidden, a
/// shadow's edge along a rim. Six marks, and two thirds, must stay; from less the fit is judged as
/// it is.
Fix WithoutStrays(const FitInputs& inputs, const Fix& fix);

}  // namespace dockyard
