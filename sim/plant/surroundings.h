// A room and an outdoor scene as lists of solids, drawn by a seed: the background of a robot's
// images. Frame D: the target's, x the direction that it faces.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/scenario/scenery.h"

namespace dockyard {

/// A rectangular room with walls, doors, skirting, tables, cupboards, joints of its floor, and
/// loose things: bags, cartons, bins and balls. These keep clear of the target, the start, the line
/// between and the first metre before the target; fewer where there is no room.
/// @param room     its place, size, count of loose things and the distance that these keep
/// @param start_D  where the robot starts
/// @param stream   of this room alone
std::vector<SceneryItem> DrawRoom(const SceneryItem& room, const Eigen::Vector2d& start_D,
                                  std::uint64_t stream);

/// Trees, hedges, a house, a kerb, a car and posts from the radius on; tufts, stones and leaves
/// within it, which keep clear as a room's things do.
std::vector<SceneryItem> DrawOutdoors(const SceneryItem& outdoors, const Eigen::Vector2d& start_D,
                                      std::uint64_t stream);

}  // namespace dockyard
