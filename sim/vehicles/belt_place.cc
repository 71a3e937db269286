#include "sim/vehicles/belt_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

/// How far from its lowest point a roller may touch ground that is this high [m].
double ReachOnArc(double radius_m, double axle_above_m) {
  const double level = std::max(0.0, axle_above_m / radius_m);
  // acos(c) <= pi/2 sqrt(1 - c) for c in 0..1.
  return level < 1.0 ? 0.5 * kPi * radius_m * std::sqrt(1.0 - level) : 0.0;
}

}  // namespace

BeltPlace::BeltPlace(const HeightGrid& grid, const LinkMotion& carrier, double y_m)
    : ground(grid),
      x_G(carrier.X_GL.R.col(0)),
      y_G(carrier.X_GL.R.col(1)),
      z_G(carrier.X_GL.R.col(2)),
      p_G(carrier.X_GL.p),
      middle_G(y_m * y_G),
      v_G(carrier.v_GL_G),
      w_G(carrier.w_GL_G),
      down_rad(std::atan2(-z_G.z(), -x_G.z())) {}

BeltWindow WindowOf(const BeltSegment& segment, const BeltPlace& at, double margin_m) {
  if (segment.radius_m == 0.0) {
    const bool looks_down = segment.out.x() * at.x_G.z() + segment.out.y() * at.z_G.z() < 0.0;
    return looks_down ? BeltWindow{segment.begin_m, segment.end_m} : BeltWindow{};
  }
  const double radius_m = segment.radius_m;
  const Eigen::Vector3d axle_G =
      at.p_G + at.middle_G + segment.from.x() * at.x_G + segment.from.y() * at.z_G;
  double highest_m = -std::numeric_limits<double>::infinity();
  for (const double ahead_m : {-radius_m, 0.0, radius_m}) {
    const Eigen::Vector3d under_G = axle_G + ahead_m * at.x_G;
    highest_m = std::max(highest_m, at.ground.At(under_G.x(), under_G.y()).height_m);
  }
  const double reach_m = ReachOnArc(radius_m, axle_G.z() - highest_m - margin_m);
  if (reach_m == 0.0) return {};
  // The lowest point, at most half a turn from the arc's middle.
  const double middle_m = 0.5 * (segment.begin_m + segment.end_m);
  const double half_rad = 0.5 * (segment.end_m - segment.begin_m) / radius_m;
  const double lowest_m = middle_m + radius_m * WrapPi(segment.begin_rad - half_rad - at.down_rad);
  return {std::max(segment.begin_m, lowest_m - reach_m),
          std::min(segment.end_m, lowest_m + reach_m)};
}

void AddPiece(const BeltSegment& segment, double begin_m, double end_m, const BeltPlace& at,
              BeltTouch& touch) {
  const bool arc = segment.radius_m > 0.0;
  const double middle_m = 0.5 * (begin_m + end_m), length_m = end_m - begin_m;
  const LoopPlace place = PlaceOn(segment, middle_m);
  const Eigen::Vector3d arm_G = at.middle_G + place.at.x() * at.x_G + place.at.y() * at.z_G;
  const Eigen::Vector3d p_G = at.p_G + arm_G;
  const GroundSpot spot = at.ground.At(p_G.x(), p_G.y());
  const double below_m = spot.height_m - p_G.z();
  // No end of the piece lies deeper than its middle by more than its length.
  if (below_m <= -length_m) return;
  const Eigen::Vector3d n_G = spot.Normal();
  const double n_x = n_G.dot(at.x_G), n_z = n_G.dot(at.z_G);
  const double into = -(place.out.x() * n_x + place.out.y() * n_z);
  const double slope = -(place.along.x() * n_x + place.along.y() * n_z);
  if (into <= 0.0) return;
  PressedPart part;
  if (arc) {
    // About the roller's lowest point over this plane, so that neighbours share one parabola.
    const double steep = std::sqrt(into * into + slope * slope), bend = steep / segment.radius_m;
    const double lowest_m = below_m * n_G.z() + segment.radius_m * (steep - into);
    if (lowest_m <= 0.0) return;
    const double ahead_m = segment.radius_m * std::atan2(slope, into);
    part = PressedPartOf(lowest_m - 0.5 * bend * ahead_m * ahead_m, bend * ahead_m, bend, length_m);
  } else {
    part = PressedPartOf(below_m * n_G.z(), slope, 0.0, length_m);
  }
  if (!(part.area_m2 > 0.0)) return;
  const Eigen::Vector3d along_G = place.along.x() * at.x_G + place.along.y() * at.z_G;
  touch.area_m2 += part.area_m2;
  touch.length_m += part.high_m - part.low_m;
  touch.arm_G += part.area_m2 * arm_G + part.moment_m3 * along_G;
  touch.up_G += part.area_m2 * n_G;
  touch.in_G -= part.area_m2 * (place.out.x() * at.x_G + place.out.y() * at.z_G);
  for (const double u_m : {part.low_m, part.high_m}) {
    const double x_m = place.at.x() + u_m * place.along.x();
    touch.front_m = std::max(touch.front_m, x_m);
    touch.rear_m = std::min(touch.rear_m, x_m);
  }
}

}  // namespace dockyard
