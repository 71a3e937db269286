#include "sim/plan/table.h"

#include <algorithm>
#include <set>

#include "models/read/config_error.h"
#include "models/read/csv_table.h"
#include "models/read/near_names.h"
#include "models/read/yaml_reader.h"
#include "sim/plan/factor.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxRuns = 1000000;

[[noreturn]] void RefuseColumn(const YamlNode::Key& column, const std::string& expected) {
  throw ConfigError(column.place.Text() + ": " + column.name + ": expected " + expected);
}

std::string HeadOf(const std::string& path) { return path.substr(0, path.find('.')); }

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The columns of a row of results beside its labels.
bool IsResultColumn(const std::string& name) {
  static const std::vector<std::string> columns{
      "run",    "seed",    "system", "controller", "success",   "success_word",
      "docked", "outcome", "images", "sim_time_s", "state_hash"};
  return Contains(columns, name);
}

const std::vector<std::string>& PlanColumns() {
  static const std::vector<std::string> columns{"seed",   "arm",     "point",
                                                "repeat", "changed", "changed_to"};
  return columns;
}

RunTable::Row ReadRow(const YamlReader& in, const std::vector<std::string>& columns) {
  RunTable::Row row;
  row.run = in.Integer("run", 0, 2000000000);
  row.cells.reserve(columns.size());
  for (const std::string& column : columns) {
    row.cells.push_back(in.Child(column));
    YamlNode& cell = row.cells.back();
    const bool may_be_empty = column == "changed" || column == "changed_to";
    if (cell.kind == YamlNode::Kind::kNull && !may_be_empty) in.Refuse(column, "a value");
    if (cell.scalar == "null") cell.quoted = true;  // from CSV: a text, also in YAML
  }
  return row;
}

/// Whether the column's cells are values of this key. A column without a single good cell holds
/// names that the campaign's file gives values.
bool CheckCells(const RunTable& table, std::size_t column) {
  const YamlNode::Key& key = table.columns[column];
  std::size_t good = 0;
  std::string first_fault;
  for (const RunTable::Row& row : table.rows) {
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

std::optional<std::size_t> RunTable::Find(const std::string& column) const {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name == column) return i;
  }
  return std::nullopt;
}

bool IsPlanColumn(const std::string& name) { return Contains(PlanColumns(), name); }

RunTable ReadTable(const YamlNode& list, const std::string& path) {
  if (list.items.empty() || list.items.size() > kMaxRuns) {
    throw ConfigError(list.place.Text() + ": expected 1 to " + std::to_string(kMaxRuns) +
                      " runs, found " + std::to_string(list.items.size()));
  }
  RunTable table;
  std::vector<std::string> known{"run"};
  for (const YamlNode::Key& key : list.items[0].keys) {
    if (key.name == "run") continue;
    if (DiffersInCaseAlone(key.name, "run") && list.items[0].Find("run") == nullptr) {
      throw ConfigError(key.place.Text() + ": " + key.name +
                        ": unknown column, did you mean 'run'?");
    }
    table.columns.push_back(key);
    known.push_back(key.name);
  }
  const std::vector<std::string> names(known.begin() + 1, known.end());
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
  if (IsPlanColumn(name) && !is_tag) return;
  if (is_tag) {
    if (is_key) RefuseColumn(column, "a tag that is no key of a scenario");
    if (IsResultColumn(name)) RefuseColumn(column, "a tag that is no column of every result");
    return;
  }
  for (const char* former : {"r_m", "alpha_deg", "heading_deg"}) {
    if (name == former) RefuseColumn(column, "the key 'start." + name + "' instead");
  }
  RequireSettable(column, name);
  if (is_key) return;
  std::vector<std::string> known = scenario_keys;
  known.insert(known.end(), PlanColumns().begin(), PlanColumns().end());
  const std::string nearest = NearestName(name, known);
  RefuseColumn(column, "a key of the scenario or one of the campaign's tags" +
                           (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

TableCheck CheckRunTable(const std::string& file) {
  const RunTable table = ReadTable(LoadCsv(file), "");
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
