// The live ground of the yard: heights on a regular grid in the site frame G, ruts included.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace dockyard {

struct HeightGrid {
  double x0_m = 0.0, y0_m = 0.0;  // of sample (0, 0)
  double cell_m = 0.0;
  int nx = 0, ny = 0;
  std::vector<double> heights_m;  // [iy * nx + ix]
  std::uint64_t revision = 0;     // counts write-backs

  /// Bilinear height; outside the grid, the height of the nearest border point.
  double Height(double x_m, double y_m) const;
  /// Upward unit normal of the bilinear surface.
  Eigen::Vector3d Normal(double x_m, double y_m) const;
};

/// A level grid that covers [x0, x0 + length] x [-width/2, width/2].
HeightGrid LevelGrid(double x0_m, double length_m, double width_m, double cell_m);

/// Adds a gentle, band-limited undulation: a sum of plane waves with random directions and phases,
/// zero height and slope at the dock's feet (weight grows smoothly from flat_radius_m outwards).
void AddUndulation(HeightGrid& grid, double rms_m, double wavelength_m, double flat_radius_m,
                   std::uint64_t seed);

}  // namespace dockyard
