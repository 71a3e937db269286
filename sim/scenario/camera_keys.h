// The keys of a scenario under `camera`: which cameras, and their faults.
#pragma once

#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

void VisitCamera(Keys& keys, Scenario& scenario);

}  // namespace dockyard
