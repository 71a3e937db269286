// Internal to the vision room. Which detection could be which mark, by their places and sizes
// alone: for discs without bars, and for boards with many marks of one rotation.
#pragma once

#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/vision/board/hypotheses.h"

namespace dockyard {

/// A disc's ellipse is the local map from board to image, but for a turn. With this map a disc and
/// two neighbours are compared with every mark and its neighbours. Triples that agree give poses
/// (three points of known place). Each upright pose that faces the camera is tried on all
/// detections: it names those near its marks, and a homography through them names the rest. False
/// detections and missing marks make a naming smaller. In a crowded image not every triple is tried
/// (kMostTriples).
/// @param up_C  against gravity, unit, in the camera
/// @returns namings of MarksNeeded(board) marks or more, each once, the largest first
std::vector<std::vector<MarkMatch>> NamingsByLayout(const std::vector<DetectedFiducial>& detections,
                                                    const Camera& camera,
                                                    const FiducialBoard& board,
                                                    const Eigen::Vector3d& up_C);

}  // namespace dockyard
