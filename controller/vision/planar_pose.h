// Pose of the board from one camera alone. It is fitted on rays, so distortion does no harm.
#pragma once

#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

/// One local minimum of the reprojection error.
struct PlanarBranch {
  Pose3 X_CB;
  double rms_px = 0.0;
  double cost = 0.0;  // RefinedPose::cost
};

/// A plane seen by one camera has up to two poses that explain it nearly alike, mirrored about the
/// line of sight (Schweighofer and Pinz, IEEE TPAMI 28(12), 2006). Both are returned, the better
/// one first; one when they coincide, none when fewer than four marks or no homography.
std::vector<PlanarBranch> PlanarPose(const std::vector<MarkPixel>& marks, const Camera& camera,
                                     const FiducialBoard& board);

}  // namespace dockyard
