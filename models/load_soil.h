// models/soils/*.yaml -> SoilModel.
#pragma once

#include <string>

#include "models/soil_model.h"
#include "models/yaml_tree.h"

namespace dockyard {

/// `changes` are keys on top of the file's. Throws ConfigError.
SoilModel LoadSoil(const std::string& file, const YamlNode* changes = nullptr);

}  // namespace dockyard
