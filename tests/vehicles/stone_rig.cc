#include "vehicles/stone_rig.h"

#include <algorithm>

namespace dockyard {
namespace {

constexpr double kPeriod_s = 0.01;

void Wait(ArmRig& rig) {
  rig.Run(kPeriod_s);
  if (rig.each_period) rig.each_period();
}

// Both scoops about the vertical, open by this angle between them.
void TurnScoops(ArmRig& rig, double pitch_rad, double open_rad, double speed_rad_s,
                double current_a = 10.0) {
  rig.Turn(kFrontScoop, -pitch_rad - 0.5 * open_rad, speed_rad_s, current_a);
  rig.Turn(kBackScoop, -pitch_rad + 0.5 * open_rad, speed_rad_s, current_a);
}

double PitchFor(const ArmRig& rig, double axis_m) {
  const double shoulder_m = rig.model.arm->p_RA.z() + RollingRadius(rig.model.tyre);
  return std::asin((shoulder_m - axis_m) / rig.model.arm->length_m);
}

// Until the pitch motor's current differs from that of the free descent, or it is there.
void Lower(ArmRig& rig, const GraspScript& script) {
  const double open_rad = script.open_share * MostOpen_rad(rig.model.arm->scoop);
  const double above = PitchFor(rig, 0.09), down = PitchFor(rig, script.lower_to_m);
  rig.Turn(kArmPitch, above);
  TurnScoops(rig, above, open_rad, 0.9);
  rig.Run(4.5);
  double usual_a = -1.0;
  for (double pitch = above; pitch < down; pitch += 0.1 * kPeriod_s) {
    rig.Turn(kArmPitch, pitch);
    TurnScoops(rig, pitch, open_rad, 0.9);
    Wait(rig);
    const double now_a = rig.current_a(kArmPitch);
    if (usual_a < 0.0 || pitch < above + 0.03) usual_a = now_a;
    usual_a += 0.02 * (now_a - usual_a);
    if (std::abs(now_a - usual_a) > script.ground_a) break;
  }
}

}  // namespace

double Steepest(const HeightGrid& grid, const Eigen::Vector2d& at, double half_m) {
  const GridCell low = CellAt(grid, at.x() - half_m, at.y() - half_m);
  const GridCell high = CellAt(grid, at.x() + half_m, at.y() + half_m);
  double steepest_m = 0.0;
  for (int iy = low.iy; iy <= high.iy; ++iy) {
    for (int ix = low.ix; ix <= high.ix; ++ix) {
      const double* h = grid.heights_m.data() + static_cast<std::ptrdiff_t>(iy) * grid.nx + ix;
      steepest_m = std::max({steepest_m, std::abs(h[0] - h[1]), std::abs(h[0] - h[grid.nx])});
    }
  }
  return steepest_m / grid.cell_m;
}

GraspEnd Grasp(ArmRig& rig, const GraspScript& script, double lift_rad) {
  Lower(rig, script);
  double pitch = rig.angle_rad(kArmPitch), raised_rad = 0.0, felt_s = 0.0, still_s = 0.0;
  double least_open = 10.0, time_s = 0.0;
  GraspEnd end = GraspEnd::kTimeOut;
  for (; time_s < script.time_out_s; time_s += kPeriod_s) {
    rig.Turn(kArmPitch, pitch);
    TurnScoops(rig, pitch, 0.0, script.close_rad_s);
    Wait(rig);
    const double open = rig.angle_rad(kBackScoop) - rig.angle_rad(kFrontScoop);
    if (open < 0.03) {
      end = GraspEnd::kClosed;
      break;
    }
    const bool feels =
        std::max(rig.current_a(kFrontScoop), rig.current_a(kBackScoop)) > script.feels_a;
    felt_s = feels ? felt_s + kPeriod_s : 0.0;
    still_s = open < least_open - 0.005 ? 0.0 : still_s + kPeriod_s;
    least_open = std::min(least_open, open);
    if (felt_s >= 0.05 && raised_rad < script.raise_most_rad) {
      pitch -= script.raise_rad;
      raised_rad += script.raise_rad;
      felt_s = 0.0;
    }
    if (still_s > 1.0 && raised_rad >= script.raise_most_rad) {
      end = GraspEnd::kHeld;
      break;
    }
  }
  const double up = pitch - lift_rad;
  rig.Turn(kArmPitch, up, 0.2);
  TurnScoops(rig, up, 0.0, 0.2);
  rig.Run(lift_rad / 0.2 + 0.5);
  return end;
}

}  // namespace dockyard
