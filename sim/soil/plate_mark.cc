#include "sim/soil/plate_mark.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// Places of a heap about a plate, and their distance from its edge in cells: as near as soil that
// four samples share stays clear of the plate. The distance is assumed, range 1.4-3 cells.
constexpr int kHeapPlaces = 8;
constexpr double kHeapCells = 1.5;

}  // namespace

void KeepUndisturbed(HeightGrid& grid) {
  if (grid.undisturbed_m.size() != grid.heights_m.size()) grid.undisturbed_m = grid.heights_m;
}

UndisturbedAt FindUndisturbed(const HeightGrid& grid, const Eigen::Vector2d& at) {
  const GridCell cell = CellAt(grid, at.x(), at.y());
  UndisturbedAt ground;
  ground.height_m = Interpolate(grid, grid.undisturbed_m, cell);
  ground.sunk_m = ground.height_m - Interpolate(grid, grid.heights_m, cell);
  const double* low =
      grid.undisturbed_m.data() + static_cast<std::ptrdiff_t>(cell.iy) * grid.nx + cell.ix;
  const double* high = low + grid.nx;
  const double rise_x = (1.0 - cell.v) * (low[1] - low[0]) + cell.v * (high[1] - high[0]);
  const double rise_y = (1.0 - cell.u) * (high[0] - low[0]) + cell.u * (high[1] - low[1]);
  ground.normal_G = Eigen::Vector3d(-rise_x, -rise_y, grid.cell_m).normalized();
  return ground;
}

double PressMark(HeightGrid& grid, const RoundArea& plate, double sunk_m) {
  const double reach_m = std::max(plate.radius_m, grid.cell_m);
  const auto first = [&](double at, int last) {
    return std::clamp(static_cast<int>(std::floor((at - reach_m) / grid.cell_m)), 0, last);
  };
  const auto end = [&](double at, int last) {
    return std::clamp(static_cast<int>(std::ceil((at + reach_m) / grid.cell_m)), 0, last);
  };
  const double x_m = plate.centre.x() - grid.x0_m, y_m = plate.centre.y() - grid.y0_m;
  double lowered_m = 0.0;
  for (int iy = first(y_m, grid.ny - 1); iy <= end(y_m, grid.ny - 1); ++iy) {
    for (int ix = first(x_m, grid.nx - 1); ix <= end(x_m, grid.nx - 1); ++ix) {
      if (!LiesOn(grid, plate, ix, iy)) continue;
      const std::size_t index = static_cast<std::size_t>(iy) * grid.nx + ix;
      const double above_m = grid.heights_m[index] - (grid.undisturbed_m[index] - sunk_m);
      if (above_m <= 0.0) continue;
      grid.heights_m[index] -= above_m;
      lowered_m += above_m;
    }
  }
  if (lowered_m > 0.0) ++grid.revision;
  return lowered_m * grid.cell_m * grid.cell_m;
}

void HeapAround(HeightGrid& grid, const RoundArea& plate, const Eigen::Vector2d& towards,
                double volume_m3) {
  const double push = towards.norm();
  const Eigen::Vector2d ahead =
      push > 0.0 ? Eigen::Vector2d(towards / push) : Eigen::Vector2d::UnitX();
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const double out_m = plate.radius_m + kHeapCells * grid.cell_m;
  for (int i = 0; i < kHeapPlaces; ++i) {
    const double angle = 2.0 * kPi * i / kHeapPlaces, c = std::cos(angle), s = std::sin(angle);
    const double share = (1.0 + std::min(push, 1.0) * c) / kHeapPlaces;
    AddSoil(grid, plate.centre + out_m * (c * ahead + s * left), share * volume_m3);
  }
}

}  // namespace dockyard
