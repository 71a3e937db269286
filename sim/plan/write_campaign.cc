#include <utility>

#include "sim/base/text.h"
#include "sim/plan/campaign.h"
#include "sim/plan/make_run.h"
#include "sim/scenario/key_path.h"

namespace dockyard {
namespace {

using Kind = YamlNode::Kind;

YamlNode Mapping() {
  YamlNode node;
  node.kind = Kind::kMapping;
  return node;
}

void Add(YamlNode& mapping, const std::string& key, YamlNode value) {
  mapping.keys.push_back({key, {}});
  mapping.items.push_back(std::move(value));
}

/// Labels with values, which read the same whatever the values are.
YamlNode ValuesNode(const Factor& factor) {
  YamlNode values = Mapping();
  for (std::size_t i = 0; i < factor.values.size(); ++i) {
    Add(values, factor.labels[i], factor.values[i]);
  }
  return values;
}

YamlNode FactorsNode(const std::vector<Factor>& factors) {
  YamlNode mapping = Mapping();
  for (const Factor& factor : factors) Add(mapping, factor.key.name, ValuesNode(factor));
  return mapping;
}

YamlNode ArmsNode(const Campaign& campaign) {
  YamlNode arms = Mapping();
  for (const Arm& arm : campaign.arms) {
    YamlNode sets = Mapping();
    for (const KeyValue& set : arm.sets) {
      Add(sets, set.key.name, set.value);
    }
    Add(arms, arm.name, std::move(sets));
  }
  return arms;
}

/// As in the file, but for files among a discrete distribution's values.
YamlNode DrawNode(const Campaign& campaign) {
  YamlNode draw = Mapping();
  for (const Dispersion& dispersion : campaign.dispersions) {
    YamlNode node = *campaign.tree.Find("draw")->Find(dispersion.key.name);
    if (dispersion.discrete()) {
      *FindPath(node, "discrete.values") = ValuesNode(dispersion.values);
    }
    Add(draw, dispersion.key.name, std::move(node));
  }
  return draw;
}

std::string RowsText(const Campaign& campaign) {
  std::string text = "runs:\n";
  for (const RunTable::Row& row : campaign.table.rows) {
    YamlNode mapping = Mapping();
    Add(mapping, "run", ScalarNode(std::to_string(row.run), false));
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      Add(mapping, campaign.table.columns[i].name, row.cells[i]);
    }
    text += "  - " + FlowText(mapping) + "\n";
  }
  return text;
}

}  // namespace

std::string CampaignYaml(const Campaign& campaign) {
  YamlNode base = campaign.base;
  RemovePath(base, "name");
  RemovePath(base, "seed");
  // What each run replaces goes; a mapping stays, as a run's keys go on top of it.
  for (const YamlNode::Key& key : KeysOfRuns(campaign)) {
    const YamlNode* value = FindPath(base, key.name);
    if (value != nullptr && value->kind != Kind::kMapping) RemovePath(base, key.name);
  }
  std::string text = "campaign: " + FlowText(ScalarNode(campaign.name, true)) + "\n";
  text += "seed: " + std::to_string(campaign.seed.number) + "\n";
  text += "scenario:\n" + BlockText(base, 2);
  const auto add = [&](const char* key, const YamlNode& mapping) {
    if (!mapping.keys.empty()) text += std::string(key) + ":\n" + BlockText(mapping, 2);
  };
  add("arms", ArmsNode(campaign));
  std::vector<Factor> vary = campaign.grid;
  vary.insert(vary.end(), campaign.named.begin(), campaign.named.end());
  add("vary", FactorsNode(vary));
  add("one_at_a_time", FactorsNode(campaign.one_at_a_time));
  add("draw", DrawNode(campaign));
  for (const char* key : {"correlate", "design", "tags", "keep", "limits", "figures"}) {
    const YamlNode* node = campaign.tree.Find(key);
    if (node != nullptr && (campaign.correlation || std::string(key) != "correlate")) {
      text += std::string(key) + ": " + FlowText(*node) + "\n";
    }
  }
  if (!campaign.table.rows.empty()) text += RowsText(campaign);
  return text;
}

std::string PlanCsv(const Campaign& campaign, const std::vector<KnownSystem>& systems) {
  const RunMaker maker(campaign, systems);
  std::vector<std::string> header{"run", "seed"};
  header.insert(header.end(), campaign.labels.begin(), campaign.labels.end());
  if (campaign.sets_controller) header.push_back("controller");
  std::string text = CsvLine(header) + "\n";
  for (std::int64_t i = 0; i < campaign.run_count(); ++i) {
    const CampaignRun run = maker.Make(i);
    std::vector<std::string> cells{std::to_string(run.run),
                                   std::to_string(run.scenario.seed.number)};
    cells.insert(cells.end(), run.labels.begin(), run.labels.end());
    if (campaign.sets_controller) cells.push_back(run.scenario.controller);
    text += CsvLine(cells) + "\n";
  }
  return text;
}

}  // namespace dockyard
