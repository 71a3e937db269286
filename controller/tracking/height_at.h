// The height at a place of a map.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/stereo/elevation.h"

namespace dockyard {

/// Height and variance at a place of the map; none where a cell next to it is empty.
struct HeightAt {
  double height_m = 0.0, variance_m2 = 0.0;
};
std::optional<HeightAt> Bilinear(const ElevationMap& map, const Eigen::Vector2d& p_E);

}  // namespace dockyard
