// A survey's curves over range.
#pragma once

#include <string>
#include <vector>

#include "perception/survey_score.h"

namespace dockyard::axel {

struct SurveyCurve {
  std::string name;   // "dockyard, even"
  std::string color;  // "#1f5fbf"
  std::string dash;
  std::vector<SampleScore> scores;
  bool ours = true;  // dockyard's
};

/// SVG: share of poses accepted, range error and heading error (rms), centre error, each by metre
/// of range with its 95 % interval.
std::string SurveyPlot(const std::string& title, const std::vector<SurveyCurve>& curves,
                       double r_max_m);

/// One line for each curve and metre: counts, rates and errors with their intervals.
std::string SurveyCsv(const std::vector<SurveyCurve>& curves, double r_max_m);

}  // namespace dockyard::axel
