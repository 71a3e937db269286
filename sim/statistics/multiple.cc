#include "sim/statistics/multiple.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "controller/base/check.h"

namespace dockyard {

std::vector<double> HolmAdjusted(const std::vector<double>& p) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!std::isnan(p[i])) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted = p;
  double least = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto left = static_cast<double>(order.size() - i);
    least = std::max(least, std::min(1.0, left * p[order[i]]));
    adjusted[order[i]] = least;
  }
  return adjusted;
}

double ConfidenceOfEach(double confidence, int count) {
  DOCKYARD_CHECK(count >= 1 && confidence > 0.0 && confidence < 1.0);
  return 1.0 - (1.0 - confidence) / count;
}

}  // namespace dockyard
