#include "sim/log/result_row.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <type_traits>
#include <utility>

#include "controller/base/check.h"
#include "sim/base/text.h"

namespace dockyard {
namespace {

template <class T>
std::string IntegerText(T value, int base = 10) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, base);
  return std::string(text, end.ptr);
}

template <class T>
bool ReadInteger(std::string_view text, T& value, int base = 10) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, base);
  return read.ec == std::errc() && read.ptr == end && !text.empty();
}

/// Calls visit(name, kind, field) for every column in order: this is the one list of them. Row is
/// RunResult or const RunResult, with as many labels and measures as there are columns.
template <class Row, class Visit>
void VisitRow(Row& row, const RowColumns& columns, Visit&& visit) {
  visit("run", CellKind::kInteger, row.run);
  visit("seed", CellKind::kSeed, row.seed);
  visit("system", CellKind::kText, row.system);
  visit("controller", CellKind::kText, row.controller);
  for (std::size_t i = 0; i < columns.labels.size(); ++i) {
    visit(columns.labels[i], CellKind::kLabel, row.labels[i]);
  }
  if (!columns.former) {
    visit("success", CellKind::kFlag, row.success);
    visit("success_word", CellKind::kText, row.success_word);
  }
  visit("docked", CellKind::kFlag, row.success);  // the former name
  visit("outcome", CellKind::kText, row.outcome);
  visit("sim_time_s", CellKind::kReal, row.sim_time_s);
  visit("images", CellKind::kInteger, row.images);
  for (std::size_t i = 0; i < columns.measures.size(); ++i) {
    const Column& measure = columns.measures[i];
    if (columns.former && IsMargin(measure)) continue;
    visit(measure.name, CellKind::kMeasure, row.measures[i]);
  }
  visit("state_hash", CellKind::kHash, row.state_hash);
}

template <class T>
std::string CellText(CellKind kind, const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    return value;
  } else if constexpr (std::is_same_v<T, double>) {
    return NumberText(value);
  } else if constexpr (std::is_same_v<T, bool>) {
    return value ? "1" : "0";
  } else {
    const std::string digits = IntegerText(value, kind == CellKind::kHash ? 16 : 10);
    return kind == CellKind::kHash ? std::string(16 - digits.size(), '0') + digits : digits;
  }
}

template <class T>
bool ReadCell(CellKind kind, const std::string& text, T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    value = text;
    return true;
  } else if constexpr (std::is_same_v<T, double>) {
    const auto number = NumberFromText(text);
    value = number.value_or(0.0);
    return number.has_value();
  } else if constexpr (std::is_same_v<T, bool>) {
    value = text == "1";
    return text == "0" || text == "1";
  } else {
    if (kind == CellKind::kHash) return text.size() == 16 && ReadInteger(text, value, 16);
    return ReadInteger(text, value);
  }
}

RunResult EmptyRow(const RowColumns& columns) {
  RunResult row;
  row.labels.resize(columns.labels.size());
  row.measures.resize(columns.measures.size(), std::nan(""));
  row.former = columns.former;
  return row;
}

/// Without case, since SQLite's names have none.
std::string Folded(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

/// The names beside a row's own in outcome.json and in the output of `run --json`.
const std::set<std::string> kNamesBesideTheRow{
    "failure_note", "limits", "cpu_time_s", "wall_time_s", "controller_cpu_s", "controller_wall_s"};

bool IsAnOutcome(const RunResult& row, const RowColumns& columns) {
  if (IsLost(row.outcome)) return !row.success;
  return std::any_of(columns.outcomes.begin(), columns.outcomes.end(),
                     [&](const OutcomeName& each) {
                       return each.name == row.outcome && each.success == row.success;
                     });
}

Json CellJson(CellKind kind, const std::string& cell) {
  switch (kind) {
    case CellKind::kInteger:
    case CellKind::kSeed:
      return Json::parse(cell);
    case CellKind::kReal:
    case CellKind::kMeasure: {
      const double value = NumberFromText(cell).value_or(std::nan(""));
      return std::isfinite(value) ? Json(value) : Json();
    }
    case CellKind::kFlag:
      return cell == "1";
    case CellKind::kText:
    case CellKind::kLabel:
    case CellKind::kHash:
      break;
  }
  return cell;
}

}  // namespace

