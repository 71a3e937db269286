// A smooth displacement of a lens's pixels, which no parameter of its model takes up. Lenses of the
// world alone have one; a controller's calibration has none. No GL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "controller/geometry/camera.h"

namespace dockyard {

/// Pixel p of the image shows the ray that the model gives the pixel p - At(p). With x the place
/// from the image's middle over half its diagonal, At(p) is
///   ring_px x cos(2 pi ring_turns |x|^2 + ring_phase_rad)
///   + the sum over the waves of shift_px cos(2 pi turns . x + phase_rad).
/// None by default.
struct LensRipple {
  struct Wave {
    Eigen::Vector2d turns = Eigen::Vector2d::Zero();     // along u and v, over half the diagonal
    Eigen::Vector2d shift_px = Eigen::Vector2d::Zero();  // of its crest
    double phase_rad = 0.0;
    bool operator==(const Wave&) const = default;
  };
  Eigen::Vector2d middle_px = Eigen::Vector2d::Zero();
  double half_diagonal_px = 0.0;  // 0: none
  double ring_px = 0.0, ring_turns = 0.0, ring_phase_rad = 0.0;
  std::array<Wave, 3> waves{};

  bool none() const { return half_diagonal_px == 0.0; }
  /// [px]; of any pixel, on the image or off it.
  Eigen::Vector2d At(const Eigen::Vector2d& pixel) const;
  bool operator==(const LensRipple&) const = default;
};

/// The same pattern on an image of this size: ring and waves with equal shares of its power, and
/// rms_px [px] over the image in all. The ripple has both.
LensRipple ScaledTo(LensRipple ripple, int width, int height, double rms_px);

/// The ray that a pixel of a lens with a ripple shows, in the camera frame; as Camera::Ray.
LensRay RayWith(const LensRipple& ripple, const Camera& camera, const Eigen::Vector2d& pixel);

/// The pixel of a point, as Camera::Project: RayWith's inverse, to 1e-9 px by fixed point, where
/// the ripple's slope is below 1/2.
std::optional<Eigen::Vector2d> ProjectWith(const LensRipple& ripple, const Camera& camera,
                                           const Eigen::Vector3d& p_C);

}  // namespace dockyard
