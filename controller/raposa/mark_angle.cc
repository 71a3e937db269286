#include "controller/raposa/mark_angle.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"

namespace dockyard::raposa {
namespace {

constexpr double kRounding_rad = Radians(0.01);  // of lengths written with four digits

bool Visible(double alpha_rad) {
  return alpha_rad >= -kRounding_rad && alpha_rad <= kVisibleTo_rad + kRounding_rad;
}

}  // namespace

double TurningPoint(double edge_m, double behind_m) { return std::atan2(2.0 * behind_m, edge_m); }

MarkAngle AngleOfMarks(double c_px, double g_px, double edge_m, double behind_m, double focal_px) {
  DOCKYARD_CHECK(c_px > 0.0 && g_px > 0.0 && edge_m > 0.0 && behind_m > 0.0 && focal_px > 0.0);
  const double half_m = 0.5 * edge_m;
  const double share = c_px * edge_m / g_px / std::hypot(behind_m, half_m);
  const double psi_rad = std::atan2(half_m, behind_m);
  MarkAngle angle;
  angle.beyond_root = share > 1.0;
  angle.alpha_rad = std::asin(std::min(share, 1.0)) - psi_rad;
  angle.other_rad = 2.0 * TurningPoint(edge_m, behind_m) - angle.alpha_rad;
  angle.ambiguous = angle.beyond_root || Visible(angle.alpha_rad) == Visible(angle.other_rad);
  angle.d_m = edge_m * focal_px / g_px;
  angle.r_m = angle.d_m - behind_m * std::cos(angle.alpha_rad) + half_m * std::sin(angle.alpha_rad);
  return angle;
}

}  // namespace dockyard::raposa
