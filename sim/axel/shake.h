// The testbed's own proof of a docking: with the spool braked, turn to and fro, then drive away.
#pragma once

#include "sim/axel/axel_judge.h"
#include "sim/axel/world.h"

namespace dockyard::axel {

/// Shakes the rover in the world and returns how far it gave. Wheels turn it 11 deg to and fro at
/// 0.1 rad/s, then both drive away at 0.1 m/s for 2 s. The world is not the same afterwards.
ShakeResult Shake(World& world, const RoverModel& rover);

}  // namespace dockyard::axel
