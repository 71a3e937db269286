#include "sim/page/groups_part.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "controller/base/number_text.h"
#include "sim/statistics/intervals.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostGroups = 12;

bool AllNumbers(const std::vector<std::string>& texts) {
  return std::all_of(texts.begin(), texts.end(),
                     [](const std::string& text) { return NumberFromText(text).has_value(); });
}

/// Whether the campaign's file lists the label's values for every run to have.
bool IsListed(const Campaign* campaign, const std::string& label) {
  if (campaign == nullptr) return false;
  if (label == "arm") return !campaign->arms.empty();
  return std::any_of(campaign->grid.begin(), campaign->grid.end(),
                     [&](const Factor& factor) { return factor.key.name == label; });
}

bool IsDrawn(const Campaign* campaign, const std::string& label) {
  if (campaign == nullptr) return false;
  return std::any_of(campaign->dispersions.begin(), campaign->dispersions.end(),
                     [&](const Dispersion& each) { return each.key.name == label; });
}

/// Whether the label's values tell groups of runs apart.
bool IsSetting(const Campaign* campaign, const std::string& label,
               const std::vector<std::string>& values, std::size_t runs) {
  if (values.size() < 2 || values.size() > kMostGroups) return false;
  if (IsListed(campaign, label)) return true;
  if (label == "point" || label == "repeat" || label == "changed_to") return false;
  if (IsDrawn(campaign, label) && AllNumbers(values)) return false;
  return 2 * values.size() <= runs;  // else most groups have one run, which is no rate
}

}  // namespace

Json ShareJson(int successes, int runs) {
  const Interval interval = ClopperPearson(successes, runs);
  return {{"successes", successes},
          {"runs", runs},
          {"interval", Json::array({interval.low, interval.high})}};
}

Json GroupsPart(const Campaign* campaign, const FinishedRuns& runs, const RowColumns& columns) {
  Json groups = Json::array();
  for (std::size_t label = 0; label < columns.labels.size(); ++label) {
    std::vector<std::string> values;
    std::map<std::string, std::pair<int, int>> counts;
    for (const RunResult& row : runs.results) {
      const auto [at, fresh] = counts.try_emplace(row.labels[label]);
      if (fresh) values.push_back(row.labels[label]);
      at->second.first += row.success;
      ++at->second.second;
      if (counts.size() > kMostGroups) break;
    }
    if (!IsSetting(campaign, columns.labels[label], values, runs.size())) continue;
    if (AllNumbers(values)) {
      std::stable_sort(values.begin(), values.end(), [](const auto& a, const auto& b) {
        return *NumberFromText(a) < *NumberFromText(b);
      });
    }
    Json list = Json::array();
    for (const std::string& value : values) {
      Json share = ShareJson(counts[value].first, counts[value].second);
      share["value"] = value;
      list.push_back(share);
    }
    groups.push_back({{"label", columns.labels[label]}, {"values", list}});
  }
  return groups;
}

}  // namespace dockyard
