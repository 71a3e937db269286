#include "sim/soil/height_grid.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"
#include "sim/base/random.h"

namespace dockyard {

double HeightGrid::Height(double x_m, double y_m) const {
  return Interpolate(*this, heights_m, CellAt(*this, x_m, y_m));
}

std::size_t HeightGrid::SoilAt(double x_m, double y_m) const {
  if (soils.empty()) return 0;
  const GridCell at = CellAt(*this, x_m, y_m);
  const int ix = at.ix + (at.u > 0.5 ? 1 : 0), iy = at.iy + (at.v > 0.5 ? 1 : 0);
  return soils[static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(ix)];
}

Eigen::Vector3d HeightGrid::Normal(double x_m, double y_m) const {
  const GridCell at = CellAt(*this, x_m, y_m);
  const double* low = heights_m.data() + static_cast<std::ptrdiff_t>(at.iy) * nx + at.ix;
  const double* high = low + nx;
  const double slope_x = ((1.0 - at.v) * (low[1] - low[0]) + at.v * (high[1] - high[0])) / cell_m;
  const double slope_y = ((1.0 - at.u) * (high[0] - low[0]) + at.u * (high[1] - low[1])) / cell_m;
  return Eigen::Vector3d(-slope_x, -slope_y, 1.0).normalized();
}

HeightGrid LevelGrid(double x0_m, double length_m, double width_m, double cell_m) {
  DOCKYARD_CHECK(cell_m > 0.0 && length_m >= cell_m && width_m >= cell_m);
  HeightGrid grid;
  grid.cell_m = cell_m;
  // Enough cells to cover the extent; the grid stays symmetric about y = 0.
  grid.nx = static_cast<int>(std::ceil(length_m / cell_m - 1e-9)) + 1;
  grid.ny = static_cast<int>(std::ceil(width_m / cell_m - 1e-9)) + 1;
  grid.x0_m = x0_m;
  grid.y0_m = -0.5 * (grid.ny - 1) * cell_m;
  grid.heights_m.assign(static_cast<std::size_t>(grid.nx) * grid.ny, 0.0);
  return grid;
}

namespace {

struct Wave {
  double kx = 0.0, ky = 0.0, phase = 0.0;  // [rad/m], [rad/m], [rad]
};

std::vector<Wave> DrawWaves(double wavelength_m, std::uint64_t seed) {
  // Enough waves for nearly Gaussian heights; lengths within a third of an octave each way keep the
  // band narrow.
  constexpr int kWaves = 24;
  RandomStream random(StreamKey(seed, "undulation"));
  std::vector<Wave> waves(kWaves);
  for (Wave& wave : waves) {
    const double direction = random.Uniform(-kPi, kPi);
    const double number = 2.0 * kPi / (wavelength_m * std::exp2(random.Uniform(-0.33, 0.33)));
    wave = {number * std::cos(direction), number * std::sin(direction), random.Uniform(-kPi, kPi)};
  }
  return waves;
}

}  // namespace

double ReliefWeight(double distance_m, double flat_radius_m) {
  if (flat_radius_m <= 0.0) return 1.0;
  const double t = std::clamp(distance_m / flat_radius_m - 1.0, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

void AddUndulation(HeightGrid& grid, double rms_m, double wavelength_m, double flat_radius_m,
                   std::uint64_t seed) {
  DOCKYARD_CHECK(rms_m >= 0.0 && wavelength_m > 0.0);
  if (rms_m == 0.0) return;
  const std::vector<Wave> waves = DrawWaves(wavelength_m, seed);
  const double amplitude = rms_m * std::sqrt(2.0 / static_cast<double>(waves.size()));
  // cos(a + b) from the cosines and sines of a column's and a row's angle.
  const std::size_t nx = static_cast<std::size_t>(grid.nx);
  std::vector<double> cos_x(waves.size() * nx), sin_x(waves.size() * nx), heights(nx);
  for (std::size_t w = 0; w < waves.size(); ++w) {
    for (std::size_t ix = 0; ix < nx; ++ix) {
      const double angle = waves[w].kx * (grid.x0_m + static_cast<double>(ix) * grid.cell_m);
      cos_x[w * nx + ix] = std::cos(angle);
      sin_x[w * nx + ix] = std::sin(angle);
    }
  }
  for (int iy = 0; iy < grid.ny; ++iy) {
    const double y = grid.y0_m + iy * grid.cell_m;
    std::fill(heights.begin(), heights.end(), 0.0);
    for (std::size_t w = 0; w < waves.size(); ++w) {
      const double angle = waves[w].ky * y + waves[w].phase;
      const double c = std::cos(angle), s = std::sin(angle);
      const double *cx = cos_x.data() + w * nx, *sx = sin_x.data() + w * nx;
      for (std::size_t ix = 0; ix < nx; ++ix) heights[ix] += cx[ix] * c - sx[ix] * s;
    }
    for (std::size_t ix = 0; ix < nx; ++ix) {
      const double x = grid.x0_m + static_cast<double>(ix) * grid.cell_m;
      const double height = heights[ix] * amplitude * ReliefWeight(std::hypot(x, y), flat_radius_m);
      const std::size_t index = static_cast<std::size_t>(iy) * nx + ix;
      grid.heights_m[index] += height;
      if (!grid.undisturbed_m.empty()) grid.undisturbed_m[index] += height;
    }
  }
}

}  // namespace dockyard
