// models/soils/*.yaml -> SoilModel.
#pragma once

#include <string>

#include "models/parts/soil_model.h"
#include "models/read/as_built.h"
#include "models/read/keys.h"

namespace dockyard {

/// `changes` are keys on top of the file's. Throws ConfigError.
SoilModel LoadSoil(const std::string& file, const ModelChanges& changes = {});
/// Names every key of a soil's file.
void VisitSoil(Keys& keys, SoilModel& soil);
/// Throws ConfigError if the soil's modulus k_c / b + k_phi is not positive under a wheel or belt
/// of this width.
void CheckCarries(const SoilModel& soil, const std::string& file, double width_m);

}  // namespace dockyard
