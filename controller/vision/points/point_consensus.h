// Internal to the vision room. A first pose from pixels of a body's points, wrong ones among them.
#pragma once

#include <optional>
#include <vector>

#include "controller/vision/pose_refine.h"

namespace dockyard {

struct PointConsensus {
  Pose3 X_RB;
  std::vector<bool> inlier;  // by pixel
};

/// The pose from three points of one image (all triples, at most 400 of them) that the others fit
/// best: the sum of squared errors over squared gates, each at most one (Torr and Zisserman's
/// MSAC, Computer Vision and Image Understanding 78(1), 2000). None when no triple gives a pose.
/// @param survey_m  error of the body's points where the point names none; it widens the gates
std::optional<PointConsensus> FindConsensus(const std::vector<PointPixel>& points,
                                            const std::vector<CameraView>& views, double survey_m);

}  // namespace dockyard
