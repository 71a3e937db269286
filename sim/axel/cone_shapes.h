// Shapes of the docking cone and of the arm that enters it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"

namespace dockyard::axel {

/// The cone and its face as a block without a hole, in the mouth frame M: what wheels and body
/// meet.
Collision ConeBlock(const ConeModel& cone);

/// The arm's shapes: the flat-nosed tip cylinder of ArmTipModel, the collar of CollarModel, and the
/// collisions of the arm's link except those of the same tip and collar.
std::vector<Collision> ArmCollisions(const RoverModel& rover);

}  // namespace dockyard::axel
