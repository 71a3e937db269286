// The groups of wheels of a robot's file -> WheelFit.
#pragma once

#include "models/custom/robot_file.h"
#include "models/read/urdf.h"

namespace dockyard::custom {

/// "file:line:column: list[i].key" of an item's key.
std::string PlaceInList(const YamlReader& in, const char* list, std::size_t i, const char* key);

/// Needs the robot's tree. in: the robot's file, for messages. Throws ConfigError.
void TakeWheels(const YamlReader& in, const UrdfModel& urdf, const RobotFile& file,
                RobotModel& robot);

}  // namespace dockyard::custom
