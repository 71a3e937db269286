// A rover on wheels, from YAML: models/rovers.
#pragma once

#include <string>

#include "models/parts/rover_model.h"

namespace dockyard {

/// The rover in plan. The fixed wheels must stand about x = 0, on whose line the centres of turns
/// lie. Throws ConfigError.
RoverPlan LoadRoverPlan(const std::string& file);

/// The same with what the file's mapping `build` says of masses, suspension and motors.
RoverModel LoadRover(const std::string& file);

}  // namespace dockyard
