// The models that a scenario of Axel names, loaded once.
#pragma once

#include <string>

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
  ModelSet nominal;  // the values that the controller gets
  ModelSet built;    // what the world is made of; equal unless the scenario has `as_built`
};

/// Reads the files, applies the scenario's changes, cameras and tip angle, and checks the models
/// against each other. Throws ConfigError.
/// @param meshes  as of LoadMesh
AxelModels LoadModels(const Scenario& scenario, MeshStore* meshes = nullptr);

/// Throws ConfigError for a bracket of exposures that is asked for and cannot be of use.
void CheckBracket(const Scenario& scenario, const AxelModels& models);
/// Why the controller's bracket of exposures cannot be of use, or empty.
std::string WhyNoBracket(const Scenario& scenario, const AxelModels& models);

}  // namespace dockyard::axel
