// What results depend on beside the scenario: this program and the model files, by fingerprint.
#pragma once

#include <string>

#include "sim/run/system.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// A line for the program and one for each file that the campaign's runs read: the folders of the
/// models (URDF, meshes and YAML), the scenario's camera file, and what else scenario and models
/// name, in a fixed order. Throws IoError, and ConfigError for a model that is no YAML.
std::string IdentityText(const Campaign& campaign, const System& system);

}  // namespace dockyard
