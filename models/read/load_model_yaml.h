// A model's file on top of another one.
#pragma once

#include <string>

#include "models/read/yaml_tree.h"

namespace dockyard {

/// The tree of a model's file. With the key `base`, the name of a file beside it, the tree is that
/// file's with this file's keys on top, mappings key by key; the base may have a base itself.
/// Throws ConfigError, also when bases lead back to the file or are more than five.
YamlNode LoadModelYaml(const std::string& file);

}  // namespace dockyard
