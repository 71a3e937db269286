// The live ground of the yard: heights on a regular grid in the site frame G, ruts included.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/soil/four.h"

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
  /// Number of each sample's soil, same layout: 0 is the yard's, the others are its patches'.
  /// Empty: all 0.
  std::vector<std::uint8_t> soils{};

  /// Bilinear height; outside the grid, the height of the nearest border point.
  double Height(double x_m, double y_m) const;
  /// Number of the nearest sample's soil.
  std::size_t SoilAt(double x_m, double y_m) const;
  std::size_t SoilAt(const Eigen::Vector3d& p_G) const { return SoilAt(p_G.x(), p_G.y()); }
  /// Upward unit normal of the bilinear surface.
  Eigen::Vector3d Normal(double x_m, double y_m) const;
};

/// The cell that holds a point (the nearest border point, outside) and the place in it, 0..1.
struct GridCell {
  int ix = 0, iy = 0;  // of the cell's lower corner
  double u = 0.0, v = 0.0;
};

/// Of a place counted in cells from sample (0, 0).
inline GridCell CellAtCells(const HeightGrid& grid, double x_cells, double y_cells) {
  const auto locate = [](double at, int samples, int& index) {
    const double last = samples - 1;
    const double inside = at > 0.0 ? (at < last ? at : last) : 0.0;
    index = static_cast<int>(inside);
    if (index > samples - 2) index = samples - 2;
    return inside - index;
  };
  GridCell cell;
  cell.u = locate(x_cells, grid.nx, cell.ix);
  cell.v = locate(y_cells, grid.ny, cell.iy);
  return cell;
}
inline GridCell CellAt(const HeightGrid& grid, double x_m, double y_m) {
  return CellAtCells(grid, (x_m - grid.x0_m) / grid.cell_m, (y_m - grid.y0_m) / grid.cell_m);
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

/// The fields of the soil below a wheel, read at many places in one step. Lives as long as its grid
/// keeps its samples.
class GroundUnder {
 public:
  explicit GroundUnder(const HeightGrid& grid)
      : x0_m_(grid.x0_m),
        y0_m_(grid.y0_m),
        per_cell_(1.0 / grid.cell_m),
        last_x_(std::nextafter(grid.nx - 1.0, 0.0)),
        last_y_(std::nextafter(grid.ny - 1.0, 0.0)),
        nx_(grid.nx),
        heights_(grid.heights_m.data()),
        undisturbed_(grid.undisturbed_m.data()) {}

  /// Bilinear heights at a point of the plan (of the nearest border point, outside): of the ground
  /// as it is and as it was before any wheel.
  void Read(double x_m, double y_m, double& surface_m, double& undisturbed_m) const {
    const double x = Inside((x_m - x0_m_) * per_cell_, last_x_);
    const double y = Inside((y_m - y0_m_) * per_cell_, last_y_);
    const int ix = static_cast<int>(x), iy = static_cast<int>(y);
    const std::ptrdiff_t low = static_cast<std::ptrdiff_t>(iy) * nx_ + ix;
    surface_m = At(heights_ + low, x - ix, y - iy);
    undisturbed_m = At(undisturbed_ + low, x - ix, y - iy);
  }
  void Read(Four x_m, Four y_m, Four& surface_m, Four& undisturbed_m) const;

 private:
  template <typename Real>
  static Real Inside(Real at, double last) {
    return Max(Min(at, Real(last)), Real(0.0));
  }
  template <typename Real>
  static Real Between(Real a, Real b, Real c, Real d, Real u, Real v) {
    const Real at_low = a + u * (b - a), at_high = c + u * (d - c);
    return at_low + v * (at_high - at_low);
  }
  double At(const double* low, double u, double v) const {
    return Between(low[0], low[1], low[nx_], low[nx_ + 1], u, v);
  }

  double x0_m_, y0_m_, per_cell_;
  double last_x_, last_y_;  // just inside the last cell, so that a point's integer part is its cell
  std::ptrdiff_t nx_;
  const double *heights_, *undisturbed_;
};

inline void GroundUnder::Read(Four x_m, Four y_m, Four& surface_m, Four& undisturbed_m) const {
  const Four x = Inside((x_m - x0_m_) * per_cell_, last_x_);
  const Four y = Inside((y_m - y0_m_) * per_cell_, last_y_);
  const auto corner = [&](int i, double& u, double& v) {
    const int ix = static_cast<int>(x[i]), iy = static_cast<int>(y[i]);
    u = ix;
    v = iy;
    return static_cast<std::ptrdiff_t>(iy) * nx_ + ix;
  };
  double ix0, ix1, ix2, ix3, iy0, iy1, iy2, iy3;
  const std::ptrdiff_t i0 = corner(0, ix0, iy0), i1 = corner(1, ix1, iy1), i2 = corner(2, ix2, iy2),
                       i3 = corner(3, ix3, iy3);
  const Four u = x - Four(ix0, ix1, ix2, ix3), v = y - Four(iy0, iy1, iy2, iy3);
  const auto field = [&](const double* f) {
    const auto gather = [&](std::ptrdiff_t to) {
      return Four(f[i0 + to], f[i1 + to], f[i2 + to], f[i3 + to]);
    };
    return Between(gather(0), gather(1), gather(nx_), gather(nx_ + 1), u, v);
  };
  surface_m = field(heights_);
  undisturbed_m = field(undisturbed_);
}

/// A level grid that covers [x0, x0 + length] x [-width/2, width/2].
HeightGrid LevelGrid(double x0_m, double length_m, double width_m, double cell_m);

/// 0 up to the flat radius, 1 from twice that radius on, with zero slope at both ends.
double ReliefWeight(double distance_m, double flat_radius_m);

/// Adds a gentle, band-limited undulation: a sum of plane waves with random directions and phases,
/// zero height and slope at the dock's feet (weight grows smoothly from flat_radius_m outwards).
void AddUndulation(HeightGrid& grid, double rms_m, double wavelength_m, double flat_radius_m,
                   std::uint64_t seed);

}  // namespace dockyard
