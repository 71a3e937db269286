#include "sim/report/requirement.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/count_text.h"
#include "sim/base/text.h"
#include "sim/report/points.h"
#include "sim/report/rate_text.h"
#include "sim/statistics/intervals.h"
#include "sim/statistics/quantile.h"

namespace dockyard {
namespace {

using Statistic = Requirement::Statistic;

Rows RowsWhere(const Requirement& requirement, const RowColumns& columns,
               const std::vector<RunResult>& rows) {
  Rows chosen;
  for (const RunResult& row : rows) {
    const bool fits = std::all_of(
        requirement.where.begin(), requirement.where.end(),
        [&](const auto& where) { return LabelOf(row, columns, where.first) == where.second; });
    if (fits) chosen.push_back(&row);
  }
  return chosen;
}

struct Found {
  int count = 0;
  double value = std::nan("");
  std::string detail;  // what the value came from
};

Found ShareOf(const Requirement& requirement, const Rows& rows) {
  const auto hits = std::count_if(rows.begin(), rows.end(), [&](const RunResult* row) {
    return requirement.outcome ? row->outcome == requirement.figure : row->success;
  });
  const int hit = static_cast<int>(hits), count = static_cast<int>(rows.size());
  Found found{count, std::nan(""), std::to_string(hit) + "/" + std::to_string(count)};
  if (count == 0) return found;
  if (requirement.statistic == Statistic::kLower) {
    found.value = LowerBound(hit, count, requirement.level);
  } else if (requirement.statistic == Statistic::kUpper) {
    found.value = UpperBound(hit, count, requirement.level);
  } else {
    found.value = static_cast<double>(hit) / count;
  }
  return found;
}

Found StatisticOf(const Requirement& requirement, const RowColumns& columns, const Rows& rows) {
  std::vector<double> values = ValuesOf(columns, requirement.figure, rows);
  Found found{static_cast<int>(values.size()), std::nan(""),
              "of " + CountText(values.size(), "run")};
  if (values.empty()) return found;
  if (requirement.statistic == Statistic::kMean) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    found.value = sum / static_cast<double>(values.size());
  } else {
    std::sort(values.begin(), values.end());
    found.value = SampleQuantile(values, requirement.level);
  }
  return found;
}

bool IsMet(const Requirement& requirement, double found) {
  switch (requirement.relation) {
    case Requirement::Relation::kAtLeast:
      return found >= requirement.limit;
    case Requirement::Relation::kAbove:
      return found > requirement.limit;
    case Requirement::Relation::kAtMost:
      return found <= requirement.limit;
    case Requirement::Relation::kBelow:
      return found < requirement.limit;
  }
  return false;
}

}  // namespace

Judgement Judge(const Requirement& requirement, const RowColumns& columns,
                const std::vector<RunResult>& rows) {
  const Rows chosen = RowsWhere(requirement, columns, rows);
  const bool share = requirement.outcome || requirement.figure == kSuccess;
  const Found found =
      share ? ShareOf(requirement, chosen) : StatisticOf(requirement, columns, chosen);
  Judgement judged{requirement, IsMet(requirement, found.value), found.count, found.value, ""};
  judged.text = std::string(judged.met ? "met" : "not met") + ": " + requirement.text + ", found ";
  judged.text +=
      found.count == 0 ? "no run to judge" : BriefNumber(found.value) + " (" + found.detail + ")";
  return judged;
}

}  // namespace dockyard
