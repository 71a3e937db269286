// The paper's centre of a blob: an ellipse through its perimeter (Tsai et al., III-A.2).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace dockyard {

/// rim(t) = centre_px + shape_px (cos t, sin t), shape symmetric positive definite [px].
struct Ellipse {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  Eigen::Matrix2d shape_px = Eigen::Matrix2d::Identity();

  double mean_radius_px() const;         // of the circle with the same area
  Eigen::Vector2d semi_axes_px() const;  // minor, major
  /// Where a pixel lies on the disc: the rim has length one.
  Eigen::Vector2d ToDisc(const Eigen::Vector2d& pixel) const;
};

/// Direct least squares (Fitzgibbon, Pilu and Fisher, IEEE TPAMI 21(5), 1999), in the numerically
/// stable split of Halir and Flusser (WSCG 1998). None for fewer than five points or points that
/// lie on no ellipse.
std::optional<Ellipse> FitEllipse(const std::vector<Eigen::Vector2d>& rim_px);

}  // namespace dockyard
