// The models that a scenario names.
#pragma once

#include <string>

#include "models/read/as_built.h"
#include "models/read/mesh_loader.h"
#include "sim/custom/custom_models.h"

namespace dockyard::custom {

/// A file of models/floors or of models/soils. Throws ConfigError.
GroundModel LoadGround(const std::string& file, const ModelChanges& changes = {});

/// Reads the files and applies the scenario's changes. Throws ConfigError, also for models that can
/// never dock.
CustomModels LoadModels(const Scenario& scenario, MeshStore* meshes = nullptr);

}  // namespace dockyard::custom
