// Pose of a board of tags from the tags found in one image. Corners are fitted on rays, so any lens
// will do.
#pragma once

#include <vector>

#include "controller/geometry/board.h"
#include "controller/vision/pose_refine.h"
#include "controller/vision/tags/find_tags.h"

namespace dockyard {

/// One pose that explains the corners, a minimum of their errors.
struct TagBranch {
  Pose3 X_RB;
  double rms_px = 0.0;  // over all corners, of the distance in the image
  double cost = 0.0;    // robust sum of squares over sigma squared
  int freedom = 0;      // what the cost is on average, when the sigmas hold
  // Of p_RB [m], then of a small turn about R's axes [rad], as SightingReport::covariance.
  Matrix6d covariance = Matrix6d::Zero();
};

struct TagSighting {
  // The better one first. Two for the ambiguity of a plane (planar_pose.h); none without a tag of
  // the board. Two of nearly equal cost leave the board's turn open.
  std::vector<TagBranch> branches{};
  std::vector<int> used{};  // indices into FiducialBoard::tags
};

/// @param found    tags of the board's families in one image. Others are left out, and so is a tag
///                 that was found twice
/// @param view     the camera and its place in the robot's body R
/// @param options  its spread is of the camera's calibration, its model_px of the print
TagSighting TagBoardPose(const std::vector<FoundTag>& found, const std::string& family,
                         const CameraView& view, const FiducialBoard& board,
                         const RefineOptions& options = {});

/// Finds the tags of all the board's families, and from them the pose.
TagSighting LocateTagBoard(const GrayImage& image, const CameraView& view,
                           const FiducialBoard& board, const RefineOptions& options = {});

}  // namespace dockyard
