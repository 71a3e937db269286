#include "sim/soil/rut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace dockyard {
namespace {

// How far beside the wheel the displaced soil comes to rest, in cells from the rim's edge, and how
// it is shared: a berm about as wide as the rut's wall is high. Assumed, range 1-5 cells, any
// shares that sum to a half.
constexpr std::array<double, 3> kBermCells{1.5, 2.5, 3.5};
constexpr std::array<double, 3> kBermShares{0.25, 0.15, 0.10};  // of each of two sides
// Cells beside the rim, and before and behind the contact, in which slopes may slump: berms lie
// within four of the rim.
constexpr int kSlumpBeside = 6, kSlumpBehind = 3;
// A slope's excess over the friction angle halves in this time: that of a fall through a few
// millimetres. Assumed, range 0.01-0.1 s.
constexpr double kSlumpTime_s = 0.025;
// Share of a slope's excess that slides in one pass at most; simultaneous flow over four edges is
// stable below 1/8.
constexpr double kLargestShare = 0.1;
// Ties, half a cell aside or pressed to the rim's surface, are decided alike on both sides of the
// wheel.
constexpr double kEdgeTolerance_m = 1e-6;

/// Grid samples [x_begin, x_end) x [y_begin, y_end).
struct Window {
  int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;

  int width() const { return x_end - x_begin; }
  int height() const { return y_end - y_begin; }
};

/// The samples around the contact and this many cells more, beside the rim and on the wheel's way.
Window WindowAround(const HeightGrid& grid, const RimPlace& rim, int beside, int behind) {
  const Eigen::Vector3d& a = rim.axis_G;
  const double across = 0.5 * rim.width_m + beside * grid.cell_m;
  const double along = rim.reach_m + behind * grid.cell_m;
  const double extent_x = std::fabs(a.x()) * across + std::fabs(a.y()) * along;
  const double extent_y = std::fabs(a.y()) * across + std::fabs(a.x()) * along;
  const auto range = [&](double low, double high, int samples, int& begin, int& end) {
    const double last = samples;
    begin = static_cast<int>(std::clamp(std::floor(low / grid.cell_m), 0.0, last));
    end = static_cast<int>(std::clamp(std::ceil(high / grid.cell_m) + 1, 0.0, last));
  };
  const double x = rim.p_G.x() - grid.x0_m, y = rim.p_G.y() - grid.y0_m;
  Window window;
  range(x - extent_x, x + extent_x, grid.nx, window.x_begin, window.x_end);
  range(y - extent_y, y + extent_y, grid.ny, window.y_begin, window.y_end);
  return window;
}

/// The rim's lower surface above or below a point of the ground plan. Axial place by the way.
struct RimPoint {
  bool over = false;
  double z_m = 0.0, axial_m = 0.0;
};

RimPoint RimAbove(const RimPlace& rim, double x_m, double y_m) {
  const Eigen::Vector3d& a = rim.axis_G;
  const double dx = x_m - rim.p_G.x(), dy = y_m - rim.p_G.y();
  const double u0 = dx * a.x() + dy * a.y();
  // |d|^2 - (d.a)^2 = R^2 for d = (dx, dy, dz), lower root.
  const double q = 1.0 - a.z() * a.z();
  const double root =
      u0 * u0 * a.z() * a.z() - q * (dx * dx + dy * dy - u0 * u0 - rim.radius_m * rim.radius_m);
  if (root <= 0.0) return {};
  const double dz = (u0 * a.z() - std::sqrt(root)) / q;
  const double axial = u0 + dz * a.z();
  return {std::fabs(axial) <= 0.5 * rim.width_m + kEdgeTolerance_m, rim.p_G.z() + dz, axial};
}

void AddSoil(HeightGrid& grid, double x_m, double y_m, double height_m) {
  const GridCell at = CellAt(grid, x_m, y_m);
  const std::size_t low = static_cast<std::size_t>(at.iy) * grid.nx + at.ix;
  const auto add = [&](std::size_t index, double share) {
    grid.heights_m[index] += share * height_m;
  };
  add(low, (1.0 - at.u) * (1.0 - at.v));
  add(low + 1, at.u * (1.0 - at.v));
  add(low + grid.nx, (1.0 - at.u) * at.v);
  add(low + grid.nx + 1, at.u * at.v);
}

/// Moves soil taken at a point under the wheel to the berms on both sides of it.
void HeapBeside(HeightGrid& grid, const RimPlace& rim, double x_m, double y_m, double axial_m,
                double height_m) {
  for (std::size_t i = 0; i < kBermCells.size(); ++i) {
    const double out = 0.5 * rim.width_m + kBermCells[i] * grid.cell_m;
    const double left = out - axial_m, right = -out - axial_m;
    AddSoil(grid, x_m + left * rim.axis_G.x(), y_m + left * rim.axis_G.y(),
            kBermShares[i] * height_m);
    AddSoil(grid, x_m + right * rim.axis_G.x(), y_m + right * rim.axis_G.y(),
            kBermShares[i] * height_m);
  }
}

/// Calls visit(index, x, y) for every sample whose soil reaches into the rim.
template <typename Visit>
void ForSamplesInside(const HeightGrid& grid, const RimPlace& rim, const Visit& visit) {
  const Window window = WindowAround(grid, rim, 1, 1);
  const Eigen::Vector3d p = rim.p_G, a = rim.axis_G;
  const double x0 = grid.x0_m, cell = grid.cell_m;
  const double half = 0.5 * rim.width_m + kEdgeTolerance_m;
  const double radius = rim.radius_m + kEdgeTolerance_m, square = radius * radius;
  for (int iy = window.y_begin; iy < window.y_end; ++iy) {
    const double y = grid.y0_m + iy * cell, dy = y - p.y();
    const double dy_along = dy * a.y(), dy_square = dy * dy - square;
    const std::size_t row = static_cast<std::size_t>(iy) * grid.nx;
    const double* heights = grid.heights_m.data() + row;
    for (int ix = window.x_begin; ix < window.x_end; ++ix) {
      const double dx = x0 + ix * cell - p.x(), dz = heights[ix] - p.z();
      const double along = dx * a.x() + dy_along + dz * a.z();
      if (std::fabs(along) > half || dx * dx + dz * dz + dy_square >= along * along) continue;
      visit(row + ix, x0 + ix * cell, y);
    }
  }
}

/// The flow between the samples of one row and their neighbours, next in the row or in the next
/// row: `far` samples on.
struct Slope {
  double steepest_m = 0.0, share = 0.0;

