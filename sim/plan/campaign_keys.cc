#include "sim/plan/campaign_keys.h"

namespace dockyard {

const std::vector<CampaignKey>& CampaignKeys() {
  static const std::vector<CampaignKey> keys{
      {"campaign", "name; its results folder has it"},
      {"seed", "every draw follows from it"},
      {"base", "a scenario file"},
      {"scenario", "keys on top of the base, for all runs; without base, the whole scenario"},
      {"script", "open-loop commands for all runs"},
      {"arms", "what is compared: names, each with the keys that it sets"},
      {"vary", "factors of the grid; the first changes fastest"},
      {"one_at_a_time", "factors whose values are set alone, at every point of the grid"},
      {"draw", "keys that are drawn for each run, each with a distribution"},
      {"correlate", "rank correlations of pairs of drawn keys"},
      {"design", "how the draws are spread, and how many runs each point and arm has"},
      {"tags", "columns of the table that set nothing and are kept with the results"},
      {"table", "a CSV file; a row is a run"},
      {"runs", "the same in the file itself"},
      {"keep", "which runs leave a folder with log and history"},
      {"limits", "of one run"},
      {"figures", "the plot of curves: labels for x, curves and panels, columns for measures"}};
  return keys;
}

std::vector<std::string> CampaignKeyNames() {
  std::vector<std::string> names;
  for (const CampaignKey& key : CampaignKeys()) names.push_back(key.name);
  return names;
}

const std::vector<std::string>& DesignWords() {
  static const std::vector<std::string> words{"monte_carlo", "latin_hypercube", "sobol"};
  return words;
}

const std::vector<std::string>& DistributionWords() {
  static const std::vector<std::string> words{"normal", "uniform", "loguniform", "discrete"};
  return words;
}

}  // namespace dockyard
