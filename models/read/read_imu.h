// The mapping `imu` of a robot's file.
#pragma once

#include "models/parts/imu.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

/// Reads `imu`. Throws ConfigError.
ImuModel ReadImu(const YamlReader& root);

}  // namespace dockyard
