// A campaign's file between reading and writing: the base that all runs share and the table.
#pragma once

#include <string>
#include <vector>

#include "sim/scenario/campaign_table.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// How the campaign's file uses a column.
struct ColumnUse {
  bool is_tag = false;
  const YamlNode* values = nullptr;  // names of values; none: the cells are the values
};

/// The whole of a campaign's file but its head.
struct CampaignTree {
  YamlNode base;  // what all runs share
  CampaignTable table;
  std::vector<ColumnUse> uses;  // by column
};

/// Columns that are keys of the scenario.
std::vector<std::string> KeysOfRuns(const CampaignTree& campaign);

/// The campaign as one file that reads back to the same from any folder.
std::string ResolvedYaml(const Campaign& campaign, const CampaignTree& parts);

}  // namespace dockyard
