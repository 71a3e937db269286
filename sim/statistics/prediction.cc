#include "sim/statistics/prediction.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

double LogChoose(int n, int k) {
  using boost::math::lgamma;
  return lgamma(n + 1.0) - lgamma(k + 1.0) - lgamma(n - k + 1.0);
}

/// P(Y = y) of Y among the future trials, given the sum of both counts.
double ChanceOf(int y, int sum, int trials, int future) {
  return std::exp(LogChoose(future, y) + LogChoose(trials, sum - y) -
                  LogChoose(trials + future, sum));
}

/// Counts among the future trials that the sum allows.
CountInterval Possible(int sum, int trials, int future) {
  return {std::max(0, sum - trials), std::min(future, sum)};
}

double AtMost(int count, int sum, int trials, int future) {
  double chance = 0.0;
  for (int y = Possible(sum, trials, future).low; y <= count; ++y) {
    chance += ChanceOf(y, sum, trials, future);
  }
  return chance;
}

double AtLeast(int count, int sum, int trials, int future) {
  double chance = 0.0;
  for (int y = Possible(sum, trials, future).high; y >= count; --y) {
    chance += ChanceOf(y, sum, trials, future);
  }
  return chance;
}

void CheckCounts(int successes, int trials, int future) {
  DOCKYARD_CHECK(successes >= 0 && successes <= trials && future >= 0);
}

}  // namespace

double PredictionP(int successes, int trials, int count, int future) {
  CheckCounts(successes, trials, future);
  DOCKYARD_CHECK(count >= 0 && count <= future);
  const int sum = successes + count;
  return std::min(
      1.0, 2.0 * std::min(AtMost(count, sum, trials, future), AtLeast(count, sum, trials, future)));
}

CountInterval PredictCount(int successes, int trials, int future, double confidence) {
  CheckCounts(successes, trials, future);
  DOCKYARD_CHECK(confidence > 0.0 && confidence < 1.0);
  // The one-sided chances rise and fall with the count, so the counts that are held are adjacent;
  // the share that was seen is among them.
  const auto held = [&](int count) {
    return PredictionP(successes, trials, count, future) > 1.0 - confidence;
  };
  CountInterval interval{0, future};
  while (interval.low < interval.high && !held(interval.low)) ++interval.low;
  while (interval.high > interval.low && !held(interval.high)) --interval.high;
  return interval;
}

}  // namespace dockyard
