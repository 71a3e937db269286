// A ground under belts: how it carries them, and what it looks like.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "models/parts/belt.h"
#include "models/parts/soil_model.h"

namespace dockyard::raposa {

/// What a surface is made of, for its spectrum.
enum class GroundMaterialKind : std::uint8_t { kFloor, kSoil, kGrass, kBrick, kGrey };

struct GroundModel {
  std::string name, source;
  BeltGround belt;                // where there is a soil, its loss and its patches alone
  std::optional<SoilModel> soil;  // that the belts sink into
  GroundMaterialKind material = GroundMaterialKind::kFloor;
  double grain = 0.0;  // contrast of what lies on it, 0 to 1
};

}  // namespace dockyard::raposa
