// The camera model that the renderer draws with and the controller measures with. One
// implementation, two sets of numbers: the world's cameras and the controller's calibration differ.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "controller/geometry/pose.h"

namespace dockyard {

/// Fish-eye camera after Kannala and Brandt (IEEE TPAMI 28(8), 2006), as in OpenCV's fisheye
/// module:
///   theta = angle off the axis,  rho = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4
///   theta^8) u = fx rho cos(phi) + cx,    v = fy rho sin(phi) + cy
/// All k zero is the equidistant lens. Camera frame: z along the view, x right, y down.
/// Pixel (0, 0) is the centre of the first pixel.
struct FisheyeCamera {
  int width = 0, height = 0;  // [px]
  double fx = 0.0, fy = 0.0;  // [px/rad], > 0
  double cx = 0.0, cy = 0.0;  // [px]
  std::array<double, 4> k{};  // k1..k4 [-]

  /// Pixel of a point; none at the camera's centre, straight behind it, or beyond 120 deg off axis.
  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C) const;
  /// Unit ray through a pixel. Newton's method to 1e-14 rad; rays end at 120 deg off axis.
  Eigen::Vector3d Ray(const Eigen::Vector2d& pixel) const;
  /// Whether the pixel lies on the image, at least margin_px inside its border.
  bool Sees(const Eigen::Vector2d& pixel, double margin_px = 0.0) const;
};

/// The equidistant lens that spreads fov_rad over the image's width; centre in the middle.
FisheyeCamera EquidistantCamera(int width, int height, double horizontal_fov_rad);

/// A stereo pair on the rover body.
struct StereoRig {
  FisheyeCamera left, right;
  Pose3 X_RL, X_RQ;  // left and right camera in the rover body [m]

  double baseline_m() const { return (X_RQ.p - X_RL.p).norm(); }
};

}  // namespace dockyard
