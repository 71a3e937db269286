// Least squares of a pose on measured points, in one camera or in two at once.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"

namespace dockyard {

/// A camera and its place in the frame R in which the pose is sought.
struct CameraView {
  Camera camera;
  Pose3 X_RC;
};

/// A measured fiducial: the centre of the ellipse through its rim.
struct MarkPixel {
  int id = -1;   // index into FiducialBoard::fiducials
  int view = 0;  // index into the views
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma_px = 0.0;  // predicted error, one axis; zero: RefineOptions::sigma_px
};

/// A measured point of any body B.
struct PointPixel {
  Eigen::Vector3d p_B = Eigen::Vector3d::Zero();  // [m]
  int view = 0;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double disc_diameter_m = 0.0;  // > 0: the pixel is the middle of a disc perpendicular to B's z
  double sigma_px = 0.0;         // one axis; zero: RefineOptions::sigma_px
  // Error of p_B, one axis; negative: PointOptions::survey_m. Used by PoseFromPoints alone.
  double survey_m = -1.0;
};

/// Belief about how far the right camera is turned against the left from the calibration, about the
/// camera's x (pitch), y (yaw), z (roll) [rad]; half of it is given to each camera.
struct CameraTurn {
  Eigen::Vector3d mean_rad = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Vector3d(1.2e-5, 1.2e-5, 6.3e-6).asDiagonal();
};

/// Other errors of a calibration, 1 sigma. They are not estimated; the covariance allows for them.
struct CalibrationSpread {
  double focal = 0.002;                      // relative; assumed, 0.0005-0.005
  double centre_px = 1.0;                    // assumed, 0.3-3
  double radial_px = 0.3;                    // half the width out; assumed, 0.1-1
  double mounting_rad = 0.05 * kPi / 180.0;  // of the pair in the rover; assumed, 0.02-0.1 deg
};

struct RefineOptions {
  double sigma_px = 0.15;  // a point of unknown error, one axis; assumed, 0.1-0.3
  // Errors of lens and board beyond CalibrationSpread, added to a mark's predicted error: 0.2 mm of
  // print at 2.5 m. Assumed, 0.03-0.1.
  double model_px = 0.05;
  // Of the board's marks off its plane, 1 sigma. It shifts a mark viewed obliquely.
  double off_plane_m = 0.0;
  double noise_scale = 1.0;  // factor on the predicted errors of marks
  double huber_sigmas = 4.0;
  // The default variances are 0.2, 0.2 and 0.14 deg squared: the range error of Tsai et al., V-E
  // (20 cm at 5 m) is what 0.16 deg of relative yaw gives; a pixel of image centre in each camera
  // acts like another 0.12 deg. The board's known size makes it observable. With two views only.
  CameraTurn turn{};
  bool fit_turn = true;
  CalibrationSpread spread{};
  int max_iterations = 30;
  bool with_covariance = true;  // and turn, misfit, mark_sigmas; without: the pose and its cost
};

using Matrix6d = Eigen::Matrix<double, 6, 6>;

struct RefinedPose {
  Pose3 X_RB;
  CameraTurn turn{};  // the belief after this sighting
  /// Of p_RB [m], then of a small turn of B about R's axes [rad]: x, y, z each. Calibration spread
  /// and robust weights included.
  Matrix6d covariance = Matrix6d::Zero();
  double rms_px = 0.0;                  // over all marks, of the distance in the image
  std::vector<double> view_rms_px{};    // by view; zero without marks
  std::vector<double> mark_error_px{};  // by mark
  // Errors left over their predicted sigmas, calibration spread allowed for: by mark, and the sum
  // of all squares, chi-square with `freedom` degrees when the predictions hold.
  std::vector<double> mark_sigmas{};
  double misfit = 0.0;
  int freedom = 0;
  double cost = 0.0;  // robust sum of squares over sigma squared, prior included
};

/// Where the centre of the fitted ellipse of a disc would be: the centroid of its projection, which
/// differs from its projected centre by f (R/Z)^2 sin t cos t for a disc tilted by t. The disc lies
/// perpendicular to B's z. None when part of it cannot be seen.
std::optional<Eigen::Vector2d> ProjectDisc(const Camera& camera, const Pose3& X_CB,
                                           const Eigen::Vector3d& p_B, double diameter_m);
std::optional<Eigen::Vector2d> ProjectDisc(const Camera& camera, const Pose3& X_CB,
                                           const Fiducial& fiducial, double diameter_m);

/// Levenberg-Marquardt from the start with Huber's loss on each point. At least three points.
RefinedPose RefinePoints(const std::vector<PointPixel>& points,
                         const std::vector<CameraView>& views, const Pose3& X_RB_start,
                         const RefineOptions& options = {});
/// The error of a mark with a predicted one of its own, all of RefineOptions included, one axis.
double MarkSigmaPx(const MarkPixel& mark, const CameraView& view, const FiducialBoard& board,
                   const Pose3& X_RB, const RefineOptions& options);
/// The same on the board's fiducials.
RefinedPose RefinePose(const std::vector<MarkPixel>& marks, const std::vector<CameraView>& views,
                       const FiducialBoard& board, const Pose3& X_RB_start,
                       const RefineOptions& options = {});

}  // namespace dockyard
