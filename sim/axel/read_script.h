// A scenario's `script`, open-loop commands for Axel, from YAML.
#pragma once

#include <vector>

#include "controller/axel/nominal/script.h"
#include "models/read/yaml_tree.h"

namespace dockyard::axel {

/// Throws ConfigError.
std::vector<ScriptStep> ReadScript(const YamlNode& list);

}  // namespace dockyard::axel
