// A robot's file -> RobotModel.
#pragma once

#include <string>

#include "models/custom/robot_model.h"
#include "models/read/as_built.h"
#include "models/read/keys.h"
#include "models/read/mesh_loader.h"

namespace dockyard::custom {

/// The end of a message about what a robot's or a dock's file cannot have.
inline constexpr const char* kGoOn =
    "docs/reference/custom.md lists what files of robots and docks have";

/// `changes` are keys on top of the file's. Throws ConfigError.
RobotModel LoadRobot(const std::string& file, const ModelChanges& changes = {},
                     MeshStore* meshes = nullptr);
/// Names every key of a robot's file.
void VisitRobotKeys(Keys& keys);
/// Whether the root has a robot's keys.
bool IsRobotFile(const YamlNode& root);

}  // namespace dockyard::custom
