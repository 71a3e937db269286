// The model files that a scenario names, and its changes to them.
#pragma once

#include <string>
#include <vector>

#include "models/read/as_built.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// All that the models depend on, as text: equal text means equal models.
std::string ModelKey(const Scenario& scenario);

/// Throws ConfigError when the scenario names no robot or no soil. whose: "Axel's"; ground: what
/// the soil's file is of.
void RequireFiles(const Scenario& scenario, const std::string& whose,
                  const std::string& ground = "a soil's");
/// Throws ConfigError for cameras of a scenario's own. file, size: why not, for the message.
void RefuseCamera(const Scenario& scenario, const std::string& file, const std::string& size);
/// Throws ConfigError when `changes` or `as_built` have roots other than these, or spreads.
void CheckRoots(const Scenario& scenario, const std::vector<std::string>& roots);
/// Throws ConfigError if the dotted key is there. root: the name of `changes` itself.
void RefuseKey(const YamlNode& changes, const std::string& root, const std::string& path,
               const std::string& expected);

/// The models as the controller is told of them, and as built. `load` gets the changes to a model
/// by its root.
template <class Models, class LoadSet>
void LoadSets(const Scenario& scenario, const LoadSet& load, Models& models) {
  const auto set = [&](const YamlNode& built) {
    return load([&](const char* root) {
      return ModelChanges{scenario.changes.Find(root), built.Find(root)};
    });
  };
  models.nominal = set({});
  models.built =
      scenario.as_built.kind == YamlNode::Kind::kNull ? models.nominal : set(scenario.as_built);
}

}  // namespace dockyard
