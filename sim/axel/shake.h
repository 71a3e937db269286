// The testbed's proof of a docking: spool braked, the rover turns to and fro, then drives away.
#pragma once

#include <functional>

#include "sim/axel/outcome.h"
#include "sim/axel/world.h"

namespace dockyard::axel {

/// Shakes the rover in the world and returns how far it and the station moved. Wheels turn it 11
/// deg to and fro at 0.1 rad/s, then both drive away at 0.1 m/s for 2 s. The world keeps the
/// changes. `watch` sees the truth every control period. `station`: as built.
ShakeResult Shake(World& world, const RoverModel& rover, const StationModel& station,
                  const std::function<void(const Truth&)>& watch = {});

}  // namespace dockyard::axel
