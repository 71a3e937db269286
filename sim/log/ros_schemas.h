// Definitions of the ROS 2 messages in a run's log, as text (`ros2msg`). Those of ROS itself are as
// in its Jazzy release; the package dockyard_msgs is ours.
#pragma once

#include <string>
#include <vector>

namespace dockyard {

/// The message's fields and, behind lines of 80 `=`, those of all messages in it. A fault of ours
/// for a type that has no definition here. Types are "package/Name".
std::string RosSchema(const std::string& type);

/// "package/msg/Name", as a schema is named.
std::string RosSchemaName(const std::string& type);

}  // namespace dockyard
