// The models that a scenario of Axel names, loaded once.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"
#include "models/parts/soil_model.h"
#include "models/read/mesh_loader.h"
#include "sim/axel/axel_keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::axel {

struct ModelSet {
  RoverModel rover;
  StationModel station;
  SoilModel soil;
};

struct AxelModels {
  AxelKeys keys;
  ModelSet told;   // what the controller is told of
  ModelSet built;  // what the world is made of; equal unless the scenario has `as_built`
};

/// Reads the files, applies the scenario's changes, cameras and tip angle, and checks the models
/// against each other. Throws ConfigError.
/// @param meshes  as of LoadMesh
AxelModels LoadModels(const Scenario& scenario, MeshStore* meshes = nullptr);

/// Why the controller's bracket of exposures cannot be of use, or empty.
std::string WhyNoBracket(const Scenario& scenario, const AxelModels& models);

/// Keeps the last few sets of models, so that the runs of a campaign share them. A worker that is
/// forked after a set was loaded has the set without reading a file.
class ModelStore {
 public:
  /// As LoadModels. Files that changed since are not noticed.
  std::shared_ptr<const AxelModels> Get(const Scenario& scenario);
  /// The meshes of all models read so far.
  MeshStore& meshes() { return meshes_; }

 private:
  MeshStore meshes_;
  static constexpr std::size_t kMostSets = 16;  // a set holds some megabytes of meshes
  std::vector<std::pair<std::string, std::shared_ptr<const AxelModels>>> sets_;  // newest last
};

}  // namespace dockyard::axel
