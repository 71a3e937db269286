// What results depend on beside the scenario: fingerprints of this program and of the model files.
#pragma once

#include <string>

#include "sim/run/system.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// A line for the program and one for each file that the campaign's runs read, in a fixed order:
/// the folders of the models (URDF, meshes and YAML), the scenario's camera file, and all other
/// files that scenario and models name. Throws IoError, and ConfigError for a model that is not
/// YAML.
std::string IdentityText(const Campaign& campaign, const System& system);

}  // namespace dockyard
