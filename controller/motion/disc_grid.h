// Many discs sorted into cells, so that a path is compared with those near it alone.
#pragma once

#include <cstddef>
#include <vector>

#include "controller/geometry/rover_plan.h"
#include "controller/motion/arcs.h"

namespace dockyard {

/// From R to the farthest point of its rover, its wheels steered anyhow [m].
double ReachOf(const RoverPlan& rover);

class DiscGrid {
 public:
  explicit DiscGrid(std::vector<Disc> discs);

  /// At least those that come within reach_m of R on the path, in the order in which they were
  /// given. So a search for what is near finds the same, bit for bit, among them and among all.
  std::vector<Disc> Near(const std::vector<Arc>& path, double reach_m) const;

 private:
  struct Cells {
    int low_x = 0, low_y = 0, high_x = 0, high_y = 0;  // both included
  };
  Cells CellsAround(const Eigen::Vector2d& middle, double half_m) const;

  std::vector<Disc> discs_;
  std::vector<std::size_t> wide_;  // discs over many cells: near to every path
  Eigen::Vector2d low_{0, 0};
  double cell_m_ = 1.0;
  int nx_ = 0, ny_ = 0;
  std::vector<std::vector<std::size_t>> cells_;  // discs whose box touches the cell
};

}  // namespace dockyard
