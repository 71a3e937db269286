// The keys of a scenario under `sun`.
#pragma once

#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// light: of the scenario, read before.
void VisitSun(Keys& keys, Light light, SunModel& sun);

}  // namespace dockyard
