#include "sim/campaign/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/base/check.h"

namespace dockyard {
namespace {

// Converges fast for x < (a + 1) / (a + b + 2); the other side is had by symmetry.
double BetaFraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  const auto safe = [](double value) { return std::abs(value) < kTiny ? kTiny : value; };
  double c = 1.0;
  double d = 1.0 / safe(1.0 - (a + b) * x / (a + 1.0));
  double fraction = d;
  for (int m = 1; m < 1000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1.0) * (a + 2 * m));
    d = 1.0 / safe(1.0 + even * d);
    c = safe(1.0 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1.0));
    d = 1.0 / safe(1.0 + odd * d);
    c = safe(1.0 + odd / c);
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < std::numeric_limits<double>::epsilon()) break;
  }
  return fraction;
}

/// The p in [0, 1] at which an increasing I_p(a, b) reaches the level.
double BetaQuantile(double a, double b, double level) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {  // to 1e-18
    const double middle = 0.5 * (low + high);
    (RegularizedBeta(a, b, middle) < level ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

long Percent(double share) { return std::lround(100.0 * share); }

}  // namespace

double RegularizedBeta(double a, double b, double x) {
  DOCKYARD_CHECK(a > 0.0 && b > 0.0 && x >= 0.0 && x <= 1.0);
  if (x == 0.0 || x == 1.0) return x;
  if (x > (a + 1.0) / (a + b + 2.0)) return 1.0 - RegularizedBeta(b, a, 1.0 - x);
  const double log_front =
      std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x);
  return std::exp(log_front) * BetaFraction(a, b, x) / a;
}

// P(X >= k | p) = I_p(k, n - k + 1), P(X <= k | p) = 1 - I_p(k + 1, n - k).
Interval ClopperPearson(int successes, int trials, double confidence) {
  DOCKYARD_CHECK(successes >= 0 && successes <= trials && confidence > 0.0 && confidence < 1.0);
  const double tail = 0.5 * (1.0 - confidence);
  Interval interval;
  if (successes > 0) interval.low = BetaQuantile(successes, trials - successes + 1.0, tail);
  if (successes < trials) {
    interval.high = BetaQuantile(successes + 1.0, trials - successes, 1.0 - tail);
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

}  // namespace dockyard
