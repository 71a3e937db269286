#include "sim/report/statistics.h"

#include <cmath>
#include <cstdio>

#include <boost/math/special_functions/beta.hpp>

#include "controller/base/check.h"

namespace dockyard {
namespace {

long Percent(double share) { return std::lround(100.0 * share); }

}  // namespace

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

std::string RateText(int successes, int trials) {
  const std::string count = std::to_string(successes) + "/" + std::to_string(trials);
  if (trials == 0) return count;
  const Interval interval = ClopperPearson(successes, trials);
  return count + " (" + std::to_string(Percent(static_cast<double>(successes) / trials)) + " %, " +
         std::to_string(Percent(interval.low)) + "-" + std::to_string(Percent(interval.high)) +
         " %)";
}

std::string BriefRate(int docked, int runs) { return "docked " + RateText(docked, runs); }

std::string BriefNumber(double value) {
  if (std::isnan(value)) return "nan";  // one spelling, whatever its sign bit
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace dockyard
