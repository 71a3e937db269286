// The live ground of the yard: heights on a regular grid in the site frame G, ruts included.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dockyard {

struct HeightGrid {
  double x0_m = 0.0, y0_m = 0.0;  // of sample (0, 0)
  double cell_m = 0.0;
  int nx = 0, ny = 0;
  std::vector<double> heights_m;  // [iy * nx + ix]
  std::uint64_t revision = 0;     // counts write-backs
  /// The soil as it was before any wheel, same layout: ruts lie below it, heaps above it. Empty
  /// until the first wheel, which takes the heights as they are.
  std::vector<double> undisturbed_m;

  /// Bilinear height; outside the grid, the height of the nearest border point.
  double Height(double x_m, double y_m) const;
  /// Upward unit normal of the bilinear surface.
  Eigen::Vector3d Normal(double x_m, double y_m) const;
};

/// The cell that holds a point (the nearest border point, outside) and the place in it, 0..1.
struct GridCell {
  int ix = 0, iy = 0;  // of the cell's lower corner
  double u = 0.0, v = 0.0;
};

inline GridCell CellAt(const HeightGrid& grid, double x_m, double y_m) {
  const auto locate = [](double at, int samples, int& index) {
    const double last = samples - 1;
    const double inside = at > 0.0 ? (at < last ? at : last) : 0.0;
    index = static_cast<int>(inside);
    if (index > samples - 2) index = samples - 2;
    return inside - index;
  };
  GridCell cell;
  cell.u = locate((x_m - grid.x0_m) / grid.cell_m, grid.nx, cell.ix);
  cell.v = locate((y_m - grid.y0_m) / grid.cell_m, grid.ny, cell.iy);
  return cell;
}

/// Bilinear value of a field laid out like the grid's heights.
inline double Interpolate(const HeightGrid& grid, const std::vector<double>& field,
                          const GridCell& cell) {
  const double* low = field.data() + static_cast<std::ptrdiff_t>(cell.iy) * grid.nx + cell.ix;
  const double* high = low + grid.nx;
  const double at_low = low[0] + cell.u * (low[1] - low[0]);
  const double at_high = high[0] + cell.u * (high[1] - high[0]);
  return at_low + cell.v * (at_high - at_low);
}

/// A level grid that covers [x0, x0 + length] x [-width/2, width/2].
HeightGrid LevelGrid(double x0_m, double length_m, double width_m, double cell_m);

/// Adds a gentle, band-limited undulation: a sum of plane waves with random directions and phases,
/// zero height and slope at the dock's feet (weight grows smoothly from flat_radius_m outwards).
void AddUndulation(HeightGrid& grid, double rms_m, double wavelength_m, double flat_radius_m,
                   std::uint64_t seed);

}  // namespace dockyard
