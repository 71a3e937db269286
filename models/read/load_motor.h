// A motor's mapping in a robot's file -> MotorModel.
#pragma once

#include <string>

#include "models/parts/motor.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

/// Reads one motor. `path`: dotted, of the mapping itself, for messages. Throws ConfigError.
MotorModel ReadMotor(const YamlNode& node, const std::string& path);

}  // namespace dockyard
