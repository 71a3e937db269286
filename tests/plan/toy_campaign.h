// Campaigns of the toy system of tests/scenario.
#pragma once

#include <vector>

#include "scenario/toy_system.h"
#include "sim/plan/make_run.h"

namespace dockyard {

CampaignSystems ToyCampaigns();
/// Every run, in order.
std::vector<CampaignRun> AllRuns(const Campaign& campaign,
                                 const std::vector<KnownSystem>& systems = ToySystems());
/// Reads the file and checks its runs. Throws ConfigError.
Campaign LoadAndCheck(const std::string& file, const std::vector<std::string>& overrides = {});

}  // namespace dockyard
