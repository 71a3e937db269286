// The results of a study's runs, and their summaries.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/log/record.h"
#include "sim/scenario/study.h"

namespace dockyard {

struct StudyRow {
  int run = 0;    // from 1
  int point = 0;  // index in Study::points
  std::uint64_t seed = 0;
  std::string outcome;           // one of the system's
  std::vector<double> measures;  // by StudyColumns; empty for a run that crashed
};

/// The measures of a study of this system, the columns of its runs.csv: docked (1 or 0),
/// sim_time_s, then the system's measures.
std::vector<Column> StudyColumns(const RowColumns& columns);
/// By StudyColumns. NaN: does not apply, and counts in no spread.
std::vector<double> MeasuresOf(const RunResult& row);
/// Throws ConfigError when the study's plot names a measure that is none of StudyColumns.
void CheckMeasures(const Study& study, const RowColumns& columns);

/// The summary of the rows at one place of one curve.
struct Spread {
  int count = 0;
  double mean = 0.0, median = 0.0;
  double low = 0.0, high = 0.0;  // of a share: 95 % Clopper-Pearson; else 10 and 90 % quantiles
};
/// @param measure  name of one of the columns
Spread SpreadOf(const std::vector<Column>& study_columns, const std::string& measure,
                const std::vector<const StudyRow*>& rows);

/// A line per run, and a line per point: the settings, then the results.
std::string StudyRunsCsv(const Study& study, const RowColumns& columns,
                         const std::vector<StudyRow>& rows);
std::string StudyPointsCsv(const Study& study, const RowColumns& columns,
                           const std::vector<StudyRow>& rows);
/// The same per point as text for people, rates with their intervals.
std::string StudyTable(const Study& study, const RowColumns& columns,
                       const std::vector<StudyRow>& rows);

/// Curves of the study's measures over its x, a row of plots for each measure, with bands as in
/// Spread. Factors that are neither x, curves nor panels are pooled. Empty without x.
std::string StudyCurves(const Study& study, const RowColumns& columns,
                        const std::vector<StudyRow>& rows);
/// Bars of how each key changed alone changes the docked share, and the mean of the first other
/// measure of the study's plot, if it has one; longest first. Empty when no key was changed alone.
std::string StudyBars(const Study& study, const RowColumns& columns,
                      const std::vector<StudyRow>& rows);

}  // namespace dockyard
