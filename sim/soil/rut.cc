#include "sim/soil/rut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace dockyard {
namespace {

// How far beside the wheel the displaced soil comes to rest, in cells from the rim's edge, and how
// it is shared: a berm about as wide as the rut's wall is high. Assumed.
constexpr std::array<double, 3> kBermCells{1.5, 2.5, 3.5};
constexpr std::array<double, 3> kBermShares{0.25, 0.15, 0.10};  // of each of two sides
// Cells beside the contact in which slopes may slump.
constexpr int kSlumpMargin = 8;
// Share of a slope's excess that slides in one pass; simultaneous flow over four edges is stable
// below 1/8.
constexpr double kSlumpShare = 0.1;
// Half-cell ties are decided alike on both sides of the wheel.
constexpr double kEdgeTolerance_m = 1e-6;

/// Grid samples [x_begin, x_end) x [y_begin, y_end).
struct Window {
  int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;

  int width() const { return x_end - x_begin; }
  int height() const { return y_end - y_begin; }
};

Window WindowAround(const HeightGrid& grid, const RimPlace& rim, int margin) {
  const Eigen::Vector3d& a = rim.axis_G;
  const double half = 0.5 * rim.width_m;
  const double extent_x = std::fabs(a.x()) * half + std::fabs(a.y()) * rim.reach_m;
  const double extent_y = std::fabs(a.y()) * half + std::fabs(a.x()) * rim.reach_m;
  const auto range = [&](double low, double high, int samples, int& begin, int& end) {
    const double last = samples;
    begin = static_cast<int>(std::clamp(std::floor(low / grid.cell_m) - margin, 0.0, last));
    end = static_cast<int>(std::clamp(std::ceil(high / grid.cell_m) + margin + 1, 0.0, last));
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

/// Presses the samples under the rim and marks them; returns the sum of heights taken.
double Press(HeightGrid& grid, const RimPlace& rim, const SoilLaws& laws, double excavated_m,
             const Window& area, RutScratch& scratch) {
  double taken = 0.0;
  const Window inner = WindowAround(grid, rim, 1);
  for (int iy = inner.y_begin; iy < inner.y_end; ++iy) {
    for (int ix = inner.x_begin; ix < inner.x_end; ++ix) {
      const double x = grid.x0_m + ix * grid.cell_m, y = grid.y0_m + iy * grid.cell_m;
      const RimPoint at = RimAbove(rim, x, y);
      if (!at.over) continue;
      const std::size_t index = static_cast<std::size_t>(iy) * grid.nx + ix;
      const double gap = grid.heights_m[index] - at.z_m;
      if (gap <= 0.0) continue;
      scratch.under_wheel[static_cast<std::size_t>(iy - area.y_begin) * area.width() +
                          (ix - area.x_begin)] = 1;
      const double sinkage = grid.undisturbed_m[index] - at.z_m;
      // A heap above the soil as it was carries nothing: the wheel ploughs through it.
      const double yield = YieldPressure(laws, sinkage - excavated_m);
      const double sunk = gap - yield / laws.elastic_pa_per_m;
      if (sunk <= 0.0) continue;
      grid.heights_m[index] -= sunk;
      taken += sunk;
      HeapBeside(grid, rim, x, y, at.axial_m, sunk);
    }
  }
  return taken;
}

/// Soil slides down between neighbours that differ by more than the slope allows, all at once, so
/// that the order of the samples does not matter.
void Slump(HeightGrid& grid, const Window& area, double tan_phi, RutScratch& scratch) {
  const double steepest = tan_phi * grid.cell_m;
  std::fill(scratch.change_m.begin(), scratch.change_m.end(), 0.0);
  const auto flow = [&](std::size_t here, std::size_t there, std::size_t g_here,
                        std::size_t g_there) {
    if (scratch.under_wheel[here] != 0 || scratch.under_wheel[there] != 0) return;
    const double step = grid.heights_m[g_here] - grid.heights_m[g_there];
    const double excess = std::fabs(step) - steepest;
    if (excess <= 0.0) return;
    const double moved = std::copysign(kSlumpShare * excess, step);
    scratch.change_m[here] -= moved;
    scratch.change_m[there] += moved;
  };
  const std::size_t width = static_cast<std::size_t>(area.width());
  for (int iy = 0; iy < area.height(); ++iy) {
    for (int ix = 0; ix < area.width(); ++ix) {
      const std::size_t here = iy * width + ix;
      const std::size_t g_here =
          static_cast<std::size_t>(area.y_begin + iy) * grid.nx + area.x_begin + ix;
      if (ix + 1 < area.width()) flow(here, here + 1, g_here, g_here + 1);
      if (iy + 1 < area.height()) flow(here, here + width, g_here, g_here + grid.nx);
    }
  }
  for (int iy = 0; iy < area.height(); ++iy) {
    for (int ix = 0; ix < area.width(); ++ix) {
      const double change = scratch.change_m[iy * width + ix];
      const std::size_t index =
          static_cast<std::size_t>(area.y_begin + iy) * grid.nx + area.x_begin + ix;
      grid.heights_m[index] += change;
    }
  }
}

}  // namespace

double PressRut(HeightGrid& grid, const RimPlace& rim, const SoilLaws& laws, double excavated_m,
                RutScratch& scratch) {
  const Window area = WindowAround(grid, rim, kSlumpMargin);
  const std::size_t samples = static_cast<std::size_t>(area.width()) * area.height();
  if (samples == 0) return 0.0;
  scratch.under_wheel.assign(samples, 0);
  scratch.change_m.resize(samples);
  const double taken = Press(grid, rim, laws, excavated_m, area, scratch);
  if (taken <= 0.0) return 0.0;
  Slump(grid, area, laws.tan_phi, scratch);
  ++grid.revision;
  return taken * grid.cell_m * grid.cell_m;
}

}  // namespace dockyard
