// Soil that a tool carries aside on the height grid, and slopes that slump. Both keep its volume.
#pragma once

#include <Eigen/Core>

#include "sim/soil/height_grid.h"

namespace dockyard {

/// To about a place of the plan, or away from it where the volume is negative. Takes the heights as
/// undisturbed if nothing was there before.
void AddSoil(HeightGrid& grid, const Eigen::Vector2d& at, double volume_m3);

/// From about one place of the plan to about another. Takes the heights as undisturbed if nothing
/// was there before.
void MoveSoil(HeightGrid& grid, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
              double volume_m3);

/// A square of the plan and the friction of its soil.
struct LooseSlope {
  Eigen::Vector2d centre{0, 0};
  double half_m = 0.0, friction = 0.0;
};

/// Passes over the square: of what a slope between neighbours is too steep, a quarter slides. True:
/// it has come to rest, no slope being too steep by more than 10 um.
bool Slump(HeightGrid& grid, const LooseSlope& slope, int most_passes);

/// The surface that bears: holes count, heaps of loose soil do not.
double BearingHeight(const HeightGrid& grid, double x_m, double y_m);

}  // namespace dockyard
