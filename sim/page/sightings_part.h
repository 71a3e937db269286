// What the cameras saw in a run that can be watched.
#pragma once

#include "sim/log/logged_run.h"
#include "sim/page/payload.h"

namespace dockyard {

/// x, y [m] and heading [rad]
Json PlanarJson(const Pose2& X);

/// `sightings` of a replay: when the controller took them, what it found, and the images themselves
/// where `pictures` asks for them.
Json SightingsPart(const LoggedRun& run, bool pictures, Payload& payload);

}  // namespace dockyard
