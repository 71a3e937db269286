#include <utility>

#include "models/read/config_error.h"
#include "models/read/csv_table.h"
#include "models/read/yaml_reader.h"
#include "sim/base/random.h"
#include "sim/scenario/campaign_tree.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/load_scenario.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

[[noreturn]] void RefuseKey(const YamlNode::Key& key, const std::string& path,
                            const std::string& expected) {
  throw ConfigError(key.place.Text() + ": " + path + ": expected " + expected);
}

void RefuseFormerKeys(const YamlNode& tree) {
  for (const YamlNode::Key& key : tree.keys) {
    if (key.name == "soils") RefuseKey(key, "soils", "values: {soil: {NAME: FILE, ...}} instead");
  }
}

/// Finds the place of the innermost key of a dotted path that is there.
const YamlNode::Key* FindKey(const YamlNode& tree, std::string_view path) {
  const std::string_view first = path.substr(0, path.find('.'));
  for (std::size_t i = 0; i < tree.keys.size(); ++i) {
    if (tree.keys[i].name != first) continue;
    if (first.size() == path.size()) return &tree.keys[i];
    return FindKey(tree.items[i], path.substr(first.size() + 1));
  }
  return nullptr;
}

/// Keys that each run sets itself would be lost in the campaign's own keys. A base file may have
/// them: it is a scenario of its own.
void RefuseKeysOfRuns(const YamlNode& scenario, std::vector<std::string> of_runs) {
  of_runs.insert(of_runs.end(), {"name", "seed"});
  for (const std::string& name : of_runs) {
    const YamlNode::Key* key = FindKey(scenario, name);
    if (key == nullptr) continue;
    RefuseKey(*key, "scenario." + name,
              "only keys that all runs share; each run has its own " + name);
  }
}

/// The base: a scenario file, with the keys of `scenario` on top.
YamlNode BaseTree(const YamlReader& root) {
  if (!root.Has("base")) return root.Child("scenario");  // throws if missing
  YamlNode base = LoadYaml(root.File("base"));
  if (root.Has("scenario")) MergeYaml(base, root.Child("scenario"));
  return base;
}

CampaignTable ReadTableOf(const YamlReader& in, const YamlNode& tree) {
  if (in.Has("table") == in.Has("runs")) {
    throw ConfigError(tree.place.Text() + ": expected one of the keys 'table' and 'runs', found " +
                      (in.Has("table") ? "both" : "neither"));
  }
  if (in.Has("table")) return ReadTable(LoadCsv(in.File("table")), "");
  return ReadTable(in.List("runs", 0, 1u << 30), in.PathOf("runs"));
}

std::size_t ColumnOf(const CampaignTable& table, const std::string& name) {
  std::size_t column = 0;
  while (column < table.columns.size() && table.columns[column].name != name) ++column;
  return column;
}

void ReadTags(const YamlReader& in, CampaignTree& campaign) {
  if (!in.Has("tags")) return;
  for (const YamlNode& tag : in.List("tags", 1, 100).items) {
    const std::size_t column = ColumnOf(campaign.table, tag.scalar);
    if (column == campaign.table.columns.size()) {
      throw ConfigError(tag.place.Text() + ": tags: expected a column of the table, found " +
                        tag.Found());
    }
    campaign.uses[column].is_tag = true;
  }
}

void ReadValues(const YamlReader& in, CampaignTree& campaign) {
  if (!in.Has("values")) return;
  const YamlNode& values = in.Child("values");
  if (values.kind != YamlNode::Kind::kMapping) {
    in.Refuse("values", "keys of the scenario, each with its named values");
  }
  for (std::size_t i = 0; i < values.keys.size(); ++i) {
    const std::string path = "values." + values.keys[i].name;
    const std::size_t column = ColumnOf(campaign.table, values.keys[i].name);
    if (column == campaign.table.columns.size()) {
      RefuseKey(values.keys[i], path, "a column of the table");
    }
    if (campaign.uses[column].is_tag) RefuseKey(values.keys[i], path, "none; it is a tag");
    if (values.items[i].kind != YamlNode::Kind::kMapping || values.items[i].keys.empty()) {
      throw ConfigError(values.items[i].place.Text() + ": " + path +
                        ": expected a mapping of names to values, found " +
                        values.items[i].Found());
    }
    campaign.uses[column].values = &values.items[i];
  }
}

