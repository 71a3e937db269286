#include "sim/statistics/paired.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <limits>

#include "controller/base/check.h"

namespace dockyard {
namespace {

/// P(X <= successes) of tosses of a fair coin, successes < tosses.
double FairAtMost(int successes, int tosses) {
  return boost::math::ibeta(double(tosses - successes), successes + 1.0, 0.5);
}

/// P(X = successes); the derivative of the incomplete beta function is the density that has it.
double FairExactly(int successes, int tosses) {
  return boost::math::ibeta_derivative(successes + 1.0, tosses - successes + 1.0, 0.5) /
         (tosses + 1.0);
}

/// Correlation of the pairs, less a correction of continuity when it is positive.
double Phi(const PairedCounts& c) {
  const double n = double(c.both) + c.only_a + c.only_b + c.neither;
  const double margins = (double(c.both) + c.only_a) * (double(c.only_b) + c.neither) *
                         (double(c.both) + c.only_b) * (double(c.only_a) + c.neither);
  if (margins == 0.0) return 0.0;
  const double cross = double(c.both) * c.neither - double(c.only_a) * c.only_b;
  const double corrected = cross > 0.0 ? std::max(cross - 0.5 * n, 0.0) : cross;
  return corrected / std::sqrt(margins);
}

double Joined(double from_a, double from_b, double phi) {
  return std::sqrt(from_a * from_a - 2.0 * phi * from_a * from_b + from_b * from_b);
}

}  // namespace

double McNemarExact(int only_a, int only_b) {
  DOCKYARD_CHECK(only_a >= 0 && only_b >= 0);
  if (only_a == only_b) return 1.0;
  return std::min(1.0, 2.0 * FairAtMost(std::min(only_a, only_b), only_a + only_b));
}

double ChanceOfAWorse(int only_a, int only_b) {
  DOCKYARD_CHECK(only_a >= 0 && only_b >= 0);
  if (only_b == 0) return 1.0;
  return FairAtMost(only_a, only_a + only_b);  // as likely as at least only_b on the other side
}

double McNemarMidP(int only_a, int only_b) {
  DOCKYARD_CHECK(only_a >= 0 && only_b >= 0);
  if (only_a + only_b == 0) return 1.0;
  const double observed = FairExactly(std::min(only_a, only_b), only_a + only_b);
  return McNemarExact(only_a, only_b) - (only_a == only_b ? 0.5 * observed : observed);
}

Estimate PairedDifference(const PairedCounts& counts, double confidence) {
  DOCKYARD_CHECK(counts.both >= 0 && counts.only_a >= 0 && counts.only_b >= 0 &&
                 counts.neither >= 0);
  const int n = counts.both + counts.only_a + counts.only_b + counts.neither;
  if (n == 0) return {std::numeric_limits<double>::quiet_NaN(), {-1.0, 1.0}};
  const int successes_a = counts.both + counts.only_a, successes_b = counts.both + counts.only_b;
  const double a = double(successes_a) / n, b = double(successes_b) / n;
  const Interval of_a = Wilson(successes_a, n, confidence);
  const Interval of_b = Wilson(successes_b, n, confidence);
  const double phi = Phi(counts), difference = double(counts.only_a - counts.only_b) / n;
  return {difference,
          {difference - Joined(a - of_a.low, of_b.high - b, phi),
           difference + Joined(of_a.high - a, b - of_b.low, phi)}};
}

}  // namespace dockyard