std::vector<RowColumn> ColumnsOfRow(const RowColumns& columns) {
  std::vector<RowColumn> made;
  std::set<std::string> taken = kNamesBesideTheRow;
  const RunResult row = EmptyRow(columns);
  VisitRow(row, columns, [&](const std::string& name, CellKind kind, const auto&) {
    made.push_back({name, kind});
    const bool fresh = kind == CellKind::kLabel || taken.insert(Folded(name)).second;
    DOCKYARD_CHECK(fresh);  // a system's measure with a name of the head, or of another measure
  });
  for (RowColumn& column : made) {
    if (column.kind != CellKind::kLabel) continue;
    while (!taken.insert(Folded(column.name)).second) column.name = "table." + column.name;
  }
  return made;
}

std::vector<std::string> ColumnNames(const RowColumns& columns) {
  std::vector<std::string> names;
  for (const RowColumn& column : ColumnsOfRow(columns)) names.push_back(column.name);
  return names;
}

std::vector<std::string> RowCells(const RunResult& row, const RowColumns& columns) {
  DOCKYARD_CHECK(row.labels.size() == columns.labels.size());
  const bool measured = !row.measures.empty();
  DOCKYARD_CHECK(!measured || row.measures.size() == columns.measures.size());
  RunResult padded;
  if (!measured) {
    padded = row;
    padded.measures.resize(columns.measures.size());
  }
  std::vector<std::string> cells;
  VisitRow(measured ? row : std::as_const(padded), columns,
           [&](const std::string&, CellKind kind, const auto& value) {
             const bool empty = kind == CellKind::kMeasure && !measured;
             cells.push_back(empty ? std::string() : CellText(kind, value));
           });
  return cells;
}

RowColumns FormerColumns(RowColumns columns) {
  columns.former = true;
  return columns;
}

std::vector<DifferingCell> DifferingCells(const RunResult& then, const RunResult& now,
                                          const RowColumns& all) {
  const RowColumns columns = then.former || now.former ? FormerColumns(all) : all;
  const std::vector<std::string> names = ColumnNames(columns), was = RowCells(then, columns),
                                 is = RowCells(now, columns);
  std::vector<DifferingCell> differing;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (was[i] != is[i]) differing.push_back({names[i], was[i], is[i]});
  }
  return differing;
}

std::string CsvHeader(const RowColumns& columns) { return SafeCsvLine(ColumnNames(columns)); }

std::string CsvRow(const RunResult& row, const RowColumns& columns) {
  return SafeCsvLine(RowCells(row, columns));
}

std::optional<RunResult> RowFromCsv(std::string_view line, const RowColumns& columns) {
  const auto cells = SplitSafeCsv(line);
  return cells ? RowFromCells(*cells, columns) : std::nullopt;
}

std::optional<RunResult> RowFromCells(const std::vector<std::string>& cells,
                                      const RowColumns& columns) {
  RunResult row = EmptyRow(columns);
  std::size_t next = 0, measures = 0, empty = 0;
  bool good = true;
  std::optional<std::string> flag;
  VisitRow(row, columns, [&](const std::string&, CellKind kind, auto& value) {
    good = good && next < cells.size();
    if (!good) return;
    const std::string& cell = cells[next++];
    measures += kind == CellKind::kMeasure;
    // success, and again by its former name
    if (kind == CellKind::kFlag) {
      if (flag && *flag != cell) good = false;
      flag = cell;
    }
    if (kind == CellKind::kMeasure && cell.empty()) {
      ++empty;
    } else {
      good = good && ReadCell(kind, cell, value);
    }
  });
  if (!good || next != cells.size() || !IsAnOutcome(row, columns)) return std::nullopt;
  if (empty == 0) return row;
  if (empty != measures || !IsLost(row.outcome)) return std::nullopt;
  row.measures.clear();
  return row;
}

Json RowJson(const RunResult& row, const RowColumns& columns) {
  const std::vector<RowColumn> named = ColumnsOfRow(columns);
  const std::vector<std::string> cells = RowCells(row, columns);
  Json json;
  for (std::size_t i = 0; i < named.size(); ++i) {
    json[named[i].name] = CellJson(named[i].kind, cells[i]);
  }
  return json;
}

}  // namespace dockyard
