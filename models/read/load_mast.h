// The mast in a rover's file.
#pragma once

#include <string>

#include "models/parts/mast_model.h"
#include "models/read/yaml_tree.h"

namespace dockyard {

/// Reads the mapping. Throws ConfigError.
MastModel ReadMast(const YamlNode& node, const std::string& path);

}  // namespace dockyard
