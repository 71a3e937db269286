// RAPOSA's own controller: no colour bands, no dead zone, odometry fused with sightings, doors that
// feel the guide.
#pragma once

#include <memory>

#include "controller/io/controller.h"
#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// Called every kControlPeriod; asks for a picture of the back camera each time. Its belief has the
/// pilot's phase, the robot's pose R in D, and these values: "state" (the phase's number),
/// "alpha_deg", "r_m", "passes" and "gauge_share" (pyramid_filter.h).
std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal);

}  // namespace dockyard::raposa
