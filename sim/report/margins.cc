#include "sim/report/margins.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "sim/statistics/quantile.h"

namespace dockyard {

std::vector<LimitOverRuns> LimitsOverRuns(const RowColumns& columns,
                                          const std::vector<RunResult>& rows) {
  std::vector<std::pair<double, LimitOverRuns>> found;  // with the least margin as a share
  for (std::size_t m = 0; m < columns.measures.size(); ++m) {
    const Column& column = columns.measures[m];
    if (!IsMargin(column)) continue;
    LimitOverRuns limit{column.name.substr(column.name.find('.') + 1), column.unit, column.meaning};
    std::vector<double> of_successes;
    for (const RunResult& row : rows) {
      if (row.measures.empty() || std::isnan(row.measures[m])) continue;
      const double margin = row.measures[m];
      ++limit.judged;
      limit.broken += margin < 0.0;
      if (!row.success) continue;
      of_successes.push_back(margin);
      if (limit.least != nullptr && limit.least_margin <= margin) continue;
      limit.least = &row;
      limit.least_margin = margin;
    }
    if (limit.judged == 0) continue;
    std::sort(of_successes.begin(), of_successes.end());
    const double median = of_successes.empty() ? 0.0 : SampleQuantile(of_successes, 0.5);
    found.push_back({median > 0.0 ? limit.least_margin / median : 1.0, std::move(limit)});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::tuple(-a.second.broken, a.first) < std::tuple(-b.second.broken, b.first);
  });
  std::vector<LimitOverRuns> limits;
  for (auto& each : found) limits.push_back(std::move(each.second));
  return limits;
}

}  // namespace dockyard
