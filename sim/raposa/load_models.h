// The models that a scenario of RAPOSA names.
#pragma once

#include "models/raposa/ground_model.h"
#include "models/raposa/pyramid_model.h"
#include "models/raposa/robot_model.h"
#include "models/read/mesh_loader.h"
#include "sim/raposa/raposa_keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::raposa {

struct ModelSet {
  RobotModel robot;
  PyramidModel pyramid;
  GroundModel ground;
};

struct RaposaModels {
  RaposaKeys keys;
  ModelSet nominal;  // the values that the controller gets
  ModelSet built;    // what the world is made of; equal unless the scenario has `as_built`
};

/// Reads the files and applies the scenario's changes. Throws ConfigError.
/// @param meshes  as of LoadMesh
RaposaModels LoadModels(const Scenario& scenario, MeshStore* meshes = nullptr);

}  // namespace dockyard::raposa
