#include "sim/statistics/levels.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cstddef>
#include <limits>
#include <numeric>

#include "controller/base/check.h"

namespace dockyard {
namespace {

struct Sum {
  double values = 0.0, runs = 0.0;
};

}  // namespace

LevelEffect EffectOfLevels(const std::vector<int>& levels, const std::vector<double>& values) {
  DOCKYARD_CHECK(levels.size() == values.size());
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const LevelEffect unknown{kNaN, kNaN, kNaN};
  if (values.empty()) return unknown;
  const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
  DOCKYARD_CHECK(*least >= 0);
  std::vector<Sum> sums(static_cast<std::size_t>(*most) + 1);
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double total = 0.0, between = 0.0, occupied = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = values[i] - mean;
    Sum& sum = sums[static_cast<std::size_t>(levels[i])];
    sum.values += off;
    sum.runs += 1.0;
    total += off * off;
  }
  for (const Sum& sum : sums) {
    if (sum.runs == 0.0) continue;
    occupied += 1.0;
    between += sum.values * sum.values / sum.runs;
  }
  if (occupied < 2.0 || n <= occupied || !(total > 0.0)) return unknown;
  LevelEffect effect;
  effect.eta_squared = std::min(between / total, 1.0);
  effect.epsilon_squared =
      std::max(0.0, 1.0 - (1.0 - effect.eta_squared) * (n - 1.0) / (n - occupied));
  effect.p_value =
      boost::math::gamma_q(0.5 * (occupied - 1.0), 0.5 * (n - 1.0) * effect.eta_squared);
  return effect;
}

std::vector<int> LevelsOfRanks(const std::vector<double>& ranks, int count) {
  DOCKYARD_CHECK(count >= 1);
  std::vector<int> levels;
  levels.reserve(ranks.size());
  const auto n = static_cast<double>(ranks.size());
  for (const double rank : ranks) {
    levels.push_back(std::min(count - 1, static_cast<int>((rank - 0.5) / n * count)));
  }
  return levels;
}

}  // namespace dockyard
