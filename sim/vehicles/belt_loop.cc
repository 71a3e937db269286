#include "sim/vehicles/belt_loop.h"

#include <cmath>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

Eigen::Vector2d Direction(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

BeltSegment Run(const Roller& from, const Eigen::Vector2d& out, double length_m) {
  BeltSegment run;
  run.end_m = length_m;
  run.from = Eigen::Vector2d(from.x_m, from.z_m) + from.radius_m * out;
  run.out = out;
  run.along = AlongBelt(out);
  return run;
}

BeltSegment Arc(const Roller& roller, double begin_rad, double turn_rad) {
  BeltSegment arc;
  arc.end_m = roller.radius_m * turn_rad;
  arc.from = {roller.x_m, roller.z_m};
  arc.radius_m = roller.radius_m;
  arc.begin_rad = begin_rad;
  return arc;
}

}  // namespace

BeltLoop MakeBeltLoop(const BeltModel& belt) {
  const double dx = belt.front.x_m - belt.rear.x_m, dz = belt.front.z_m - belt.rear.z_m;
  const double apart = std::hypot(dx, dz), wider = belt.rear.radius_m - belt.front.radius_m;
  DOCKYARD_CHECK(belt.front.radius_m > 0.0 && belt.rear.radius_m > 0.0);
  DOCKYARD_CHECK(apart > std::fabs(wider));
  // A run's normal has the product `wider` with the way between the axles, as it touches both.
  const double forward_rad = std::atan2(dz, dx), beside_rad = std::acos(wider / apart);
  const double run_m = std::sqrt(apart * apart - wider * wider);
  const double low_rad = forward_rad - beside_rad, high_rad = forward_rad + beside_rad;
  BeltLoop loop;
  loop.segments = {
      Run(belt.front, Direction(low_rad), run_m), Arc(belt.rear, low_rad, 2.0 * (kPi - beside_rad)),
      Run(belt.rear, Direction(high_rad), run_m), Arc(belt.front, high_rad, 2.0 * beside_rad)};
  for (BeltSegment& segment : loop.segments) {
    segment.begin_m += loop.length_m;
    segment.end_m += loop.length_m;
    loop.length_m = segment.end_m;
  }
  return loop;
}

}  // namespace dockyard
