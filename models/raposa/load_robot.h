// models/raposa/raposa.yaml and the URDF that it names -> RobotModel.
#pragma once

#include <string>

#include "models/raposa/robot_model.h"
#include "models/read/as_built.h"
#include "models/read/keys.h"
#include "models/read/mesh_loader.h"

namespace dockyard::raposa {

/// Names every key of the file.
void VisitRobotKeys(Keys& keys);

/// The URDF must have the links body (its root), arm, left_door and right_door, an arm_joint about
/// +y and door joints along +y. `changes` are keys on top of the file's. Throws ConfigError.
RobotModel LoadRobot(const std::string& file, const ModelChanges& changes = {},
                     MeshStore* meshes = nullptr);

}  // namespace dockyard::raposa
