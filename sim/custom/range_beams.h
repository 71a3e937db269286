// One-beam range finders: how far it is to the dock's solids or to the ground.
#pragma once

#include "models/custom/robot_model.h"
#include "sim/custom/tree_in_world.h"
#include "sim/soil/height_grid.h"

namespace dockyard::custom {

/// Along x of F, without noise; most_m where there is nothing within, or something nearer than
/// least_m. solids: of the tree.
double BeamLength(const RangeFinder& finder, const Pose3& X_GF,
                  const std::vector<LinkSolid>& solids, const TreeInWorld& tree,
                  const RigidWorld& world, const HeightGrid& ground);

}  // namespace dockyard::custom
