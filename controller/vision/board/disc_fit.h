// Internal to the vision room. A disc's centre from its grey levels. A fit to the rim's points
// alone scatters by several times the bound that the noise sets.
#pragma once

#include <optional>

#include "controller/geometry/board.h"
#include "controller/geometry/image.h"
#include "controller/vision/ellipse.h"

namespace dockyard {

struct DiscFit {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  double contrast_dn = 0.0;  // white less black
  double misfit_dn = 0.0;    // rms of the residuals
  double sigma_px = 0.0;     // of the centre, one axis, for grey noise of 1 DN (Cramer-Rao bound)
};

/// Least squares of the printed pattern, blurred, on the grey of the disc and a ring about it:
/// white level with a gradient, black level, shift. Shape and bar are taken as given; the pattern
/// is symmetric about the centre, so their errors do not move it.
/// @param bar_rad  the bar in the rim's own plane (BarMatch's angle)
/// @returns none when the ring leaves the image, the fit runs away from the rim, or the light is
///   uneven: then the pattern does not fit
std::optional<DiscFit> FitDisc(const GrayImage& image, const Ellipse& rim, double bar_rad,
                               const FiducialBoard& board);

}  // namespace dockyard
