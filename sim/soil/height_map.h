// Measured or made heights in a frame of their own, and their place in the yard.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// Row by row from the top left. M: the map's middle, x along the rows, y up the columns.
struct HeightMap {
  int columns = 0, rows = 0;
  double cell_m = 0.0;
  std::vector<float> heights_m;  // NaN: not known
  Pose2 X_GM;

  /// Bilinear; beyond the border that of the nearest border point.
  double Height(const Eigen::Vector2d& p_G) const;
};

/// Adds the map's heights over that at the site's origin: none within the radius about it, in full
/// from twice the radius on.
void AddHeights(HeightGrid& grid, const HeightMap& map, double flat_radius_m);

}  // namespace dockyard
