#include "sim/statistics/quantile.h"

#include <algorithm>
#include <cstddef>

#include "controller/base/check.h"

namespace dockyard {

double SampleQuantile(const std::vector<double>& sorted, double share) {
  DOCKYARD_CHECK(!sorted.empty() && share >= 0.0 && share <= 1.0);
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace dockyard
