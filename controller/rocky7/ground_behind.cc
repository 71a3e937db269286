#include "controller/rocky7/ground_behind.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// Higher than this over the ground is an obstacle, as before a face (face_obstacles.cc). Assumed,
// 5-8 cm.
constexpr double kHigh_m = 0.06;
// Cells, how far behind and aside they reach. Assumed, 2-4 cm, 0.7-1 m and 0.4-0.6 m.
constexpr double kBehindCell_m = 0.03, kBehind_m = 0.75, kBehindAside_m = 0.5;
// Nearer to the rover's rear is the rover itself. Assumed, 1-4 cm.
constexpr double kOurs_m = 0.02;

Nominal Backwards(Nominal nominal) {
  nominal.front = nominal.back;
  return nominal;
}

double RearOf(const RoverPlan& plan) {
  double rear_m = 0.0;
  for (const WheelPlan& wheel : plan.wheels) {
    rear_m = std::min(rear_m, wheel.p_RW.x() - plan.wheel_radius_m);
  }
  for (const Polygon& part : plan.body) {
    for (const Eigen::Vector2d& corner : part) rear_m = std::min(rear_m, corner.x());
  }
  return rear_m;
}

bool IsRaised(const ElevationMap& map, int ix, int iy) {
  if (ix < 0 || iy < 0 || ix >= map.nx || iy >= map.ny) return false;
  return map.height_m[static_cast<std::size_t>(iy * map.nx + ix)] > kHigh_m;
}

// A cell alone is a wrong range: what is that high is wider than a cell.
bool HasRaisedNeighbour(const ElevationMap& map, int ix, int iy) {
  return IsRaised(map, ix - 1, iy) || IsRaised(map, ix + 1, iy) || IsRaised(map, ix, iy - 1) ||
         IsRaised(map, ix, iy + 1);
}

}  // namespace

GroundBehind::GroundBehind(const Nominal& nominal)
    : plan_(nominal.plan), stereo_(Backwards(nominal)) {}

std::vector<Eigen::Vector2d> GroundBehind::Obstacles(const StereoImages& images,
                                                     const ImuSample& attitude) const {
  const double rear_m = RearOf(plan_) - kOurs_m;
  const ElevationMap map =
      stereo_.Heights(stereo_.Look(images, attitude), {.cell_m = kBehindCell_m,
                                                       .x_low_m = rear_m - kBehind_m,
                                                       .x_high_m = rear_m,
                                                       .y_low_m = -kBehindAside_m,
                                                       .y_high_m = kBehindAside_m});
  std::vector<Eigen::Vector2d> middles;
  for (int iy = 0; iy < map.ny; ++iy) {
    for (int ix = 0; ix < map.nx; ++ix) {
      if (!IsRaised(map, ix, iy) || !HasRaisedNeighbour(map, ix, iy)) continue;
      middles.emplace_back(map.x0_m + ix * map.cell_m, map.y0_m + iy * map.cell_m);
    }
  }
  return middles;
}

}  // namespace dockyard::rocky7
