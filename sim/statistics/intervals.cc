#include "sim/statistics/intervals.h"

#include <boost/math/special_functions/beta.hpp>

#include "controller/base/check.h"

namespace dockyard {

// P(X >= k | p) = I_p(k, n - k + 1), P(X <= k | p) = 1 - I_p(k + 1, n - k).
Interval ClopperPearson(int successes, int trials, double confidence) {
  DOCKYARD_CHECK(successes >= 0 && successes <= trials && confidence > 0.0 && confidence < 1.0);
  const double tail = 0.5 * (1.0 - confidence);
  Interval interval;
  if (successes > 0) {
    interval.low = boost::math::ibeta_inv(double(successes), trials - successes + 1.0, tail);
  }
  if (successes < trials) {
    interval.high = boost::math::ibeta_inv(successes + 1.0, double(trials - successes), 1.0 - tail);
  }
  return interval;
}

}  // namespace dockyard
