// What the parts of a campaign's file must agree on.
#pragma once

#include <vector>

#include "models/read/yaml_reader.h"
#include "sim/plan/campaign.h"

namespace dockyard {

/// Throws ConfigError for columns that are neither keys nor tags, for a key that is set in two
/// places, and for more points or runs than can be. `root`: the campaign's file.
void CheckWhole(const Campaign& campaign, const YamlReader& root,
                const std::vector<KnownSystem>& systems);

}  // namespace dockyard
