// Least squares of the board's pose on measured fiducials, in one camera or in two at once.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"

namespace dockyard {

/// A camera and its place in the frame R in which the board is sought.
struct CameraView {
  Camera camera;
  Pose3 X_RC;
};

/// A measured fiducial: the centre of the ellipse through its rim.
struct MarkPixel {
  int id = -1;   // index into FiducialBoard::fiducials
  int view = 0;  // index into the views
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

struct RefineOptions {
  // One mark, one axis. Assumed 0.3 (0.1-0.6): the fit's noise plus what 0.2 % of focal length
  // leaves over the board.
  double sigma_px = 0.3;
  double huber_sigmas = 3.0;
  // How far the right camera may be turned against the left from the calibration, 1 sigma about the
  // camera's x (pitch), y (yaw), z (roll) [rad]. The range error of Tsai et al., V-E (20 cm at 5 m)
  // is what 0.16 deg of relative yaw gives; one pixel of image centre acts like another 0.1 deg.
  // The board's known size makes it observable. Used with two views only.
  Eigen::Vector3d relative_turn_sigma_rad{0.0035, 0.0035, 0.0025};
  bool fit_relative_turn = true;
  int max_iterations = 30;
};

struct RefinedPose {
  Pose3 X_RB;
  Eigen::Vector3d relative_turn_rad = Eigen::Vector3d::Zero();  // right against left, beyond X_RC
  double rms_px = 0.0;                  // over all marks, of the distance in the picture
  std::vector<double> view_rms_px{};    // by view; zero without marks
  std::vector<double> mark_error_px{};  // by mark
  double cost = 0.0;                    // robust sum of squares over sigma squared, prior included
};

/// Where the centre of the fitted ellipse of a fiducial would be: the centroid of its projected
/// disc, which differs from its projected centre by f (R/Z)^2 sin t cos t for a disc tilted by t.
/// None when part of it cannot be seen.
std::optional<Eigen::Vector2d> ProjectDisc(const Camera& camera, const Pose3& X_CB,
                                           const Fiducial& fiducial, double diameter_m);

/// Levenberg-Marquardt from the start. At least three marks.
RefinedPose RefinePose(const std::vector<MarkPixel>& marks, const std::vector<CameraView>& views,
                       const FiducialBoard& board, const Pose3& X_RB_start,
                       const RefineOptions& options = {});

}  // namespace dockyard
