#include "sim/statistics/intervals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace dockyard {
namespace {

/// P(X >= k) of a binomial, term by term: independent of the beta function.
double UpperTail(int k, int n, double p) {
  double sum = 0.0;
  for (int i = k; i <= n; ++i) {
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                    i * std::log(p) + (n - i) * std::log1p(-p));
  }
  return sum;
}

// Tsai et al., V: 29 of 40 runs, 20 of 24 off the boundary. Intervals as statistics packages print
// them (R binom.test).
TEST(ClopperPearson, GivesThePublishedIntervalsOfThePapersRates) {
  const Interval all = ClopperPearson(29, 40), inner = ClopperPearson(20, 24);
  EXPECT_NEAR(100.0 * all.low, 56.1, 0.05);
  EXPECT_NEAR(100.0 * all.high, 85.4, 0.05);
  EXPECT_NEAR(100.0 * inner.low, 62.6, 0.05);
  EXPECT_NEAR(100.0 * inner.high, 95.3, 0.05);
}

TEST(ClopperPearson, EndsWhereTheTailsAreTwoAndAHalfPercent) {
  for (const auto& [k, n] : {std::pair{1, 2}, {31, 40}, {3, 40}, {500, 1000}, {1, 1000}}) {
    const Interval interval = ClopperPearson(k, n);
    EXPECT_NEAR(UpperTail(k, n, interval.low), 0.025, 1e-10) << k << "/" << n;
    EXPECT_NEAR(1.0 - UpperTail(k + 1, n, interval.high), 0.025, 1e-10) << k << "/" << n;
  }
}

TEST(ClopperPearson, WidensWithTheConfidence) {
  const Interval wide = ClopperPearson(31, 40, 0.99);
  EXPECT_NEAR(UpperTail(31, 40, wide.low), 0.005, 1e-10);
  EXPECT_NEAR(1.0 - UpperTail(32, 40, wide.high), 0.005, 1e-10);
}

TEST(ClopperPearson, HasClosedFormsWhenNoneOrAllDock) {  // 1 - 0.025^(1/n)
  EXPECT_NEAR(ClopperPearson(0, 10).high, 1.0 - std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(ClopperPearson(0, 10).low, 0.0);
  EXPECT_NEAR(ClopperPearson(10, 10).low, std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(ClopperPearson(10, 10).high, 1.0);
}

TEST(ClopperPearson, KnowsNothingWithoutTrials) {
  EXPECT_EQ(ClopperPearson(0, 0).low, 0.0);
  EXPECT_EQ(ClopperPearson(0, 0).high, 1.0);
}

}  // namespace
}  // namespace dockyard
