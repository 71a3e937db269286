#include "sim/report/sample.h"

#include <algorithm>

namespace dockyard {

std::string WhyDependent(const Campaign& campaign) {
  if (campaign.design == DesignKind::kMonteCarlo) return "";
  return "the runs of its design depend on each other; monte_carlo draws them independently";
}

std::string WhyNoSample(const Campaign& campaign) {
  if (!campaign.table.rows.empty()) return "its runs are rows of a table";
  if (!campaign.grid.empty()) return "its runs are points of a grid (vary)";
  if (!campaign.one_at_a_time.empty()) return "it sets keys one at a time";
  return WhyDependent(campaign);
}

std::vector<std::string> SettingLabels(const Campaign& campaign) {
  std::vector<std::string> settings;
  for (const std::string& label : campaign.labels) {
    const bool drawn = std::any_of(campaign.dispersions.begin(), campaign.dispersions.end(),
                                   [&](const Dispersion& each) { return each.key.name == label; });
    if (drawn || label == "point" || label == "repeat" || IsTag(campaign, label)) continue;
    settings.push_back(label);
  }
  if (campaign.sets_controller) settings.push_back("controller");
  return settings;
}

std::vector<std::string> DifferingLabels(const std::vector<std::string>& labels,
                                         const RowColumns& columns, const Rows& rows) {
  std::vector<std::string> differing;
  for (const std::string& label : labels) {
    const bool differs = std::any_of(rows.begin(), rows.end(), [&](const RunResult* row) {
      return LabelOf(*row, columns, label) != LabelOf(*rows.front(), columns, label);
    });
    if (differs) differing.push_back(label);
  }
  return differing;
}

}  // namespace dockyard
