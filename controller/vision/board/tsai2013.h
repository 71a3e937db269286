// Internal to the vision room. The stages in which the paper's perception differs from ours
// (Tsai et al., III); its parameters are fixed, as they were held in the field (V-D).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/base/result.h"
#include "controller/vision/board/fiducials.h"
#include "controller/vision/board/hypotheses.h"
#include "controller/vision/board/locate.h"

namespace dockyard {

/// Adaptive threshold, connected regions, filters, local threshold, ellipse through the perimeter;
/// the rotation from the major axis of the white inside, against the image's own up: of gravity the
/// paper knows only that the board cannot be upside down. From the bottom of the image upwards.
std::vector<DetectedFiducial> DetectTsai2013(const GrayImage& image,
                                             const Tsai2013Vision& settings);

/// The correspondence in one image.
struct TsaiCorrespondence {
  std::vector<MarkMatch> matches;        // by id
  std::vector<Eigen::Vector2d> centres;  // of all fiducials, the missing ones by the homography
  std::vector<double> residual_px{};     // of the matches, by the last homography
};

/// Each naming of the first min_points detections gives a homography between the board and the raw
/// pixels; fiducials within the closeness of their re-projection verify it and give the last one.
/// With five points one may be left out. The least error wins (Tsai et al., III-A.3).
/// @param detections  in the order of DetectTsai2013
Result<TsaiCorrespondence, PoseFailure> CorrespondTsai2013(
    const std::vector<DetectedFiducial>& detections, const FiducialBoard& board,
    const VisionSettings& settings);

}  // namespace dockyard
