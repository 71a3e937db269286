// models/raposa/grounds/*.yaml -> GroundModel.
#pragma once

#include <string>

#include "models/raposa/ground_model.h"
#include "models/read/as_built.h"

namespace dockyard::raposa {

/// A file with a soil's keys, those of models/soils, is a ground that belts sink into. `changes`
/// are keys on top of the file's. Throws ConfigError.
GroundModel LoadGround(const std::string& file, const ModelChanges& changes = {});

}  // namespace dockyard::raposa
