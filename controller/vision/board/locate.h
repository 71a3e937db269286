// Images in, pose of the board out: detect, correspond, estimate (Tsai et al., section III).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/base/result.h"
#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "controller/io/belief.h"
#include "controller/io/vision_settings.h"
#include "controller/vision/pose_refine.h"

namespace dockyard {

enum class PoseFailure {
  kTooFewFiducials,   // in neither image
  kNoCorrespondence,  // no hypothesis explains enough of the detections
  kBehindCamera,      // the fit puts the board where it cannot be seen
  kPoorFit,           // one image: residuals larger than their prediction
  kCamerasDisagree,   // both images: the same, or a camera turn beyond the first belief
  kUncertain,         // the pose's own covariance is too large to be of use
  kNotUpright,        // the board's roll contradicts gravity, or what its file allows
  kAmbiguous,         // two poses or two namings that fit alike, and nothing decides
};
const char* Name(PoseFailure failure);

/// The rover's knowledge besides the images.
struct LocateHints {
  Eigen::Vector3d up_R{0, 0, 1};       // against gravity, unit, from the IMU, in the rover body
  std::optional<Pose3> X_RB_expected;  // from odometry since the last accepted sighting
  CameraTurn camera_turn{};            // of the right camera, from the sightings so far
};

struct DockSighting {
  Pose3 X_RB;                              // board in the rover body
  double reprojection_px = 0.0;            // RMS over the measured fiducials of both images
  int fiducials_used = 0;                  // measured, both images together
  bool stereo = false;                     // whether both images gave the pose
  Matrix6d covariance = Matrix6d::Zero();  // as RefinedPose's; zero from tsai2013, which has none
  CameraTurn camera_turn{};                // the belief after this sighting
};

/// The result for the controller and the full account for the log.
struct LocateOutput {
  Result<DockSighting, PoseFailure> sighting;
  SightingReport report;
};

/// Errors of the marks beyond their own prediction and RefineOptions::model_px. The default is the
/// controllers': they know board and cameras, so a misfit means a wrong sighting. Users' printed
/// boards and calibrations err more. Used by the pipeline dockyard alone.
struct ErrorAllowance {
  bool raise_noise = false;     // to what the residuals show (noise_raise.h), before it is judged
  double flatness_m = 0.0;      // largest departure of the board from a plane
  double calibration_px = 0.0;  // 1 sigma of the calibration, one axis
};

/// tsai2013 takes only a board with two bars of each rotation; dockyard takes any (MarksNeeded).
LocateOutput LocateBoard(const StereoImages& images, const StereoRig& rig,
                         const FiducialBoard& board, const LocateHints& hints,
                         const VisionSettings& settings = {}, const ErrorAllowance& errors = {});

/// The pipelines behind it.
LocateOutput LocateDockyard(const StereoImages& images, const StereoRig& rig,
                            const FiducialBoard& board, const LocateHints& hints,
                            const ErrorAllowance& errors = {});
LocateOutput LocateTsai2013(const StereoImages& images, const StereoRig& rig,
                            const FiducialBoard& board, const LocateHints& hints,
                            const VisionSettings& settings);

}  // namespace dockyard
