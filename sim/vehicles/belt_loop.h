// The way of a belt round its two rollers: two straight runs and two arcs, in the plane of the
// carrying link's x and z.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "models/parts/belt.h"

namespace dockyard {

/// A piece of the loop, from begin_m to end_m of the way that a belt of positive speed travels:
/// lower run backward, rear roller up, upper run forward, front roller down.
struct BeltSegment {
  double begin_m = 0.0, end_m = 0.0;
  // Run: the point at begin_m, and outward normal and direction of travel. Arc: the roller's axle.
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d out = Eigen::Vector2d::Zero(), along = Eigen::Vector2d::Zero();
  double radius_m = 0.0;   // 0: a run
  double begin_rad = 0.0;  // of an arc: direction of its normal at begin_m, from x to z
};

/// A place on the loop: the point, its outward normal and the direction of travel there.
struct LoopPlace {
  Eigen::Vector2d at, out, along;
};

struct BeltLoop {
  std::array<BeltSegment, 4> segments;
  double length_m = 0.0;
};

/// Refuses rollers of which one holds the other.
BeltLoop MakeBeltLoop(const BeltModel& belt);

/// The direction of travel where the outward normal is this.
inline Eigen::Vector2d AlongBelt(const Eigen::Vector2d& out) { return {out.y(), -out.x()}; }

inline LoopPlace PlaceOn(const BeltSegment& segment, double s_m) {
  const double past_m = s_m - segment.begin_m;
  if (segment.radius_m == 0.0) {
    return {segment.from + past_m * segment.along, segment.out, segment.along};
  }
  const double angle_rad = segment.begin_rad - past_m / segment.radius_m;
  const Eigen::Vector2d out(std::cos(angle_rad), std::sin(angle_rad));
  return {segment.from + segment.radius_m * out, out, AlongBelt(out)};
}

/// Where a parabola's depth h(u) = middle + slope u - curvature u^2 / 2, |u| <= length / 2, is
/// positive: from where to where, the integral of h, and its first moment. The curvature is not
/// negative.
struct PressedPart {
  double low_m = 0.0, high_m = 0.0;  // equal: nothing is pressed
  double area_m2 = 0.0, moment_m3 = 0.0;
};
inline PressedPart PressedPartOf(double middle_m, double slope, double curvature_per_m,
                                 double length_m) {
  double low = -0.5 * length_m, high = 0.5 * length_m;
  if (curvature_per_m > 0.0) {
    const double inside = slope * slope + 2.0 * curvature_per_m * middle_m;
    if (inside <= 0.0) return {};
    // The roots' product is -2 h(0) / q; the larger root first, so that no digits cancel.
    const double sum = slope + std::copysign(std::sqrt(inside), slope);
    const double far = sum / curvature_per_m, near = -2.0 * middle_m / sum;
    low = std::max(low, std::min(far, near));
    high = std::min(high, std::max(far, near));
  } else if (slope != 0.0) {
    const double root = -middle_m / slope;
    if (slope > 0.0) {
      low = std::max(low, root);
    } else {
      high = std::min(high, root);
    }
  } else if (middle_m <= 0.0) {
    return {};
  }
  const double pressed = high - low;
  if (!(pressed > 0.0)) return {};
  // About the pressed part's own middle: whole products, no differences of powers.
  const double c = 0.5 * (low + high), half = 0.5 * pressed, third = half * half / 3.0;
  const double at_c = middle_m + c * (slope - 0.5 * curvature_per_m * c);
  const double slope_c = slope - curvature_per_m * c;
  const double area = pressed * (at_c - 0.5 * curvature_per_m * third);
  return {low, high, area, c * area + pressed * slope_c * third};
}

}  // namespace dockyard
