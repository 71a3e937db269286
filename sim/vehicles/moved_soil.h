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

/// One pass over a square: of what a slope between neighbours is too steep for this friction, a
/// quarter slides.
void SlumpWithin(HeightGrid& grid, const Eigen::Vector2d& centre, double half_m, double friction);

/// The surface that bears: holes count, heaps of loose soil do not.
double BearingHeight(const HeightGrid& grid, double x_m, double y_m);

}  // namespace dockyard
