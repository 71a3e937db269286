// scenarios/*.yaml -> Scenario and Campaign; and a scenario back to YAML with every default written
// out. docs/reference/scenarios.md lists the keys.
#pragma once

#include <string>
#include <vector>

#include "sim/scenario/scenario.h"

namespace dockyard {

/// `overrides` are "key.path=value" as of the option --set; a later one replaces an earlier one.
/// File names in them are relative to the working directory. The system checks its own part
/// (System::check). Throws ConfigError.
Scenario LoadScenario(const std::string& file, const std::vector<std::string>& overrides,
                      const std::vector<KnownSystem>& systems);

/// A campaign: a base scenario and a table of runs (a CSV file, or a list in the file itself). The
/// seed of each run is WorldSeed(campaign seed, run, 0). Overrides as above, for keys of the
/// campaign file. Throws ConfigError.
Campaign LoadCampaign(const std::string& file, const std::vector<std::string>& overrides,
                      const std::vector<KnownSystem>& systems);

/// Everything, defaults included, with absolute paths; LoadScenario reads it back to the same
/// values, bit for bit, when angles came from degrees in a file. Campaign::resolved_yaml is the
/// same for a campaign.
std::string ResolvedYaml(const Scenario& scenario);

/// The check of a campaign's table without the campaign's file.
struct TableCheck {
  int runs = 0;
  std::vector<std::string> checked;  // columns that are keys, every cell within its range
  // The rest: tags, files, keys of a system, names that the campaign's file gives a value.
  std::vector<std::string> left_to_campaign;
};
/// Throws ConfigError with the place of the first bad cell.
TableCheck CheckCampaignTable(const std::string& file);

}  // namespace dockyard
