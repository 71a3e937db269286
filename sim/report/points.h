// The results of a campaign point by point: what all runs with the same settings came to.
#pragma once

#include <string>
#include <vector>

#include "sim/log/record.h"
#include "sim/plan/campaign.h"

namespace dockyard {

inline constexpr const char* kSuccess = "success";  // or "docked", the former name

/// The columns of a result that can be summed up: success (1 or 0), sim_time_s, then the system's
/// measures.
std::vector<Column> SummedColumns(const RowColumns& columns);

/// A result's label by its name, or its controller. The name must be known.
const std::string& LabelOf(const RunResult& row, const RowColumns& columns,
                           const std::string& name);

using Rows = std::vector<const RunResult*>;
/// Those in which no key was changed alone, where that is told.
Rows UnchangedRows(const std::vector<RunResult>& rows, const RowColumns& columns);
/// Rows with the same settings.
struct Point {
  std::vector<std::string> settings;  // their texts
  Rows rows;
};
/// In the order in which the settings first appear. Settings are labels.
std::vector<Point> ByPoint(const std::vector<std::string>& settings, const RowColumns& columns,
                           const Rows& rows);
/// The texts of a label in the order in which they first appear.
std::vector<std::string> LevelsOf(const Rows& rows, const RowColumns& columns,
                                  const std::string& label);

/// A row's value in a summed column, by its place; NaN for what a row does not have.
double SummedValue(const RunResult& row, std::size_t column);

/// The values of one of the summed columns, without those that a row does not have: NaN, and all
/// but `success` of a crashed run.
std::vector<double> ValuesOf(const RowColumns& columns, const std::string& measure,
                             const Rows& rows);

struct Spread {
  int count = 0;  // of the rows that have the measure
  double mean = 0.0, median = 0.0;
  double low = 0.0, high = 0.0;  // of a share: 95 % Clopper-Pearson; else 10 and 90 % quantiles
};
/// Of ValuesOf.
Spread SpreadOf(const RowColumns& columns, const std::string& measure, const Rows& rows);

/// A line per point: its settings, then the results. Settings are labels.
std::string PointsCsv(const std::vector<std::string>& settings, const RowColumns& columns,
                      const std::vector<RunResult>& rows);
/// The same for people, in Markdown: rates with their intervals, and these measures.
std::string PointsTable(const std::vector<std::string>& settings,
                        const std::vector<std::string>& measures, const RowColumns& columns,
                        const std::vector<RunResult>& rows);

/// Curves of the measures over the label x as SVG, a row of plots for each measure, with bands as
/// in Spread. Labels that are neither x, curves nor panels are pooled. Empty without x.
std::string CurvesPlot(const std::string& title, const Figures& figures, const RowColumns& columns,
                       const std::vector<RunResult>& rows);
/// Bars as SVG: how each key changed alone changes the share of successes, and the mean of the
/// first other measure, if there is one; longest first. Empty when no key was changed alone.
std::string BarsPlot(const std::string& title, const std::vector<std::string>& measures,
                     const RowColumns& columns, const std::vector<RunResult>& rows);

}  // namespace dockyard
