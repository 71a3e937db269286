// A ground under belts: how it carries them, and what it looks like.
#pragma once

#include <optional>
#include <string>

#include "models/parts/belt.h"
#include "models/parts/floor_model.h"
#include "models/parts/soil_model.h"

namespace dockyard::raposa {

struct GroundModel {
  std::string name, source;
  BeltGround belt;                // where there is a soil, its loss and its patches alone
  std::optional<SoilModel> soil;  // that the belts sink into
  GroundMaterialKind material = GroundMaterialKind::kFloor;
  double grain = 0.0;  // contrast of what lies on it, 0 to 1
};

}  // namespace dockyard::raposa
