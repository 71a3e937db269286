// models/floors/*.yaml -> FloorModel.
#pragma once

#include <string>

#include "models/parts/floor_model.h"
#include "models/read/as_built.h"
#include "models/read/keys.h"

namespace dockyard {

/// `changes` are keys on top of the file's. Throws ConfigError.
FloorModel LoadFloor(const std::string& file, const ModelChanges& changes = {});
/// Names every key of a floor's file.
void VisitFloor(Keys& keys, FloorModel& floor);

}  // namespace dockyard
