// Two groups of a campaign's runs that a label tells apart: `compare DIR KEY=A KEY=B`.
#pragma once

#include <optional>
#include <string>

#include "sim/app/kept_campaign.h"
#include "sim/report/arm_pairs.h"
#include "sim/statistics/unpaired.h"

namespace dockyard {

struct ComparedGroups {
  ArmPairs pairs;                    // without any: apart holds
  std::optional<GroupCounts> apart;  // no two runs share seed and labels
  std::string pooled;                // settings in which runs of one group differ, where apart
};

/// Whether these words name groups: both have a '=', and neither is an arm.
bool NameGroups(const KeptCampaign& kept, const std::string& a, const std::string& b);

/// Throws UsageError for two keys, an unknown one, and a value that no run has.
ComparedGroups CompareGroups(const KeptCampaign& kept, const std::string& a, const std::string& b);

}  // namespace dockyard
