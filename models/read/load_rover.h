// A rover on wheels, from YAML: models/rovers.
#pragma once

#include <string>

#include "models/parts/rover_model.h"
#include "models/read/keys.h"

namespace dockyard {

/// The rover in plan. The fixed wheels must stand about x = 0, on whose line the centres of turns
/// lie. Throws ConfigError.
RoverPlan LoadRoverPlan(const std::string& file);

/// The same with what the file's mapping `build` says of masses, suspension and motors.
RoverModel LoadRover(const std::string& file);

/// Names every key of a rover's file.
void VisitRover(Keys& keys, RoverModel& rover);
/// The same as LoadRover from a tree. `visit` visits this rover, and maybe further keys.
void ReadRover(const YamlNode& root, const Keys::Visit& visit, RoverModel& rover);

}  // namespace dockyard
