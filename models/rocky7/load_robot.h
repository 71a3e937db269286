// models/rocky7/rocky7.yaml -> RobotModel.
#pragma once

#include <string>

#include "models/read/as_built.h"
#include "models/rocky7/robot_model.h"

namespace dockyard::rocky7 {

/// Throws ConfigError.
RobotModel LoadRobot(const std::string& file, const ModelChanges& changes = {});

}  // namespace dockyard::rocky7
