#include "sim/soil/moved_soil.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

void AddVolume(HeightGrid& grid, const Eigen::Vector2d& at, double volume_m3) {
  const GridCell cell = CellAt(grid, at.x(), at.y());
  const double height_m = volume_m3 / (grid.cell_m * grid.cell_m);
  double* low = grid.heights_m.data() + static_cast<std::ptrdiff_t>(cell.iy) * grid.nx + cell.ix;
  double* high = low + grid.nx;
  low[0] += height_m * (1.0 - cell.u) * (1.0 - cell.v);
  low[1] += height_m * cell.u * (1.0 - cell.v);
  high[0] += height_m * (1.0 - cell.u) * cell.v;
  high[1] += height_m * cell.u * cell.v;
}

// By how much the slope was too steep.
double Slide(double& a, double& b, double steepest_m) {
  const double excess_m = std::abs(a - b) - steepest_m;
  if (excess_m <= 0.0) return 0.0;
  const double moved_m = std::copysign(0.25 * excess_m, a - b);
  a -= moved_m;
  b += moved_m;
  return excess_m;
}

bool IsHeld(const HeightGrid& grid, std::span<const RoundArea> plates, int ix, int iy) {
  return std::any_of(plates.begin(), plates.end(),
                     [&](const RoundArea& plate) { return LiesOn(grid, plate, ix, iy); });
}

double SlumpOnce(HeightGrid& grid, const LooseSlope& slope, const GridCell& low,
                 const GridCell& high) {
  const double steepest_m = slope.friction * grid.cell_m;
  double excess_m = 0.0;
  for (int iy = low.iy; iy <= high.iy; ++iy) {
    for (int ix = low.ix; ix <= high.ix; ++ix) {
      if (IsHeld(grid, slope.held, ix, iy)) continue;
      double* at = grid.heights_m.data() + static_cast<std::ptrdiff_t>(iy) * grid.nx + ix;
      if (!IsHeld(grid, slope.held, ix + 1, iy)) {
        excess_m = std::max(excess_m, Slide(at[0], at[1], steepest_m));
      }
      if (!IsHeld(grid, slope.held, ix, iy + 1)) {
        excess_m = std::max(excess_m, Slide(at[0], at[grid.nx], steepest_m));
      }
    }
  }
  return excess_m;
}

}  // namespace

bool LiesOn(const HeightGrid& grid, const RoundArea& plate, int ix, int iy) {
  const double dx_m = std::abs(grid.x0_m + ix * grid.cell_m - plate.centre.x());
  const double dy_m = std::abs(grid.y0_m + iy * grid.cell_m - plate.centre.y());
  return (dx_m < grid.cell_m && dy_m < grid.cell_m) ||
         dx_m * dx_m + dy_m * dy_m <= plate.radius_m * plate.radius_m;
}

void AddSoil(HeightGrid& grid, const Eigen::Vector2d& at, double volume_m3) {
  if (grid.undisturbed_m.empty()) grid.undisturbed_m = grid.heights_m;
  AddVolume(grid, at, volume_m3);
  ++grid.revision;
}

void MoveSoil(HeightGrid& grid, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
              double volume_m3) {
  if (grid.undisturbed_m.empty()) grid.undisturbed_m = grid.heights_m;
  AddVolume(grid, from, -volume_m3);
  AddVolume(grid, to, volume_m3);
  ++grid.revision;
}

bool Slump(HeightGrid& grid, const LooseSlope& slope, int most_passes) {
  constexpr double kAtRest_m = 1e-5;
  const Eigen::Vector2d& at = slope.centre;
  const GridCell low = CellAt(grid, at.x() - slope.half_m, at.y() - slope.half_m);
  const GridCell high = CellAt(grid, at.x() + slope.half_m, at.y() + slope.half_m);
  bool rests = false;
  for (int pass = 0; pass < most_passes && !rests; ++pass) {
    rests = SlumpOnce(grid, slope, low, high) < kAtRest_m;
  }
  ++grid.revision;
  return rests;
}

double BearingHeight(const HeightGrid& grid, double x_m, double y_m) {
  const GridCell cell = CellAt(grid, x_m, y_m);
  const double height_m = Interpolate(grid, grid.heights_m, cell);
  if (grid.undisturbed_m.empty()) return height_m;
  return std::min(height_m, Interpolate(grid, grid.undisturbed_m, cell));
}

}  // namespace dockyard
