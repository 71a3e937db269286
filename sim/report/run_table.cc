#include "sim/report/run_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

#include "controller/base/number_text.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

struct UnitGroup {
  const char *unit, *title;
};
// Other units follow under their own name, numbers without one come last.
constexpr UnitGroup kGroups[] = {
    {"m", "Distances"}, {"deg", "Angles"}, {"N", "Forces"}, {"A", "Currents"}, {"s", "Times"}};
constexpr const char* kNoUnit = "Counts and shares";

std::string TitleOf(const std::string& unit) {
  for (const UnitGroup& group : kGroups) {
    if (unit == group.unit) return group.title;
  }
  return unit.empty() ? kNoUnit : "In " + unit;
}

std::vector<std::string> TitlesInOrder(const std::vector<Column>& measures) {
  std::vector<std::string> titles;
  for (const UnitGroup& group : kGroups) titles.push_back(group.title);
  for (const Column& each : measures) {
    const std::string title = TitleOf(each.unit);
    const bool known = std::find(titles.begin(), titles.end(), title) != titles.end();
    if (!known && !each.unit.empty()) titles.push_back(title);
  }
  titles.push_back(kNoUnit);
  return titles;
}

bool EndsWithUnit(const Column& column) {
  std::string end = "_" + column.unit;
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return !column.unit.empty() && column.name.size() > end.size() && column.name.ends_with(end);
}

/// "tip depth" of "tip_depth_m", whose unit is m.
std::string NameOf(const Column& column) {
  std::string name = column.name;
  if (EndsWithUnit(column)) name.resize(name.size() - column.unit.size() - 1);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string TextRow(const std::string& name, const std::string& value, const std::string& meaning) {
  char line[512];
  std::snprintf(line, sizeof line, "  %-22s %-14s %s", name.c_str(), value.c_str(),
                meaning.c_str());
  std::string text = line;
  return text.erase(text.find_last_not_of(' ') + 1) + "\n";
}

std::string WithUnit(double value, const std::string& unit) {
  return FourDigits(value) + (unit.empty() ? "" : " " + unit);
}

std::string Whole(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Lines of the numbers, by title; "" for those of the summary.
std::map<std::string, std::string> LinesByTitle(const RunRecord& record, std::string& without) {
  std::map<std::string, std::string> lines;
  const std::vector<Column>& measures = record.columns.measures;
  for (std::size_t i = 0; i < record.result.measures.size(); ++i) {
    const Column& column = measures[i];
    if (IsMargin(column)) continue;
    const double value = record.result.measures[i];
    if (std::isnan(value)) {
      without += (without.empty() ? "" : ", ") + NameOf(column);
      continue;
    }
    lines[column.headline ? "" : TitleOf(column.unit)] +=
        TextRow(NameOf(column), WithUnit(value, column.unit), column.meaning);
  }
  return lines;
}

}  // namespace

std::string FourDigits(double value) {
  const double size = std::abs(value);
  if (value == 0.0) return "0";  // -0 too
  if (!std::isfinite(value)) return NumberText(value);
  if (size >= 1e9 || size < 1e-6) return Whole("%.3e", value);
  const int decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
  std::string text = Fixed(value, decimals);
  if (text.find('.') == text.npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string RunTable(const std::string& name, const RunRecord& record) {
  const RunResult& row = record.result;
  std::string without;
  std::map<std::string, std::string> lines = LinesByTitle(record, without);
  std::string text = name + " (system " + row.system + ", controller " + row.controller + ")\n";
  text += TextRow("outcome", row.outcome, "");
  text += TextRow("simulated time", WithUnit(row.sim_time_s, "s"),
                  "from the start to the last command");
  text += TextRow("images", std::to_string(row.images), "that the controller was given");
  text += lines[""];
  for (const std::string& title : TitlesInOrder(record.columns.measures)) {
    if (!lines[title].empty()) text += title + "\n" + lines[title];
  }
  if (const JudgedLimit* tightest = TightestLimit(record.limits)) {
    text +=
        TextRow("least margin", WithUnit(tightest->margin(), tightest->unit), LimitText(*tightest));
  }
  text += "This run\n";
  if (!without.empty()) text += TextRow("does not apply", without, "");
  text += TextRow("processor time", WithUnit(record.timing.cpu_time_s, "s"), "");
  text += TextRow("seed", std::to_string(row.seed), "");
  text += TextRow("hash", RowCells(row, record.columns).back(), "of all commands and true states");
  return text;
}

std::string RunSentence(const RunRecord& record) {
  return record.result.outcome + " after " + Fixed(record.result.sim_time_s, 1) + " s" +
         (record.failure_note.empty() ? "" : ": " + record.failure_note);
}

}  // namespace dockyard
