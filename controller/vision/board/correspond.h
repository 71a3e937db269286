// Which detection is which fiducial of the board, in one image (Tsai et al., III-A.3).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/base/result.h"
#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/vision/board/fiducials.h"
#include "controller/vision/board/hypotheses.h"
#include "controller/vision/board/locate.h"
#include "controller/vision/planar_pose.h"

namespace dockyard {

/// The correspondence in one image.
struct Correspondence {
  std::vector<MarkMatch> matches;        // by id
  std::vector<Eigen::Vector2d> centres;  // pixel of each fiducial: measured, or else filled in
                                         // through the homography
  std::vector<PlanarBranch> branches;    // the board in this camera, from this image alone
};

/// Two fiducials of each rotation leave (2!)^4 = 16 hypotheses; false marks and missing ones change
/// the number. For each, a homography is fitted on the viewing sphere (it does not hold in fish-eye
/// pixels), outliers are rejected, the board is re-projected, and the detections near it are
/// counted. The winner has the most marks, then the least error, and must be a plumb board seen
/// from its front. up_C: against gravity, unit, in the camera. With min_marks four instead of five,
/// this image alone cannot show a false mark: the other image must confirm.
Result<Correspondence, PoseFailure> Correspond(const std::vector<DetectedFiducial>& detections,
                                               const Camera& camera, const FiducialBoard& board,
                                               const Eigen::Vector3d& up_C, int min_marks = 5);

/// The detections that a known pose explains, nearest first, each once.
std::vector<MarkMatch> MatchByPose(const std::vector<DetectedFiducial>& detections,
                                   const Camera& camera, const FiducialBoard& board,
                                   const Pose3& X_CB, double gate_px);

}  // namespace dockyard
