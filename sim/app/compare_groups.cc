#include "sim/app/compare_groups.h"

#include <algorithm>
#include <vector>

#include "sim/app/commands.h"
#include "sim/report/sample.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostNamed = 12;

std::string Joined(const std::vector<std::string>& texts) {
  std::string joined;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i == kMostNamed) return joined + ", ...";
    joined += (i == 0 ? "" : ", ") + texts[i];
  }
  return joined;
}

std::string KeyOf(const std::string& word) { return word.substr(0, word.find('=')); }

bool IsArm(const Campaign& campaign, const std::string& word) {
  return std::any_of(campaign.arms.begin(), campaign.arms.end(),
                     [&](const Arm& arm) { return arm.name == word; });
}

Rows GroupOf(const KeptCampaign& kept, const std::string& label, const std::string& word) {
  const std::string value = word.substr(word.find('=') + 1);
  const Rows all = RunsOfArm(kept, "");
  Rows group;
  for (const RunResult* row : all) {
    if (LabelOf(*row, kept.columns, label) == value) group.push_back(row);
  }
  if (!group.empty()) return group;
  throw UsageError("expected a value of " + label + " that runs have (" +
                   Joined(LevelsOf(all, kept.columns, label)) + "), found '" + value + "'");
}

void RequireLabel(const KeptCampaign& kept, const std::string& a, const std::string& b) {
  const std::string label = KeyOf(a);
  if (KeyOf(b) != label) {
    throw UsageError("expected two values of one key, found " + label + " and " + KeyOf(b));
  }
  const std::vector<std::string>& labels = kept.columns.labels;
  if (label == "controller" || std::find(labels.begin(), labels.end(), label) != labels.end()) {
    return;
  }
  throw UsageError("expected KEY=VALUE with a label of the campaign (" +
                   (labels.empty() ? "it has none" : Joined(labels)) + "), found '" + label + "'");
}

GroupCounts CountsOf(const Rows& a, const Rows& b) {
  const auto successes = [](const Rows& rows) {
    return static_cast<int>(
        std::count_if(rows.begin(), rows.end(), [](const RunResult* row) { return row->success; }));
  };
  return {successes(a), static_cast<int>(a.size()), successes(b), static_cast<int>(b.size())};
}

}  // namespace

bool NameGroups(const KeptCampaign& kept, const std::string& a, const std::string& b) {
  const auto names = [&](const std::string& word) {
    return word.find('=') != std::string::npos && !IsArm(kept.campaign, word);
  };
  return names(a) && names(b);
}

ComparedGroups CompareGroups(const KeptCampaign& kept, const std::string& a, const std::string& b) {
  RequireLabel(kept, a, b);
  const std::string label = KeyOf(a);
  const Rows of_a = GroupOf(kept, label, a), of_b = GroupOf(kept, label, b);
  if (a == b) throw UsageError("expected two values of " + label + ", found one");
  ComparedGroups found;
  found.pairs = PairGroups(label, kept.columns, of_a, of_b);
  const PairedCounts& counts = found.pairs.counts;
  if (counts.both + counts.only_a + counts.only_b + counts.neither > 0) return found;
  found.pairs.unpaired = 0;
  found.apart = CountsOf(of_a, of_b);
  std::vector<std::string> settings = SettingLabels(kept.campaign);
  std::erase_if(settings, [&](const std::string& each) {
    return each == label || (label == "changed" && each == "changed_to");
  });
  found.pooled = Joined(DifferingLabels(settings, kept.columns, of_a));
  return found;
}

}  // namespace dockyard
