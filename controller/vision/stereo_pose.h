// Point stereo and rigid fit (Tsai et al., III-B), then the joint fit in both images.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

/// The point nearest to both rays; none when they are parallel or meet behind a camera.
std::optional<Eigen::Vector3d> Triangulate(const StereoRig& rig, const Eigen::Vector2d& left_px,
                                           const Eigen::Vector2d& right_px);

/// Rotation and translation with b ~ X_AB a least squares (Umeyama, IEEE TPAMI 13(4), 1991, without
/// scale). At least three points, not on a line.
std::optional<Pose3> FitRigid(const std::vector<Eigen::Vector3d>& points_B,
                              const std::vector<Eigen::Vector3d>& points_A);

/// The paper's stereo pose: centres_*[id] is the pixel of fiducial id, measured or filled in.
std::optional<Pose3> StereoPose(const StereoRig& rig, const FiducialBoard& board,
                                const std::vector<Eigen::Vector2d>& centres_left,
                                const std::vector<Eigen::Vector2d>& centres_right);

/// Views 0 and 1 for RefinePose.
std::vector<CameraView> Views(const StereoRig& rig);

}  // namespace dockyard
