// Heights about a place, taken out of a map.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/geometry/pose.h"
#include "controller/stereo/elevation.h"

namespace dockyard {

/// Height and variance at a place of the map; none where a cell beside it is empty.
struct HeightAt {
  double height_m = 0.0, variance_m2 = 0.0;
};
std::optional<HeightAt> Bilinear(const ElevationMap& map, const Eigen::Vector2d& p_E);

/// Cells on a square about frame T: its origin is the target.
struct HeightPatch {
  struct Cell {
    Eigen::Vector2d p_T{0, 0};
    double height_m = 0.0, variance_m2 = 0.0;
  };
  std::vector<Cell> cells;  // those that are known
  int places = 0;           // known or not

  /// How much the heights differ from a plane: root of the mean square beyond what their variances
  /// explain [m].
  double Relief() const;
};

/// The square of side 2 half_m about the pose X_ET, every step_m.
HeightPatch PatchOf(const ElevationMap& map, const Pose2& X_ET, double half_m, double step_m);

/// a + b x + c y through the cells by least squares, weighted by their variances. Needs three.
Eigen::Vector3d PlaneThrough(const std::vector<HeightPatch::Cell>& cells);

}  // namespace dockyard
