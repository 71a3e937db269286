// Internal to the vision room. Which detection could be which mark, by their places and sizes
// alone: for discs without bars, and for boards with many marks of one rotation.
#pragma once

#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/vision/hypotheses.h"

namespace dockyard {

/// A disc's ellipse is the local map from board to picture, but for a turn; with it a disc and two
/// neighbours are compared with every mark and its neighbours. Those alike give poses (three points
/// of known place), of which the upright ones that face the camera are tried on all detections:
/// what lies near is named, and a homography through it names the rest. False detections and
/// missing marks leave a naming smaller. Not every triple is tried in a crowded picture
/// (kMostTriples).
/// @param up_C  against gravity, unit, in the camera
/// @returns namings of MarksNeeded(board) marks or more, each once, the largest first
std::vector<std::vector<MarkMatch>> NamingsByLayout(const std::vector<DetectedFiducial>& detections,
                                                    const Camera& camera,
                                                    const FiducialBoard& board,
                                                    const Eigen::Vector3d& up_C);

}  // namespace dockyard
