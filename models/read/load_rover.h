// A rover on wheels, from YAML: models/rovers.
#pragma once

#include <string>
#include <vector>

#include "models/parts/rover_model.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

/// The rover in plan. The fixed wheels must stand about x = 0, on whose line the centres of turns
/// lie. Throws ConfigError.
RoverPlan LoadRoverPlan(const std::string& file);

/// The same with what the file's mapping `build` says of masses, suspension and motors.
RoverModel LoadRover(const std::string& file);

/// The same from a tree whose root may have further keys, which its reader must know: RoverKeys and
/// `more`.
RoverModel ReadRover(const YamlReader& in);
std::vector<std::string> RoverKeys(const std::vector<std::string>& more);

}  // namespace dockyard
