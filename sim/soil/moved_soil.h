// Soil that a tool carries aside on the height grid, and slopes that slump. Both keep its volume.
#pragma once

#include <Eigen/Core>
#include <span>

#include "sim/soil/height_grid.h"

namespace dockyard {

/// To about a place of the plan, or away from it where the volume is negative. Takes the heights as
/// undisturbed if nothing was there before.
void AddSoil(HeightGrid& grid, const Eigen::Vector2d& at, double volume_m3);

/// From about one place of the plan to about another. Takes the heights as undisturbed if nothing
/// was there before.
void MoveSoil(HeightGrid& grid, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
              double volume_m3);

/// The circle of the plan that a round plate covers.
struct RoundArea {
  Eigen::Vector2d centre{0, 0};
  double radius_m = 0.0;
};

/// Whether a plate lies on a sample: those in its circle, and all around its centre, so that a
/// plate smaller than a cell has samples, too.
bool LiesOn(const HeightGrid& grid, const RoundArea& plate, int ix, int iy);

/// A square of the plan, the friction of its soil, and plates that hold down what is under them.
struct LooseSlope {
  Eigen::Vector2d centre{0, 0};
  double half_m = 0.0, friction = 0.0;
  std::span<const RoundArea> held{};
};

/// Passes over the square: of what a slope between neighbours is too steep, a quarter slides. True:
/// it has come to rest, no slope being too steep by more than 10 um. Soil under a plate does not
/// slide.
bool Slump(HeightGrid& grid, const LooseSlope& slope, int most_passes);

/// The surface that bears: holes count, heaps of loose soil do not.
double BearingHeight(const HeightGrid& grid, double x_m, double y_m);

}  // namespace dockyard
