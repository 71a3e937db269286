// A verdict on the reliability of each point of a campaign, such as each slope of a grid, with one
// risk for all of them together.
#pragma once

#include <string>
#include <vector>

#include "sim/base/json.h"
#include "sim/report/points.h"
#include "sim/statistics/acceptance.h"

namespace dockyard {

struct PointVerdict {
  std::vector<std::string> values;  // by key
  int runs = 0, failures = 0;
  Acceptance found;
};

struct PointVerdicts {
  std::vector<std::string> keys;
  double reliability = 0.0;
  double confidence = 0.0;          // that no point below the reliability is accepted
  double confidence_of_each = 0.0;  // of a point alone (sim/statistics/multiple.h)
  std::vector<PointVerdict> points;

  /// Accepted if each point is, not accepted if one is not; else, or without points, undecided.
  AcceptanceVerdict verdict() const;
};

/// @param keys  labels; rows with equal texts of all of them are a point
PointVerdicts JudgePoints(const std::vector<std::string>& keys, const RowColumns& columns,
                          const Rows& rows, double reliability, double confidence);

/// Without `warnings`: {verdict, trials, failures, reliability, confidence, by, points,
/// family_error, correction, confidence_of_each}.
Json PointVerdictsJson(const PointVerdicts& judged, AcceptanceVerdict verdict);
/// A line for each point, then what they come to.
std::string PointVerdictsText(const PointVerdicts& judged, AcceptanceVerdict verdict);

}  // namespace dockyard