  void Flow(const double* here, const double* there, int count, int far, const unsigned char* under,
            double* change) const {
    const double steepest = steepest_m;
    for (int i = 0; i < count; ++i) {
      const double step = here[i] - there[i];
      if (std::fabs(step) <= steepest || (under[i] | under[i + far]) != 0) continue;
      const double moved = std::copysign(share * (std::fabs(step) - steepest), step);
      change[i] -= moved;
      change[i + far] += moved;
    }
  }
};

/// Soil slides down between neighbours that differ by more than the slope allows, all at once, so
/// that the order of the samples does not matter.
void Slump(HeightGrid& grid, const Window& area, const Slope& slope, RutScratch& scratch) {
  const int width = area.width(), height = area.height();
  double* heights =
      grid.heights_m.data() + static_cast<std::ptrdiff_t>(area.y_begin) * grid.nx + area.x_begin;
  const unsigned char* under = scratch.under_wheel.data();
  double* change = scratch.change_m.data();
  for (int iy = 0; iy < height; ++iy) {
    const double* row = heights + static_cast<std::ptrdiff_t>(iy) * grid.nx;
    slope.Flow(row, row + 1, width - 1, 1, under + iy * width, change + iy * width);
    if (iy + 1 == height) break;
    slope.Flow(row, row + grid.nx, width, width, under + iy * width, change + iy * width);
  }
  for (int iy = 0; iy < height; ++iy) {
    double* row = heights + static_cast<std::ptrdiff_t>(iy) * grid.nx;
    for (int ix = 0; ix < width; ++ix) row[ix] += change[iy * width + ix];
  }
}

}  // namespace

double PressRut(HeightGrid& grid, const RimPlace& rim, const SoilLaws& laws, double excavated_m) {
  double taken = 0.0;
  ForSamplesInside(grid, rim, [&](std::size_t index, double x, double y) {
    const RimPoint at = RimAbove(rim, x, y);
    if (!at.over) return;
    // A heap above the soil as it was carries nothing: the wheel ploughs through it.
    const double sinkage = grid.undisturbed_m[index] - at.z_m;
    const double yield = YieldPressure(laws, sinkage - excavated_m);
    const double sunk = grid.heights_m[index] - at.z_m - yield / laws.elastic_pa_per_m;
    if (sunk <= 0.0) return;
    grid.heights_m[index] -= sunk;
    taken += sunk;
    HeapBeside(grid, rim, x, y, at.axial_m, sunk);
  });
  if (taken > 0.0) ++grid.revision;
  return taken * grid.cell_m * grid.cell_m;
}

void SlumpBeside(HeightGrid& grid, const RimPlace& rim, const SoilLaws& laws, double dt_s,
                 RutScratch& scratch) {
  const Window area = WindowAround(grid, rim, kSlumpBeside, kSlumpBehind);
  if (area.width() <= 0 || area.height() <= 0) return;
  const std::size_t samples = static_cast<std::size_t>(area.width()) * area.height();
  scratch.under_wheel.assign(samples, 0);
  scratch.change_m.assign(samples, 0.0);
  ForSamplesInside(grid, rim, [&](std::size_t index, double, double) {
    const int iy = static_cast<int>(index / grid.nx), ix = static_cast<int>(index % grid.nx);
    scratch.under_wheel[static_cast<std::size_t>(iy - area.y_begin) * area.width() +
                        (ix - area.x_begin)] = 1;
  });
  // A flow takes twice its share off the step between two samples.
  const double share = std::min(kLargestShare, 0.5 * (1.0 - std::exp2(-dt_s / kSlumpTime_s)));
  Slump(grid, area, {laws.tan_phi * grid.cell_m, share}, scratch);
  ++grid.revision;
}

}  // namespace dockyard
