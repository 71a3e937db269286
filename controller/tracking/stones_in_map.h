// Stones of a map, before anyone asks which of them is meant: what stands out of the ground, one
// top for each.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/tracking/stone_middle.h"

namespace dockyard {

struct MapCell {
  Eigen::Vector2d p_E{0, 0};
  double height_m = 0.0, sigma_m = 0.0;
};

/// Known cells within a circle.
std::vector<MapCell> CellsAbout(const ElevationMap& map, const Eigen::Vector2d& p_E,
                                double radius_m);

enum class GroundShape { kLevel, kCurved };  // a plane, or one that bends with the squares

struct GroundFit {
  Eigen::Vector2d middle{0, 0};
  // 1, x, y, x^2, x y, y^2 from the middle.
  Eigen::Matrix<double, 6, 1> terms = Eigen::Matrix<double, 6, 1>::Zero();
  double sigma_m = 0.0;  // of the ground's cells about it

  double Height(const Eigen::Vector2d& p_E) const;
};

/// By least absolute deviations, then without what stands out: half of the cells cannot mislead it.
GroundFit FitGround(const std::vector<MapCell>& cells, const Eigen::Vector2d& middle,
                    GroundShape shape);

struct StoneTop {
  Eigen::Vector2d p_E{0, 0};
  double top_m = 0.0;  // above the ground
  double half_length_m = 0.0, half_width_m = 0.0;
  std::optional<double> heading_rad;
  double nearest_m = 0.0;  // of its cells from the circle's middle
  bool cut = false;        // by the border of what was looked at
};

/// What stands out of the ground within the circle.
std::vector<StoneTop> TopsAbout(const std::vector<MapCell>& cells, const GroundFit& ground,
                                const Eigen::Vector2d& p_E, double radius_m,
                                const StoneMiddleSettings& with);

}  // namespace dockyard
