// Where the rover is put down at the start of a run.
#pragma once

#include <string>

#include "sim/axel/world_setup.h"

namespace dockyard::axel {

/// Pose X_GR. Above the ground by the radius of the wheels, its axle along the ground. A wheel
/// above a rock stands on it, and the axle then rolls.
Pose3 RoverStart(const WorldSetup& setup, const HeightGrid& ground);

/// The link of the rover that a rock is in the way of at the start, such as "arm"; empty: none.
std::string StartsInRock(const WorldSetup& setup);

/// A further link whose joint starts beyond its limits, as one that follows another joint may, or
/// that starts in the ground; empty: none. It says so: "'mast' starts beyond its joint's limits".
std::string StartsWrong(const WorldSetup& setup);

/// Two links of the rover that reach into each other at the start, such as "'mast' and 'arm'";
/// empty: none.
std::string StartsInItself(const RoverModel& rover, double arm_start_rad);

}  // namespace dockyard::axel
