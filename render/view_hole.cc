#include "render/view_hole.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"

namespace dockyard {

double ShareThroughHole(const ViewHole& hole, const Eigen::Vector2d& tan) {
  if (hole.half_angle_rad == 0.0) return 1.0;
  const double a = hole.distance_m * std::tan(hole.half_angle_rad), r = 0.5 * hole.pupil_m;
  const double d = hole.distance_m * (tan - hole.middle).norm();
  if (d >= a + r) return 0.0;
  if (d <= a - r || r == 0.0) return 1.0;
  if (d <= r - a) return a * a / (r * r);
  // Both circles' segments on the far side of the chord through their two crossings.
  const double to_chord = (d * d + a * a - r * r) / (2.0 * d);
  const auto segment = [](double radius, double at) {
    const double cosine = std::clamp(at / radius, -1.0, 1.0);
    return radius * radius * (std::acos(cosine) - cosine * std::sqrt(1.0 - cosine * cosine));
  };
  return (segment(a, to_chord) + segment(r, d - to_chord)) / (kPi * r * r);
}

void CheckHole(const ViewHole& hole) {
  DOCKYARD_CHECK(hole.half_angle_rad >= 0.0 && hole.half_angle_rad < 1.2);
  DOCKYARD_CHECK(hole.distance_m > 0.0 && hole.pupil_m >= 0.0 && hole.middle.allFinite());
}

}  // namespace dockyard
