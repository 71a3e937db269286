// Models that scenarios name, read once for all runs of a process.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "models/read/mesh_loader.h"
#include "sim/plant/model_files.h"

namespace dockyard {

/// Keeps the last few sets of models, so that the runs of a campaign share them. A worker that is
/// forked after a set was loaded has the set without reading a file.
template <class Models>
class ModelStore {
 public:
  using Load = Models (*)(const Scenario&, MeshStore*);
  using Check = void (*)(const Scenario&, const Models&);
  /// check: of models with what is no part of them, such as the controller; null: none.
  explicit ModelStore(Load load, Check check = nullptr) : load_(load), check_(check) {}

  /// As Load. Files that changed since are not noticed.
  std::shared_ptr<const Models> Get(const Scenario& scenario) {
    const std::string key = ModelKey(scenario);
    const auto known =
        std::find_if(sets_.begin(), sets_.end(), [&](const auto& set) { return set.first == key; });
    if (known != sets_.end()) {
      if (check_ != nullptr) check_(scenario, *known->second);
      return known->second;
    }
    auto models = std::make_shared<const Models>(load_(scenario, &meshes_));
    if (sets_.size() >= kMostSets) sets_.erase(sets_.begin());
    sets_.emplace_back(key, models);
    return models;
  }
  /// The meshes of all models read so far.
  MeshStore& meshes() { return meshes_; }

 private:
  static constexpr std::size_t kMostSets = 16;  // a set holds some megabytes of meshes
  Load load_;
  Check check_;
  MeshStore meshes_;
  std::vector<std::pair<std::string, std::shared_ptr<const Models>>> sets_;  // newest last
};

}  // namespace dockyard
