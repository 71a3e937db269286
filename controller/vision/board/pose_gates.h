// Decides whether a fitted pose is accepted, and which of two mono poses.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/vision/board/locate.h"
#include "controller/vision/planar_pose.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

/// The board hangs nearly plumb: its x axis is level to 15 deg, its plane upright to 30 deg. The
/// station leans 5 deg (Tsai et al., V-F); slopes, rover attitude and a noisy far pose are assumed
/// to add no more than the rest.
bool IsUpright(const Eigen::Matrix3d& R_RB, const Eigen::Vector3d& up_R);
/// The same by the board's own rule. The roll is the angle between the board's up and gravity's or
/// the image's, seen along the line of sight. Gravity within 15 deg of that line gives no roll, and
/// such a pose is refused.
/// @param X_RC  the camera that sees the board; for kImage its image gives the up side
bool IsUpright(const Pose3& X_RB, const Upright& rule, const Pose3& X_RC,
               const Eigen::Vector3d& up_R);

/// The camera sees the printed side: the board's z points away from it, and it lies ahead.
bool ShowsItsFace(const Pose3& X_CB);

/// Largest RMS error of a naming that is examined further [px]: 2 px (assumed, 1.5-3), more when
/// the discs are large. Judge is stricter.
double RmsGatePx(const Camera& camera, const Pose3& X_CB, double disc_diameter_m);

/// The value that chi-square with this many degrees of freedom exceeds in one case of a thousand
/// (Wilson and Hilferty, Proc. Natl. Acad. Sci. 17, 1931; to 1.5 % from four degrees on).
double ChiSquareLimit(int freedom);

/// All checks on a fit with its covariance: before the cameras; misfit below ChiSquareLimit;
/// cameras turned by no more than four sigma; 1 sigma of place and turn at most a third of what
/// counts as wrong (0.3 m, 10 deg); upright. Empty when the pose is accepted.
std::optional<PoseFailure> Judge(const RefinedPose& fit, const std::vector<CameraView>& views,
                                 const LocateHints& hints, const Upright& rule = {});

/// Whether the other branch fits nearly as well and nothing known speaks against it: then a pose
/// from one camera is a guess between two.
/// @param noise  variance of the marks over their predicted one
bool IsAmbiguous(const std::vector<PlanarBranch>& branches, std::size_t chosen, const Pose3& X_RC,
                 const LocateHints& hints, const Upright& rule = {}, double noise = 1.0);

/// Index of the branch to accept: upright first, then the sum of the reprojection cost and the
/// squared deviation from the expected heading; none when no branch is upright and face-on.
std::optional<std::size_t> ChooseBranch(const std::vector<PlanarBranch>& branches,
                                        const Pose3& X_RC, const LocateHints& hints,
                                        const Upright& rule = {});

}  // namespace dockyard
