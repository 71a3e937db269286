// What results depend on beside the scenario: this program and the model files, by fingerprint.
#pragma once

#include <string>

#include "models/scenario.h"

namespace dockyard {

/// A line for the program and one for each file in the folders of the campaign's models (URDF,
/// meshes and YAML), in a fixed order. Throws IoError.
std::string IdentityText(const Campaign& campaign);

}  // namespace dockyard
