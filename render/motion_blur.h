// Motion blur of one view: each pixel is widened along the line that its point draws in the image
// while the shutter is open. No GL.
#pragma once

#include <Eigen/Core>

#include "controller/geometry/camera.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// Motion of a frame over an exposure, in its own axes: displacement [m] and turn [rad].
struct ExposureMotion {
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();
};

/// The motion of a body with these velocities at the middle of an exposure. R_WB: its axes.
ExposureMotion MotionOverExposure(const Eigen::Matrix3d& R_WB, const Eigen::Vector3d& v_WB_W,
                                  const Eigen::Vector3d& w_WB_W, double exposure_s);

/// The motion of a camera that is fixed to a body. X_BC: the camera in the body.
ExposureMotion MotionOfCamera(const ExposureMotion& body, const Pose3& X_BC);

/// Displacement [px] in the image, over the exposure, of a thing at rest: for the pixel
/// whose ray meets it at a depth of 1/inverse_depth along the camera's z. Zero where no ray is.
Eigen::Vector2d ImageShift_px(const Camera& camera, const ExposureMotion& camera_motion,
                              const Eigen::Vector2d& pixel, double inverse_depth);

/// Widens the image as a box of ImageShift_px would, by its second moment d^2/12:
///   I + (du^2 I_uu + 2 du dv I_uv + dv^2 I_vv) / 24,
/// with derivatives of fourth order. For shifts below a pixel; longer ones count as 2.5 px.
/// The image has depths.
void BlurByMotion(const Camera& camera, const ExposureMotion& camera_motion, RadianceImage& image);

/// Rows first ... end - 1.
struct RowRange {
  int first = 0, end = 0;
};

/// These rows of an image of a moving camera whose rows are exposed one after another. Row y of h
/// is exposed at the share (y + 1/2) / h - 1/2 of the readout, the image as it is at the share
/// `middle`; so each pixel moves on by ImageShift_px times the difference. Values between pixels
/// are those of the polynomial of fourth degree through five pixels, along rows and columns. The
/// motion is that over the readout. The image has depths, which stay where they are.
void MoveRows(const Camera& camera, const ExposureMotion& camera_motion, const RowRange& rows,
              double middle, RadianceImage& image);

}  // namespace dockyard
