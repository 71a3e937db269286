// The angle about the pyramid and the distance to it, from two lengths in the image: eqs. (2) and
// (7) of Ferreira and Ventura ("F").
#pragma once

#include "controller/geometry/pose.h"

namespace dockyard::raposa {

/// Angle about the pyramid to which both colours are visible without occlusion (F, C.2).
inline constexpr double kVisibleTo_rad = Radians(110.0);

/// What two lengths say. Without a side: alpha > 0 on either (the blue mark's side gives the sign).
struct MarkAngle {
  double alpha_rad = 0.0;    // the minus root of (7): from -atan(h/2m) up to atan(2m/h), 73 deg
  double d_m = 0.0;          // (2): depth of the blue square's nearer edge
  double r_m = 0.0;          // from the camera to the guide, in plan, where alpha is right
  double other_rad = 0.0;    // the plus root: as far beyond the turning point
  bool beyond_root = false;  // (7) had no root: that of the turning point was taken
  bool ambiguous = false;    // both roots lie within 0 to 110 deg, or none does
};

/// Where c/g is largest and (7) turns back: atan(2m/h).
double TurningPoint(double edge_m, double behind_m);

/// (2) and (7), always with the minus root (F, C.2). With R^2 = m^2 + (h/2)^2 and tan psi = h/2m,
/// (7) is alpha = asin(c h/(g R)) - psi; a larger c/g than R/h has no root and counts as R/h.
/// @param c_px      from the middle of the orange ellipse to the farther end of the blue region, >
/// 0
/// @param g_px      height of the blue region, > 0
/// @param edge_m    h, the edge of the blue square
/// @param behind_m  m, from the guide's middle to the square's
/// @param focal_px  f, in pixels
MarkAngle AngleOfMarks(double c_px, double g_px, double edge_m, double behind_m, double focal_px);

}  // namespace dockyard::raposa
