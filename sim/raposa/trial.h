// The testbed's proof of a docking: the robot drives away and turns, and the guide must follow.
#pragma once

#include <functional>

#include "sim/raposa/outcome.h"
#include "sim/raposa/world.h"

namespace dockyard::raposa {

/// Drives the robot away at 0.05 m/s (assumed, 0.03-0.1) by the limits' way and turns it by their
/// angle, arm and doors as `last` commands them. The world keeps the changes. `watch` sees the
/// truth every control period.
Trial TryToDriveAway(World& world, const RobotModel& robot, const OutcomeLimits& limits,
                     const Commands& last, const std::function<void(const Truth&)>& watch);

}  // namespace dockyard::raposa
