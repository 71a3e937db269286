#include "sim/scenario/campaign_table.h"

#include <algorithm>
#include <set>

#include "models/read/config_error.h"
#include "models/read/csv_table.h"
#include "models/read/yaml_reader.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/load_scenario.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxRuns = 100000;

[[noreturn]] void RefuseColumn(const YamlNode::Key& column, const std::string& expected) {
  throw ConfigError(column.place.Text() + ": " + column.name + ": expected " + expected);
}

std::string HeadOf(const std::string& path) { return path.substr(0, path.find('.')); }

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The columns of a row of results beside its labels.
bool IsResultColumn(const std::string& name) {
  static const std::vector<std::string> columns{"run",        "seed",       "system",
                                                "controller", "docked",     "outcome",
                                                "images",     "sim_time_s", "state_hash"};
  return Contains(columns, name);
}

CampaignTable::Row ReadRow(const YamlReader& in, const std::vector<std::string>& columns) {
  CampaignTable::Row row;
  row.run = in.Integer("run", 0, 1000000);
  row.cells.reserve(columns.size());
  for (const std::string& column : columns) {
    row.cells.push_back(in.Child(column));
    YamlNode& cell = row.cells.back();
    if (cell.kind == YamlNode::Kind::kNull) in.Refuse(column, "a value");
    if (cell.scalar == "null") cell.quoted = true;  // from CSV: a text, also in YAML
  }
  return row;
}

/// Whether the column's cells are values of this key. A column without a single good cell holds
/// names that the campaign's file gives values.
bool CheckCells(const CampaignTable& table, std::size_t column) {
  const YamlNode::Key& key = table.columns[column];
  std::size_t good = 0;
  std::string first_fault;
  for (const CampaignTable::Row& row : table.rows) {
    YamlNode tree;
    PutPath(tree, key.name, key.place, row.cells[column]);
    Scenario scenario;
    try {
      ReadSomeKeys(tree, "", [&](Keys& keys) { VisitScenario(keys, scenario, {}); });
      ++good;
    } catch (const ConfigError& error) {
      if (first_fault.empty()) first_fault = error.what();
    }
  }
  if (good > 0 && !first_fault.empty()) throw ConfigError(first_fault);
  return good > 0;
}

/// Whether the values of the key can be checked from the text of a cell alone.
bool IsPlain(const KeyRow& row) {
  using enum KeyRow::Kind;
  return row.key != "controller" &&
         (row.kind == kNumber || row.kind == kInteger || row.kind == kBool || row.kind == kWord);
}

}  // namespace

std::vector<std::string> CampaignTable::Names() const {
  std::vector<std::string> names;
  for (const YamlNode::Key& column : columns) names.push_back(column.name);
  return names;
}

std::string CellText(const YamlNode& cell) {
  return cell.kind == YamlNode::Kind::kScalar ? cell.scalar : FlowText(cell);
}

CampaignTable ReadTable(const YamlNode& list, const std::string& path) {
  if (list.items.empty() || list.items.size() > kMaxRuns) {
    throw ConfigError(list.place.Text() + ": expected 1 to " + std::to_string(kMaxRuns) +
                      " runs, found " + std::to_string(list.items.size()));
  }
  CampaignTable table;
  std::vector<std::string> known{"run"};
  for (const YamlNode::Key& key : list.items[0].keys) {
    if (key.name == "run") continue;
    table.columns.push_back(key);
    known.push_back(key.name);
  }
  const std::vector<std::string> names = table.Names();
  std::set<int> seen;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    // A table's rows need no path: the file and line say where.
    const YamlReader in(list.items[i], path.empty() ? "" : YamlReader::PathOf(path, i), known);
    table.rows.push_back(ReadRow(in, names));
    if (!seen.insert(table.rows.back().run).second) {
      in.Refuse("run", "a number that no other run has");
    }
  }
  return table;
}

void CheckColumn(const YamlNode::Key& column, bool is_tag,
                 const std::vector<std::string>& scenario_keys) {
  const std::string& name = column.name;
  const bool is_key = Contains(scenario_keys, HeadOf(name));
  if (is_tag) {
    if (is_key) RefuseColumn(column, "a tag that is no key of a scenario");
    if (IsResultColumn(name)) RefuseColumn(column, "a tag that is no column of every result");
    return;
  }
  for (const char* former : {"r_m", "alpha_deg", "heading_deg"}) {
    if (name == former) RefuseColumn(column, "the key 'start." + name + "' instead");
  }
  for (const char* of_campaign : {"name", "seed", "system"}) {
    if (name != of_campaign) continue;
    RefuseColumn(column,
                 "no such column; name and seed follow from the run's number, all runs are "
                 "of one system");
  }
  if (is_key) return;
  const std::string nearest = NearestName(name, scenario_keys);
  RefuseColumn(column, "a key of the scenario or one of the campaign's tags" +
                           (nearest.empty() ? "" : "; nearest key is '" + nearest + "'"));
}

TableCheck CheckCampaignTable(const std::string& file) {
  const CampaignTable table = ReadTable(LoadCsv(file), "");
  const std::vector<KeyRow> rows = ScenarioRows();
  TableCheck check;
  check.runs = static_cast<int>(table.rows.size());
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string& name = table.columns[i].name;
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const KeyRow& known) { return known.key == name; });
    if (row != rows.end() || name == "r_m" || name == "alpha_deg" || name == "heading_deg") {
      CheckColumn(table.columns[i], false, {HeadOf(name)});
    }
    const bool checked = row != rows.end() && IsPlain(*row) && CheckCells(table, i);
    (checked ? check.checked : check.left_to_campaign).push_back(name);
  }
  return check;
}

}  // namespace dockyard
