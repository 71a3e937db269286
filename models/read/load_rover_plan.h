// A rover in plan, from YAML: models/rovers.
#pragma once

#include <string>

#include "controller/geometry/rover_plan.h"

namespace dockyard {

/// Throws ConfigError. The fixed wheels must stand about x = 0, on whose line the centres of turns
/// lie.
RoverPlan LoadRoverPlan(const std::string& file);

}  // namespace dockyard
