// The taut tether's path from the arm's tip to the anchor: the shortest path round the edges of the
// cone's throat and lip. Throat and lip are circles about the cone's axis and the anchor lies on
// the axis, so the path lies in the plane through the axis and the tip.
#pragma once

#include <Eigen/Core>
#include <array>

#include "models/axel/station_model.h"

namespace dockyard::axel {

/// Where the tether can bend, from the tip inwards.
enum class Bend { kLip, kThroat };
inline constexpr int kBendCount = 2;

/// A path of up to three straight pieces, arm's tip first.
struct TetherPath {
  std::array<bool, kBendCount> bent{};  // by Bend: whether the tether touches that edge
  int pieces = 1;
  std::array<Eigen::Vector2d, kBendCount + 2> nodes;  // (x along the axis, distance from it) in M
  std::array<double, kBendCount + 1> length_m{};      // by piece
  std::array<double, kBendCount> turn_rad{};          // at nodes[i + 1], >= 0

  double total_m() const;
};

/// tip: (x out of the mouth, distance from the axis >= 0), frame M.
TetherPath FindTetherPath(const ConeModel& cone, double anchor_depth_m, const Eigen::Vector2d& tip);

}  // namespace dockyard::axel
