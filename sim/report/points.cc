#include "sim/report/points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "controller/base/check.h"
#include "sim/base/text.h"
#include "sim/log/results.h"
#include "sim/report/rate_text.h"
#include "sim/statistics/intervals.h"
#include "sim/statistics/quantile.h"

namespace dockyard {
namespace {

using Cells = std::vector<std::string>;

void Append(Cells& cells, const Cells& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

std::string MarkdownLine(const Cells& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

Rows AllOf(const std::vector<RunResult>& rows) {
  Rows all;
  for (const RunResult& row : rows) all.push_back(&row);
  return all;
}

int SuccessesOf(const Rows& rows) {
  return static_cast<int>(
      std::count_if(rows.begin(), rows.end(), [](const RunResult* row) { return row->success; }));
}

}  // namespace

std::vector<Column> SummedColumns(const RowColumns& columns) {
  std::vector<Column> made{{kSuccess, "", "whether the outcome is a success", true},
                           {"sim_time_s", "s", "from the start to the last command"}};
  made.insert(made.end(), columns.measures.begin(), columns.measures.end());
  return made;
}

const std::string& LabelOf(const RunResult& row, const RowColumns& columns,
                           const std::string& name) {
  const auto at = std::find(columns.labels.begin(), columns.labels.end(), name);
  if (at != columns.labels.end()) {
    return row.labels[static_cast<std::size_t>(at - columns.labels.begin())];
  }
  DOCKYARD_CHECK(name == "controller");
  return row.controller;
}

Rows UnchangedRows(const std::vector<RunResult>& rows, const RowColumns& columns) {
  const bool told =
      std::find(columns.labels.begin(), columns.labels.end(), "changed") != columns.labels.end();
  Rows unchanged;
  for (const RunResult& row : rows) {
    if (!told || LabelOf(row, columns, "changed").empty()) unchanged.push_back(&row);
  }
  return unchanged;
}

std::vector<Point> ByPoint(const std::vector<std::string>& settings, const RowColumns& columns,
                           const Rows& rows) {
  std::vector<Point> points;
  std::map<Cells, std::size_t> places;
  for (const RunResult* row : rows) {
    Cells cells;
    for (const std::string& label : settings) cells.push_back(LabelOf(*row, columns, label));
    const auto [place, fresh] = places.emplace(cells, points.size());
    if (fresh) points.push_back({cells, {}});
    points[place->second].rows.push_back(row);
  }
  return points;
}

std::vector<std::string> LevelsOf(const Rows& rows, const RowColumns& columns,
                                  const std::string& label) {
  std::vector<std::string> levels;
  std::set<std::string> known;
  for (const RunResult* row : rows) {
    const std::string& text = LabelOf(*row, columns, label);
    if (known.insert(text).second) levels.push_back(text);
  }
  return levels;
}

double SummedValue(const RunResult& row, std::size_t column) {
  if (column == 0) return row.success ? 1.0 : 0.0;
  if (row.measures.empty()) return std::nan("");
  return column == 1 ? row.sim_time_s : row.measures[column - 2];
}

std::vector<double> ValuesOf(const RowColumns& columns, const std::string& measure,
                             const Rows& rows) {
  const std::vector<Column> summed = SummedColumns(columns);
  const auto found = std::find_if(summed.begin(), summed.end(),
                                  [&](const Column& each) { return each.name == measure; });
  DOCKYARD_CHECK(found != summed.end());
  std::vector<double> values;
  for (const RunResult* row : rows) {
    const double value = SummedValue(*row, static_cast<std::size_t>(found - summed.begin()));
    if (!std::isnan(value)) values.push_back(value);
  }
  return values;
}

Spread SpreadOf(const RowColumns& columns, const std::string& measure, const Rows& rows) {
  std::vector<double> values = ValuesOf(columns, measure, rows);
  Spread spread;
  spread.count = static_cast<int>(values.size());
  if (values.empty()) return spread;
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const double value : values) sum += value;
  spread.mean = sum / static_cast<double>(values.size());
  spread.median = SampleQuantile(values, 0.5);
  spread.low = SampleQuantile(values, 0.1);
  spread.high = SampleQuantile(values, 0.9);
  if (measure == kSuccess) {
    const Interval interval = ClopperPearson(static_cast<int>(std::lround(sum)), spread.count);
    spread.median = spread.mean;
    spread.low = interval.low;
    spread.high = interval.high;
  }
  return spread;
}

std::string PointsCsv(const std::vector<std::string>& settings, const RowColumns& columns,
                      const std::vector<RunResult>& rows) {
  const std::vector<Column> summed = SummedColumns(columns);
  Cells header = settings;
  Append(header,
         {"runs", kSuccess, "success_low", "success_high", "docked", "docked_low", "docked_high"});
  for (const Column& column : summed) {
    if (column.name == kSuccess) continue;
    Append(header, {column.name + "_mean", column.name + "_p10", column.name + "_p90"});
  }
  std::string text = SafeCsvLine(header) + "\n";
  for (const Point& point : ByPoint(settings, columns, AllOf(rows))) {
    Cells cells = point.settings;
    const Spread share = SpreadOf(columns, kSuccess, point.rows);
    const Cells share_cells{NumberText(share.mean), NumberText(share.low), NumberText(share.high)};
    cells.push_back(std::to_string(share.count));
    Append(cells, share_cells);
    Append(cells, share_cells);  // under the former name
    for (const Column& column : summed) {
      if (column.name == kSuccess) continue;
      const Spread spread = SpreadOf(columns, column.name, point.rows);
      if (spread.count == 0) {
        Append(cells, {"", "", ""});
      } else {
        Append(cells, {NumberText(spread.mean), NumberText(spread.low), NumberText(spread.high)});
      }
    }
    text += SafeCsvLine(cells) + "\n";
  }
  return text;
}

std::string PointsTable(const std::vector<std::string>& settings,
                        const std::vector<std::string>& measures, const RowColumns& columns,
                        const std::vector<RunResult>& rows) {
  Cells header = settings;
  header.push_back(SuccessWord(columns, rows));
  for (const std::string& name : measures) {
    if (name != kSuccess) header.push_back(name + " (10-90 %)");
  }
  std::string text = MarkdownLine(header), rule = text;
  std::replace_if(
      rule.begin(), rule.end(), [](char c) { return c != '|' && c != '\n'; }, '-');
  text += rule;
  for (const Point& point : ByPoint(settings, columns, AllOf(rows))) {
    Cells cells = point.settings;
    cells.push_back(RateText(SuccessesOf(point.rows), static_cast<int>(point.rows.size())));
    for (const std::string& name : measures) {
      if (name == kSuccess) continue;
      const Spread spread = SpreadOf(columns, name, point.rows);
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
