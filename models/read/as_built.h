// A model's tree of keys with changes: those that the controller is told of, and those that it is
// not.
#pragma once

#include <string>

#include "models/read/yaml_tree.h"

namespace dockyard {

/// Keys on top of a model's file.
struct ModelChanges {
  const YamlNode* nominal = nullptr;  // changes of the nominal values
  const YamlNode* built = nullptr;    // on top of that, what is built otherwise than told
};

/// Puts `built` on top of the tree of what is told, mappings key by key. {times: a, plus: b} on a
/// number of the tree makes it a times itself plus b; either may be left out. Anything else
/// replaces. `path` is the tree's own dotted path, empty for a whole model. Throws ConfigError.
void PutBuilt(YamlNode& tree, const YamlNode& built, const std::string& path = {});

/// Gives the dotted key this number unless the tree has it: one that a file may leave out.
void PutIfLeftOut(YamlNode& tree, const std::string& path, double value);

}  // namespace dockyard
