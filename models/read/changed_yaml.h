// A model's file with a scenario's changes on top.
#pragma once

#include <string>

#include "models/read/as_built.h"
#include "models/read/load_model_yaml.h"

namespace dockyard {

/// Throws ConfigError.
inline YamlNode LoadChangedYaml(const std::string& file, const ModelChanges& changes) {
  YamlNode root = LoadModelYaml(file);
  if (changes.nominal != nullptr) MergeYaml(root, *changes.nominal);
  if (changes.built != nullptr) PutBuilt(root, *changes.built);
  return root;
}

}  // namespace dockyard
