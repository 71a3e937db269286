// What results depend on beside the scenario: fingerprints of this program and of the model files.
#pragma once

#include <string>
#include <vector>

#include "sim/plan/campaign.h"

namespace dockyard {

/// A line for the program, one for the C library's mathematics, and one for each file that the
/// campaign's runs read, in a fixed order: the folders of the models (URDF, meshes and YAML),
/// camera files, all other files that scenario and models name, and a controller's program. Throws
/// IoError, and ConfigError for a model that is not YAML.
std::string IdentityText(const Campaign& campaign, const std::vector<KnownSystem>& systems);

}  // namespace dockyard
