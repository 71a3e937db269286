// Shorter spellings that a scenario's file may have, put into the form that all readers know.
#pragma once

#include <vector>

#include "models/read/yaml_tree.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// The tree with `robot: {urdf: U, file: F}` as `robot: F` and `changes: {robot: {urdf: U}}`, and
/// with the keys that a system takes at the root (KnownSystem::root_keys) under the system's name;
/// the same of those that name a model's files. Trees of other shapes stay as they are: their
/// readers refuse them.
YamlNode WithoutShortForms(YamlNode root, const std::vector<KnownSystem>& systems);

}  // namespace dockyard
