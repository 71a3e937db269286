// models/rocky7/rocky7.yaml -> RobotModel.
#pragma once

#include <string>

#include "models/read/as_built.h"
#include "models/read/keys.h"
#include "models/rocky7/robot_model.h"

namespace dockyard::rocky7 {

/// Names every key of the file.
void VisitRobotKeys(Keys& keys);

/// Throws ConfigError.
RobotModel LoadRobot(const std::string& file, const ModelChanges& changes = {});

}  // namespace dockyard::rocky7
