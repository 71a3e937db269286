#include "sim/statistics/unpaired.h"

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

/// The tables that have both sums, by A's successes.
struct Tables {
  int runs_a, runs_b, successes;

  explicit Tables(const GroupCounts& counts)
      : runs_a(counts.runs_a),
        runs_b(counts.runs_b),
        successes(counts.successes_a + counts.successes_b) {
    DOCKYARD_CHECK(counts.successes_a >= 0 && counts.successes_a <= runs_a);
    DOCKYARD_CHECK(counts.successes_b >= 0 && counts.successes_b <= runs_b);
  }
  int least() const { return std::max(0, successes - runs_b); }
  int most() const { return std::min(runs_a, successes); }
  double ChanceOf(int successes_a) const {
    return std::exp(LogChoose(runs_a, successes_a) + LogChoose(runs_b, successes - successes_a) -
                    LogChoose(runs_a + runs_b, successes));
  }
};

}  // namespace

double FisherExact(const GroupCounts& counts) {
  constexpr double kRounding = 1e-7;  // relative: tables that are as likely differ by rounding
  const Tables tables(counts);
  const double found = tables.ChanceOf(counts.successes_a);
  double chance = 0.0;
  for (int a = tables.least(); a <= tables.most(); ++a) {
    const double each = tables.ChanceOf(a);
    if (each <= found * (1.0 + kRounding)) chance += each;
  }
  return std::min(1.0, chance);
}

double ChanceOfAWorseGroup(const GroupCounts& counts) {
  const Tables tables(counts);
  double chance = 0.0;
  for (int a = tables.least(); a <= counts.successes_a; ++a) chance += tables.ChanceOf(a);
  return std::min(1.0, chance);
}

Estimate GroupDifference(const GroupCounts& counts, double confidence) {
  if (counts.runs_a == 0 || counts.runs_b == 0) return {std::nan(""), {-1.0, 1.0}};
  const double a = static_cast<double>(counts.successes_a) / counts.runs_a,
               b = static_cast<double>(counts.successes_b) / counts.runs_b;
  const Interval of_a = Wilson(counts.successes_a, counts.runs_a, confidence),
                 of_b = Wilson(counts.successes_b, counts.runs_b, confidence);
  const double difference = a - b;
  return {difference,
          {difference - std::hypot(a - of_a.low, of_b.high - b),
           difference + std::hypot(of_a.high - a, b - of_b.low)}};
}

}  // namespace dockyard
