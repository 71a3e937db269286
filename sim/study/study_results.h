// What a study's runs came to, and what is said of them together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/study.h"
#include "sim/run/record.h"

namespace dockyard {

struct StudyRow {
  int run = 0;    // from 1
  int point = 0;  // index in Study::points
  std::uint64_t seed = 0;
  std::string outcome;           // as in docs/outcomes.md
  std::vector<double> measures;  // by StudyMeasures
};

/// Measures of one run. Angles of arm and roll and what the entry took come from its 10 Hz history;
/// NaN: does not apply, and counts in no spread.
std::vector<double> MeasuresOf(const RunRecord& record);

/// Index of a measure's column; it must be one.
std::size_t MeasureIndex(const std::string& name);

/// Rows of one curve's one place, told together.
struct Spread {
  int count = 0;
  double mean = 0.0, median = 0.0;
  double low = 0.0, high = 0.0;  // of a share: 95 % Clopper-Pearson; else 10 and 90 % quantiles
};
Spread SpreadOf(const std::string& measure, const std::vector<const StudyRow*>& rows);

/// A line per run, and a line per point: what was set, then what came out.
std::string StudyRunsCsv(const Study& study, const std::vector<StudyRow>& rows);
std::string StudyPointsCsv(const Study& study, const std::vector<StudyRow>& rows);
/// The same per point for people, rates with their intervals.
std::string StudyTable(const Study& study, const std::vector<StudyRow>& rows);

/// Curves of the study's measures over its x, a row of plots for each measure, with bands as in
/// Spread. Factors that are neither x, curves nor panels are pooled. Empty without x.
std::string StudyCurves(const Study& study, const std::vector<StudyRow>& rows);
/// Bars of what each key changed alone does to the docked share and the tension's mean peak,
/// longest first. Empty when no key was changed alone.
std::string StudyBars(const Study& study, const std::vector<StudyRow>& rows);

}  // namespace dockyard
