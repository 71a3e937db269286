// Dotted keys ("start.r_m") in a tree of YAML.
#pragma once

#include <string_view>

#include "models/read/yaml_tree.h"

namespace dockyard {

/// The value under a dotted key, or null.
const YamlNode* FindPath(const YamlNode& tree, std::string_view path);
YamlNode* FindPath(YamlNode& tree, std::string_view path);

}  // namespace dockyard
