// Points of the tan plane for a lens's pixels, (x, y) = ray.xy / ray.z in the camera frame. Plain
// arithmetic, no GL.
#pragma once

#include <vector>

#include "controller/geometry/camera.h"
#include "render/flat_view.h"
#include "render/lens_ripple.h"
#include "render/pupil.h"

namespace dockyard {

/// Off the axis; beyond it one flat view no longer serves.
inline constexpr double kWidestDrawn_rad = Radians(65.0);

/// Tan-plane points of a lens's pixels, tabulated from Camera::Ray: against the radius for a
/// Kannala-Brandt lens, corner by corner for the others and with a ripple, which costs 0.1 s: keep
/// it for the run.
class TanScale {
 public:
  /// Throws std::invalid_argument when the camera's numbers are no camera, or a pixel points
  /// further than kWidestDrawn_rad off the axis.
  explicit TanScale(const Camera& camera, const LensRipple& ripple = {});
  /// Tan-plane point of a pixel; error below 1e-8.
  Eigen::Vector2d operator()(const Eigen::Vector2d& pixel) const;
  /// Of a whole row of pixel corners (x - 0.5, y - 0.5), x = 0 ... width. A lens with a moving
  /// pupil sees them where its rays end.
  void CornerRow(int y, const RayEnds& ends, std::vector<Eigen::Vector2f>& row) const;
  /// Whether the rays come from more than one point, so that rows depend on where they end.
  bool pupil_moves() const { return !pupil_m_.empty(); }

  const Camera& camera() const { return camera_; }
  const LensRipple& ripple() const { return ripple_; }

 private:
  void TabulateRadius(const KannalaBrandt& lens);
  void TabulateCorners();

  Camera camera_;
  LensRipple ripple_;
  double per_rho2_ = 0.0;
  std::vector<double> table_;             // tan(theta) / rho
  std::vector<Eigen::Vector2f> corners_;  // row by row
  std::vector<float> pupil_m_;            // shift of each corner's ray along O; empty: a centre
};

/// The smallest rectangle that holds every pixel's footprint, grown by 2 % and 4 px.
TanRect ImageRect(const Camera& camera, const TanScale& scale);

}  // namespace dockyard
