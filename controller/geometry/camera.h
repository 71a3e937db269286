// The camera model of renderer and controller. One implementation, two sets of numbers: the world's
// cameras and the controller's calibration differ.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/geometry/lens.h"
#include "controller/geometry/pose.h"

namespace dockyard {

/// A lens before an image of width x height pixels. Camera frame: z along the view, x right, y
/// down. Pixel (0, 0) is the centre of the first pixel.
struct Camera {
  int width = 0, height = 0;  // [px]
  Lens lens;                  // its vectors, if it has any, in the camera frame

  /// Pixel of a point; none at the camera's centre, behind it, beyond 120 deg off axis, or where
  /// the lens's polynomial folds back. The pixel may lie off the image: see Sees.
  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C) const;
  /// The same with its derivative by the point.
  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C, PixelJacobian& J) const;
  /// The ray that a pixel shows, in the camera frame. A pixel that no ray reaches (see HasRay) gets
  /// one at the lens's edge.
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  /// Direction of that ray alone, where the pupil's place does not matter.
  Eigen::Vector3d Direction(const Eigen::Vector2d& pixel) const { return Ray(pixel).direction; }
  /// Whether some ray reaches the pixel: its ray's points come back to it.
  bool HasRay(const Eigen::Vector2d& pixel) const;
  /// Whether the pixel lies on the image, at least margin_px inside its border.
  bool Sees(const Eigen::Vector2d& pixel, double margin_px = 0.0) const;

  /// Pixels per radian on the axis, along u and along v.
  Eigen::Vector2d focal_px() const;
  /// Pixel of the camera frame's z axis, far away.
  Eigen::Vector2d centre_px() const;

  bool operator==(const Camera&) const = default;
};

/// The equidistant lens that spreads fov_rad over the image's width; centre in the middle.
Camera EquidistantCamera(int width, int height, double horizontal_fov_rad);

/// The same lens with its focal lengths times `scale` and its centre moved.
Camera Adjusted(Camera camera, double focal_scale, const Eigen::Vector2d& centre_shift_px);

/// The same lens with one more radial term. It shifts pixels outwards: by shift_px at half the
/// image's width from the axis, elsewhere as the cube of the distance.
Camera Bent(Camera camera, double shift_px);

/// The same view on an image of another size: the outer edges of the image keep their rays.
Camera Resized(Camera camera, int width, int height);

/// A stereo pair on the rover body.
struct StereoRig {
  Camera left, right;
  Pose3 X_RL, X_RQ;  // left and right camera in the rover body [m]

  double baseline_m() const { return (X_RQ.p - X_RL.p).norm(); }
};

}  // namespace dockyard
