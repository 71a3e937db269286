// The campaign whose runs are those of fake_runs.h.
#pragma once

#include <vector>

#include "sim/plan/campaign.h"

namespace dockyard {

std::vector<KnownSystem> FakeSystems();
/// FakeRuns(count) as rows of a table, with the soil as a tag.
Campaign FakeCampaign(int count);

}  // namespace dockyard
