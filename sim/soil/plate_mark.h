// The mark of a flat plate that presses into soil or is dragged through it, on the height grid.
#pragma once

#include <Eigen/Core>

#include "sim/soil/height_grid.h"
#include "sim/soil/moved_soil.h"

namespace dockyard {

/// The soil as it was takes the heights as they are, if nothing has changed them before.
void KeepUndisturbed(HeightGrid& grid);

/// The ground below a place as it was before any mark. Needs KeepUndisturbed.
struct UndisturbedAt {
  double height_m = 0.0;
  double sunk_m = 0.0;  // of the ground below that height; below zero on a heap
  Eigen::Vector3d normal_G{0, 0, 1};
};
UndisturbedAt FindUndisturbed(const HeightGrid& grid, const Eigen::Vector2d& at);

/// Presses what is higher under the plate down to sunk_m below the soil as it was. The plate lies
/// along that soil. Returns the volume that it displaces [m^3], which the caller heaps.
double PressMark(HeightGrid& grid, const RoundArea& plate, double sunk_m);

/// Heaps soil about a plate. `towards`: the direction in which the plate pushes, of length 0 to 1.
/// At 0 the soil goes to all sides alike; at 1 the share ahead is twice that of a side, and none
/// goes behind.
void HeapAround(HeightGrid& grid, const RoundArea& plate, const Eigen::Vector2d& towards,
                double volume_m3);

}  // namespace dockyard
