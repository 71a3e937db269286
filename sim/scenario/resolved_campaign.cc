#include <map>
#include <utility>

#include "sim/scenario/campaign_tree.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

/// The table with cells and named values that read the same from any folder: a cell whose text is
/// not its written-out value becomes the name of that value.
class ResolvedTable {
 public:
  ResolvedTable(const CampaignTree& parts, const std::vector<CampaignRun>& runs)
      : parts_(parts), named_(parts.uses.size()), needs_names_(parts.uses.size()) {
    const std::vector<CampaignTable::Row>& rows = parts.table.rows;
    for (std::size_t i = 0; i < rows.size(); ++i) AddRow(rows[i], runs[i].scenario);
  }

  /// The mapping `values`; without keys if none is needed.
  YamlNode Values() const {
    YamlNode values;
    values.kind = YamlNode::Kind::kMapping;
    for (std::size_t i = 0; i < named_.size(); ++i) {
      if (!needs_names_[i]) continue;
      YamlNode names;
      names.kind = YamlNode::Kind::kMapping;
      for (const auto& [name, value] : named_[i]) {
        names.keys.push_back({name, {}});
        names.items.push_back(value);
      }
      values.keys.push_back(parts_.table.columns[i]);
      values.items.push_back(std::move(names));
    }
    return values;
  }
  std::string RowText(const CampaignTable::Row& row) const {
    YamlNode mapping;
    mapping.kind = YamlNode::Kind::kMapping;
    mapping.keys.push_back({"run", {}});
    mapping.items.push_back(ScalarNode(std::to_string(row.run), false));
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      mapping.keys.push_back(parts_.table.columns[i]);
      mapping.items.push_back(needs_names_[i] ? ScalarNode(CellText(row.cells[i]), true)
                                              : row.cells[i]);
    }
    return FlowText(mapping);
  }

 private:
  void AddRow(const CampaignTable::Row& row, const Scenario& scenario) {
    YamlNode written;  // made when needed
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (parts_.uses[i].is_tag) continue;
      const std::string text = CellText(row.cells[i]);
      if (named_[i].count(text) > 0) continue;
      if (written.kind == YamlNode::Kind::kNull) written = WriteScenario(scenario);
      const YamlNode* found = FindPath(written, parts_.table.columns[i].name);
      const YamlNode value = found != nullptr ? *found : ParseYaml("{}", "");  // all of it unset
      needs_names_[i] = needs_names_[i] || CellText(value) != text;
      named_[i].emplace(text, value);
    }
  }

  const CampaignTree& parts_;
  std::vector<std::map<std::string, YamlNode>> named_;  // by column: cell and its value
  std::vector<bool> needs_names_;
};

}  // namespace

std::vector<std::string> KeysOfRuns(const CampaignTree& campaign) {
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < campaign.uses.size(); ++i) {
    if (!campaign.uses[i].is_tag) keys.push_back(campaign.table.columns[i].name);
  }
  return keys;
}

std::string ResolvedYaml(const Campaign& campaign, const CampaignTree& parts) {
  YamlNode common = WriteScenario(campaign.runs.front().scenario);
  for (const char* of_run : {"name", "seed"}) RemovePath(common, of_run);
  for (const std::string& key : KeysOfRuns(parts)) RemovePath(common, key);
  const ResolvedTable table(parts, campaign.runs);
  std::string text = "campaign: " + FlowText(ScalarNode(campaign.name, true)) + "\n";
  text += "seed: " + std::to_string(campaign.seed) + "\n";
  text += "scenario:\n" + BlockText(common, 2);
  if (const YamlNode values = table.Values(); !values.keys.empty()) {
    text += "values:\n" + BlockText(values, 2);
  }
  YamlNode tags;
  tags.kind = YamlNode::Kind::kSequence;
  for (std::size_t i = 0; i < parts.uses.size(); ++i) {
    if (parts.uses[i].is_tag) tags.items.push_back(ScalarNode(parts.table.columns[i].name, true));
  }
  if (!tags.items.empty()) text += "tags: " + FlowText(tags) + "\n";
  text += "runs:\n";
  for (const CampaignTable::Row& row : parts.table.rows) {
    text += "  - " + table.RowText(row) + "\n";
  }
  return text;
}

}  // namespace dockyard
