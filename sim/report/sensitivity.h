// How strongly success, and each measure, depends on what a campaign draws.
//
// Two questions are kept apart. Does the measure depend on the draw at all? eta says so, whatever
// the shape: the square root of the correlation ratio of ranks between the draw's levels, corrected
// for chance (sim/statistics/levels.h). A word's levels are its texts, a number is cut into up to
// ten levels of as many runs. Does it rise or fall with a number? The rank correlation says so, and
// the partial one leaves out what goes by the other draws (sim/statistics/ranks.h).
#pragma once

#include <string>
#include <vector>

#include "sim/log/record.h"
#include "sim/plan/campaign.h"
#include "sim/statistics/intervals.h"

namespace dockyard {

/// A measure's dependence on one draw. NaN: it cannot be told.
struct DrawEffect {
  std::string label;
  bool words = false;    // its values have no order: no correlations
  double eta = 0.0;      // 0 to 1
  double p_value = 1.0;  // the chance of so large an eta, or a larger, if the draw did not matter
  double holm_p = 1.0;   // the same for all draws of the measure together (Holm)
  Estimate rank_correlation, partial;
};

struct MeasureEffects {
  Column measure;
  int runs = 0;                   // those that have the measure
  std::vector<DrawEffect> draws;  // by eta, the largest first; those without one last
};

/// The success rate over a draw, level by level.
struct LevelRate {
  std::string label, word;       // the level's text where the draw's values are words
  double low = 0.0, high = 0.0;  // the smallest and largest number of the level, else NaN
  int successes = 0, runs = 0;
};

/// A list by eta of fewer runs is mostly chance.
inline constexpr int kLeastRunsPerDraw = 5;

/// Of one arm, as arms share their draws: rows of two arms are not independent.
struct Sensitivity {
  std::string arm;  // empty: the campaign has none
  int runs = 0;
  int draws = 0;                         // keys that are drawn
  std::vector<MeasureEffects> measures;  // success first, then as SummedColumns
  std::vector<LevelRate> rates;          // by label as in the campaign, levels in their order

  bool too_few() const { return runs < kLeastRunsPerDraw * draws; }
};

/// Why an arm with too few runs has no list: a sentence; empty where it has one.
std::string TooFewText(const Sensitivity& arm);

/// Empty for a campaign without draws. A measure with fewer than kLeastRunsPerDraw runs for each
/// draw has no effects. Rows in which a key was changed alone are left out. A draw
/// of numbers, such as {discrete: {values: [20, 35]}}, counts as a number. 10^6 rows of 40 draws
/// and 20 measures took 27 s of CPU.
std::vector<Sensitivity> FindSensitivity(const Campaign& campaign, const RowColumns& columns,
                                         const std::vector<RunResult>& rows);

/// sensitivity.csv: a line for each arm, measure and draw.
std::string SensitivityCsv(const std::vector<Sensitivity>& found);
/// sensitivity_levels.csv: a line for each arm, draw and level.
std::string SensitivityLevelsCsv(const std::vector<Sensitivity>& found);
/// For the summary: success over the draws it depends on most. Empty where nothing was found.
std::string SensitivityText(const std::vector<Sensitivity>& found);
/// Bars with their intervals as SVG, success alone. Empty where success does not vary.
std::string SensitivityPlot(const std::string& title, const std::vector<Sensitivity>& found);

}  // namespace dockyard
