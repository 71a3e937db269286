// A campaign's file as a JSON Schema, from the keys that its reader reads.
#pragma once

#include <vector>

#include "sim/base/json.h"
#include "sim/scenario/scenario_schema.h"

namespace dockyard {

Json CampaignSchema(const std::vector<SystemKeys>& systems);

}  // namespace dockyard
