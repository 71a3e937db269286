// models/soils/*.yaml -> SoilModel.
#pragma once

#include <string>

#include "models/soil_model.h"

namespace dockyard {

/// Throws ConfigError.
SoilModel LoadSoil(const std::string& file);

}  // namespace dockyard
