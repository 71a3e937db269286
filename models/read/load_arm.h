// An arm with scoops, from a mapping of a rover's file.
#pragma once

#include <string>

#include "models/parts/arm_model.h"
#include "models/read/yaml_tree.h"

namespace dockyard {

/// `path`: of the mapping in its file. Throws ConfigError.
ArmModel ReadArm(const YamlNode& node, const std::string& path);

}  // namespace dockyard
