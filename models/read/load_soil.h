// models/soils/*.yaml -> SoilModel.
#pragma once

#include <string>

#include "models/parts/soil_model.h"
#include "models/parts/wheel.h"
#include "models/read/as_built.h"

namespace dockyard {

/// `changes` are keys on top of the file's. Throws ConfigError.
SoilModel LoadSoil(const std::string& file, const ModelChanges& changes = {});
/// Throws ConfigError if the soil's modulus k_c / b + k_phi is not positive under this wheel.
void CheckCarries(const SoilModel& soil, const std::string& file, const WheelModel& wheel);

}  // namespace dockyard
