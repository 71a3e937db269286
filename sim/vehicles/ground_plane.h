// The ground's height and normal at many places in one step, read together and without a division
// per place. Lives as long as its grid keeps its samples.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

#include "sim/soil/height_grid.h"

namespace dockyard {

/// The bilinear surface at one place.
struct GroundSpot {
  double height_m = 0.0;
  double rise_x = 0.0, rise_y = 0.0;  // slopes

  /// Upward unit normal, as HeightGrid::Normal.
  Eigen::Vector3d Normal() const {
    if (rise_x == 0.0 && rise_y == 0.0) return Eigen::Vector3d::UnitZ();
    const double up = 1.0 / std::sqrt(1.0 + rise_x * rise_x + rise_y * rise_y);
    return {-rise_x * up, -rise_y * up, up};
  }
};

class GroundPlane {
 public:
  explicit GroundPlane(const HeightGrid& grid) : grid_(grid), per_cell_(1.0 / grid.cell_m) {}

  GroundSpot At(double x_m, double y_m) const {
    const GridCell at =
        CellAtCells(grid_, (x_m - grid_.x0_m) * per_cell_, (y_m - grid_.y0_m) * per_cell_);
    const double* low =
        grid_.heights_m.data() + static_cast<std::ptrdiff_t>(at.iy) * grid_.nx + at.ix;
    const double* high = low + grid_.nx;
    const double along_low = low[1] - low[0], along_high = high[1] - high[0];
    const double at_low = low[0] + at.u * along_low, at_high = high[0] + at.u * along_high;
    return {at_low + at.v * (at_high - at_low),
            (along_low + at.v * (along_high - along_low)) * per_cell_,
            (at_high - at_low) * per_cell_};
  }

 private:
  const HeightGrid& grid_;
  double per_cell_;
};

}  // namespace dockyard