void CheckColumns(const CampaignTree& campaign, const std::vector<KnownSystem>& systems) {
  Scenario none;
  const std::vector<std::string> keys =
      KeyNames([&](Keys& in) { VisitScenario(in, none, systems); });
  const std::vector<YamlNode::Key>& columns = campaign.table.columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    CheckColumn(columns[i], campaign.uses[i].is_tag, keys);
    for (std::size_t k = 0; k < i; ++k) {
      if (!PathsOverlap(columns[k].name, columns[i].name)) continue;
      RefuseKey(columns[i], columns[i].name,
                "a column that sets other keys than '" + columns[k].name + "'");
    }
  }
}

/// The value that a cell stands for.
const YamlNode& ValueOf(const YamlNode& cell, const YamlNode::Key& column, const ColumnUse& use) {
  if (use.values == nullptr) return cell;
  if (cell.kind == YamlNode::Kind::kScalar) {
    if (const YamlNode* named = use.values->Find(cell.scalar)) return *named;
  }
  std::string names;
  for (const YamlNode::Key& key : use.values->keys) names += (names.empty() ? "" : ", ") + key.name;
  throw ConfigError(cell.place.Text() + ": " + column.name + ": expected one of " + names +
                    ", found " + cell.Found());
}

std::string TagText(const YamlNode& cell, const YamlNode::Key& column) {
  YamlNode holder;  // a reader needs a mapping
  holder.kind = YamlNode::Kind::kMapping;
  holder.keys.push_back(column);
  holder.items.push_back(cell);
  return YamlReader(holder, "", {column.name}).Text(column.name);
}

CampaignRun MakeRun(const Campaign& campaign, const CampaignTree& parts,
                    const CampaignTable::Row& row, const std::vector<KnownSystem>& systems) {
  CampaignRun run;
  run.run = row.run;
  YamlNode tree = parts.base;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const YamlNode::Key& column = parts.table.columns[i];
    const ColumnUse& use = parts.uses[i];
    if (use.is_tag) {
      run.labels.push_back(TagText(row.cells[i], column));
      continue;
    }
    PutPath(tree, column.name, column.place, ValueOf(row.cells[i], column, use));
    if (column.name != "controller") run.labels.push_back(CellText(row.cells[i]));
  }
  PutPath(tree, "name", {}, ScalarNode(campaign.name + " run " + std::to_string(run.run), true));
  RemovePath(tree, "seed");  // the base's own
  run.scenario = ReadScenario(tree, systems);
  run.scenario.seed = WorldSeed(campaign.seed, static_cast<std::uint64_t>(run.run), 0);
  return run;
}

}  // namespace

Campaign LoadCampaign(const std::string& file, const std::vector<std::string>& overrides,
                      const std::vector<KnownSystem>& systems) {
  YamlNode tree = LoadYaml(file);
  for (const std::string& assignment : overrides) SetYaml(tree, assignment);
  RefuseFormerKeys(tree);
  const YamlReader in(tree, "",
                      {"campaign", "seed", "base", "scenario", "values", "tags", "table", "runs"});
  Campaign campaign;
  campaign.name = in.Text("campaign");
  if (campaign.name.size() > 100 || campaign.name[0] == '.' ||
      campaign.name.find('/') != std::string::npos) {
    in.Refuse("campaign", "a name that its results folder can have: up to 100 bytes, no '/'");
  }
  campaign.file = file;
  campaign.seed = in.SeedOr("seed", 1);
  CampaignTree parts{BaseTree(in), ReadTableOf(in, tree), {}};
  parts.uses.resize(parts.table.columns.size());
  ReadTags(in, parts);
  ReadValues(in, parts);
  CheckColumns(parts, systems);
  if (in.Has("scenario")) RefuseKeysOfRuns(in.Child("scenario"), KeysOfRuns(parts));
  for (std::size_t i = 0; i < parts.uses.size(); ++i) {
    const std::string& name = parts.table.columns[i].name;
    if (parts.uses[i].is_tag || name != "controller") campaign.labels.push_back(name);
  }
  for (const CampaignTable::Row& row : parts.table.rows) {
    campaign.runs.push_back(MakeRun(campaign, parts, row, systems));
  }
  campaign.resolved_yaml = ResolvedYaml(campaign, parts);
  return campaign;
}

}  // namespace dockyard
