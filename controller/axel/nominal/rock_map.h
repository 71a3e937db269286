// Rocks that the controller is told of.
#pragma once

#include <vector>

namespace dockyard::axel {

/// A rock as a survey gives it: a disc in the dock's frame D that holds it, and its height.
struct MappedRock {
  double x_m = 0.0, y_m = 0.0;
  double radius_m = 0.0;
  double height_m = 0.0;  // above the ground around

  bool operator==(const MappedRock&) const = default;
};

struct RockMap {
  std::vector<MappedRock> rocks;
  double sigma_m = 0.0;  // of each coordinate of a place, as the survey states it

  bool operator==(const RockMap&) const = default;
};

}  // namespace dockyard::axel
