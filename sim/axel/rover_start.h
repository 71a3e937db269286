// Where the rover is put down at the start of a run.
#pragma once

#include "sim/axel/world_setup.h"

namespace dockyard::axel {

/// Pose X_GR. Above the ground by the radius of the wheels, its axle along the ground. A wheel
/// above a rock stands on it, and the axle then rolls.
Pose3 RoverStart(const WorldSetup& setup, const HeightGrid& ground);

/// The part of the rover that a rock is in the way of at the start: "arm", "body", or none.
const char* StartsInRock(const WorldSetup& setup);

}  // namespace dockyard::axel
