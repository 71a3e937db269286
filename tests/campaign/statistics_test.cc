#include "sim/campaign/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace dockyard {
namespace {

/// P(X >= k) of a binomial, term by term: independent of the continued fraction.
double UpperTail(int k, int n, double p) {
  double sum = 0.0;
  for (int i = k; i <= n; ++i) {
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                    i * std::log(p) + (n - i) * std::log1p(-p));
  }
  return sum;
}

TEST(RegularizedBeta, IsTheTailOfTheBinomial) {
  for (const auto& [k, n, p] : {std::tuple{1, 1, 0.3},
                                {29, 40, 0.725},
                                {3, 40, 0.9},
                                {40, 40, 0.9},
                                {500, 1000, 0.47},
                                {1, 1000, 0.0001}}) {
    EXPECT_NEAR(RegularizedBeta(k, n - k + 1.0, p), UpperTail(k, n, p), 1e-11) << k << "/" << n;
  }
}

TEST(RegularizedBeta, HasItsClosedFormsAtSmallParameters) {
  EXPECT_NEAR(RegularizedBeta(1.0, 1.0, 0.3), 0.3, 1e-14);        // x
  EXPECT_NEAR(RegularizedBeta(2.0, 1.0, 0.3), 0.09, 1e-14);       // x^2
  EXPECT_NEAR(RegularizedBeta(1.0, 3.0, 0.3), 1 - 0.343, 1e-14);  // 1 - (1-x)^3
  EXPECT_NEAR(RegularizedBeta(0.5, 0.5, 0.25), 2.0 / 3.14159265358979 * std::asin(0.5), 1e-13);
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
  const Interval interval = ClopperPearson(31, 40);
  EXPECT_NEAR(UpperTail(31, 40, interval.low), 0.025, 1e-10);
  EXPECT_NEAR(1.0 - UpperTail(32, 40, interval.high), 0.025, 1e-10);
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

TEST(BriefRate, SaysHowSureItIs) {
  EXPECT_EQ(BriefRate(31, 40), "docked 31/40 (78 %, 62-89 %)");
  EXPECT_EQ(BriefRate(29, 40), "docked 29/40 (73 %, 56-85 %)");
  EXPECT_EQ(BriefRate(0, 0), "docked 0/0");
}

}  // namespace
}  // namespace dockyard
