#include "sim/study/study_results.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "controller/base/check.h"
#include "models/read/config_error.h"
#include "models/read/yaml_reader.h"
#include "sim/base/text.h"
#include "sim/report/rate_text.h"
#include "sim/statistics/intervals.h"

namespace dockyard {
namespace {

constexpr const char* kDockedShare = "docked";

using Cells = std::vector<std::string>;

double Quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

void Append(Cells& cells, const Cells& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

/// The settings of a point: a cell for each factor, then the key changed alone and its value.
Cells Settings(const Study& study, int index) {
  const StudyPoint& point = study.points[static_cast<std::size_t>(index)];
  Cells cells;
  for (std::size_t i = 0; i < study.factors.size(); ++i) {
    cells.push_back(study.factors[i].labels[static_cast<std::size_t>(point.level[i])]);
  }
  if (study.one_at_a_time.empty()) return cells;
  if (point.changed < 0) {
    Append(cells, {"", ""});
  } else {
    const StudyFactor& factor = study.one_at_a_time[static_cast<std::size_t>(point.changed)];
    Append(cells, {factor.key, factor.labels[static_cast<std::size_t>(point.changed_level)]});
  }
  return cells;
}

Cells SettingNames(const Study& study) {
  Cells names;
  for (const StudyFactor& factor : study.factors) names.push_back(factor.key);
  if (!study.one_at_a_time.empty()) Append(names, {"changed", "changed_to"});
  return names;
}

std::string MarkdownLine(const Cells& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

/// Points that share one line: all with the same settings. In the order of the points.
std::vector<std::pair<int, std::vector<const StudyRow*>>> ByPoint(
    const std::vector<StudyRow>& rows) {
  std::map<int, std::vector<const StudyRow*>> groups;
  for (const StudyRow& row : rows) groups[row.point].push_back(&row);
  return {groups.begin(), groups.end()};
}

}  // namespace

std::vector<Column> StudyColumns(const RowColumns& columns) {
  std::vector<Column> made{{kDockedShare, "", "whether the outcome is a success", true},
                           {"sim_time_s", "s", "from the start to the end of the run"}};
  made.insert(made.end(), columns.measures.begin(), columns.measures.end());
  return made;
}

std::vector<double> MeasuresOf(const RunResult& row) {
  std::vector<double> values{row.docked ? 1.0 : 0.0, row.sim_time_s};
  values.insert(values.end(), row.measures.begin(), row.measures.end());
  return values;
}

void CheckMeasures(const Study& study, const RowColumns& columns) {
  std::vector<std::string> known;
  for (const Column& column : StudyColumns(columns)) known.push_back(column.name);
  for (const std::string& measure : study.measures) {
    if (std::find(known.begin(), known.end(), measure) != known.end()) continue;
    const std::string near = NearestName(measure, known);
    throw ConfigError("study " + study.name +
                      ": plot.measures: expected a column of runs.csv, found '" + measure + "'" +
                      (near.empty() ? "" : "; nearest is '" + near + "'"));
  }
}

Spread SpreadOf(const std::vector<Column>& study_columns, const std::string& measure,
                const std::vector<const StudyRow*>& rows) {
  Spread spread;
  const auto found = std::find_if(study_columns.begin(), study_columns.end(),
                                  [&](const Column& each) { return each.name == measure; });
  DOCKYARD_CHECK(found != study_columns.end());
  const auto column = static_cast<std::size_t>(found - study_columns.begin());
  std::vector<double> values;
  for (const StudyRow* row : rows) {
    if (!row->measures.empty() && !std::isnan(row->measures[column])) {
      values.push_back(row->measures[column]);
    }
  }
  spread.count = static_cast<int>(values.size());
  if (values.empty()) return spread;
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const double value : values) sum += value;
  spread.mean = sum / static_cast<double>(values.size());
  spread.median = Quantile(values, 0.5);
  spread.low = Quantile(values, 0.1);
  spread.high = Quantile(values, 0.9);
  if (measure == kDockedShare) {
    const Interval interval = ClopperPearson(static_cast<int>(std::lround(sum)), spread.count);
    spread.median = spread.mean;
    spread.low = interval.low;
    spread.high = interval.high;
  }
  return spread;
}

std::string StudyRunsCsv(const Study& study, const RowColumns& columns,
                         const std::vector<StudyRow>& rows) {
  const std::vector<Column> measured = StudyColumns(columns);
  Cells header{"run", "seed"};
  Append(header, SettingNames(study));
  header.push_back("outcome");
  for (const Column& column : measured) header.push_back(column.name);
  std::string text = CsvLine(header) + "\n";
  for (const StudyRow& row : rows) {
    Cells cells{std::to_string(row.run), std::to_string(row.seed)};
    Append(cells, Settings(study, row.point));
    cells.push_back(row.outcome);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      cells.push_back(row.measures.empty() ? "" : NumberText(row.measures[i]));
    }
    text += CsvLine(cells) + "\n";
  }
  return text;
}

std::string StudyPointsCsv(const Study& study, const RowColumns& columns,
                           const std::vector<StudyRow>& rows) {
  const std::vector<Column> measured = StudyColumns(columns);
  Cells header = SettingNames(study);
  Append(header, {"runs", kDockedShare, "docked_low", "docked_high"});
  for (const Column& column : measured) {
    if (column.name == kDockedShare) continue;
    Append(header, {column.name + "_mean", column.name + "_p10", column.name + "_p90"});
  }
  std::string text = CsvLine(header) + "\n";
  for (const auto& [point, group] : ByPoint(rows)) {
    Cells cells = Settings(study, point);
    const Spread share = SpreadOf(measured, kDockedShare, group);
    Append(cells, {std::to_string(share.count), NumberText(share.mean), NumberText(share.low),
                   NumberText(share.high)});
    for (const Column& column : measured) {
      if (column.name == kDockedShare) continue;
      const Spread spread = SpreadOf(measured, column.name, group);
      if (spread.count == 0) {
        Append(cells, {"", "", ""});
      } else {
        Append(cells, {NumberText(spread.mean), NumberText(spread.low), NumberText(spread.high)});
      }
    }
    text += CsvLine(cells) + "\n";
  }
  return text;
}

std::string StudyTable(const Study& study, const RowColumns& columns,
                       const std::vector<StudyRow>& rows) {
  const std::vector<Column> measured = StudyColumns(columns);
  Cells header;
  for (const StudyFactor& factor : study.factors) header.push_back(factor.key);
  if (!study.one_at_a_time.empty()) Append(header, {"changed", "to"});
  header.push_back(kDockedShare);
  for (const std::string& name : study.measures) {
    if (name != kDockedShare) header.push_back(name + " (10-90 %)");
  }
  std::string text = MarkdownLine(header), rule = text;
  std::replace_if(
      rule.begin(), rule.end(), [](char c) { return c != '|' && c != '\n'; }, '-');
  text += rule;
  for (const auto& [point, group] : ByPoint(rows)) {
    Cells cells = Settings(study, point);
    const Spread share = SpreadOf(measured, kDockedShare, group);
    cells.push_back(RateText(static_cast<int>(std::lround(share.mean * share.count)), share.count));
    for (const std::string& name : study.measures) {
      if (name == kDockedShare) continue;
      const Spread spread = SpreadOf(measured, name, group);
      cells.push_back(spread.count == 0
                          ? ""
                          : BriefNumber(spread.median) + " (" + BriefNumber(spread.low) + " to " +
                                BriefNumber(spread.high) + ")");
    }
    text += MarkdownLine(cells);
  }
  return text;
}

}  // namespace dockyard
