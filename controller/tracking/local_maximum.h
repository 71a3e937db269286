// The tracker of Nesnas, Maimone and Das (ICRA 2000), section IV: the highest cell in a window
// about where odometry puts the target.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/stereo/elevation.h"

namespace dockyard {

struct LocalMaximumSettings {
  double window_m = 0.06;  // half the window's side; assumed, 0.03-0.12: "a small window"
};

struct TrackedTop {
  Eigen::Vector2d p_E{0, 0};
  double height_m = 0.0;
  bool filled = false;  // the cell was empty; its height is an interpolation
};

/// The window's highest cell. Empty cells get the mean of the straight lines along their row and
/// their column between the nearest known cells in the window. None where no cell is known. It has
/// no way to tell that the target is gone: that is the paper's.
std::optional<TrackedTop> HighestInWindow(const ElevationMap& map, const Eigen::Vector2d& p_E,
                                          const LocalMaximumSettings& settings);

}  // namespace dockyard
