#include "sim/statistics/intervals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "statistics/binomial.h"

namespace dockyard {
namespace {

struct PublishedInterval {
  int successes, trials;
  double low, high;
};

// Tsai et al., V: 29 of 40 runs, 20 of 24 off the boundary. Intervals as statistics packages print
// them (R binom.test).
TEST(ClopperPearson, GivesThePublishedIntervalsOfThePapersRates) {
  const Interval all = ClopperPearson(29, 40), inner = ClopperPearson(20, 24);
  EXPECT_NEAR(100.0 * all.low, 56.1, 0.05);
  EXPECT_NEAR(100.0 * all.high, 85.4, 0.05);
  EXPECT_NEAR(100.0 * inner.low, 62.6, 0.05);
  EXPECT_NEAR(100.0 * inner.high, 95.3, 0.05);
}

// Newcombe, Stat. Med. 17, 857 (1998), Table I.
TEST(ClopperPearson, GivesNewcombesTable) {
  for (const PublishedInterval& row : {PublishedInterval{81, 263, 0.2527, 0.3676},
                                       {15, 148, 0.0578, 0.1617},
                                       {0, 20, 0.0, 0.1684},
                                       {1, 29, 0.0009, 0.1776}}) {
    const Interval interval = ClopperPearson(row.successes, row.trials);
    EXPECT_NEAR(interval.low, row.low, 5e-5) << row.successes << "/" << row.trials;
    EXPECT_NEAR(interval.high, row.high, 5e-5) << row.successes << "/" << row.trials;
  }
}

// influentialpoints.com, after Conover, Practical Nonparametric Statistics (1999).
TEST(ClopperPearson, GivesConoversExample) {
  const Interval interval = ClopperPearson(5, 25);
  EXPECT_NEAR(interval.low, 0.068, 5e-4);
  EXPECT_NEAR(interval.high, 0.407, 5e-4);
}

TEST(ClopperPearson, EndsWhereTheTailsAreTwoAndAHalfPercent) {
  for (const auto& [k, n] : {std::pair{1, 2}, {31, 40}, {3, 40}, {500, 1000}, {1, 1000}}) {
    const Interval interval = ClopperPearson(k, n);
    EXPECT_NEAR(BinomialAtLeast(k, n, interval.low), 0.025, 1e-10) << k << "/" << n;
    EXPECT_NEAR(1.0 - BinomialAtLeast(k + 1, n, interval.high), 0.025, 1e-10) << k << "/" << n;
  }
}

TEST(ClopperPearson, WidensWithTheConfidence) {
  const Interval wide = ClopperPearson(31, 40, 0.99);
  EXPECT_NEAR(BinomialAtLeast(31, 40, wide.low), 0.005, 1e-10);
  EXPECT_NEAR(1.0 - BinomialAtLeast(32, 40, wide.high), 0.005, 1e-10);
}

TEST(ClopperPearson, HasClosedFormsWhenNoneOrAllDock) {  // 1 - 0.025^(1/n)
  EXPECT_NEAR(ClopperPearson(0, 10).high, 1.0 - std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(ClopperPearson(0, 10).low, 0.0);
  EXPECT_NEAR(ClopperPearson(10, 10).low, std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(ClopperPearson(10, 10).high, 1.0);
}

// The same table, score method without correction.
TEST(Wilson, GivesNewcombesTable) {
  for (const PublishedInterval& row : {PublishedInterval{81, 263, 0.2553, 0.3662},
                                       {15, 148, 0.0624, 0.1605},
                                       {0, 20, 0.0, 0.1611},
                                       {1, 29, 0.0061, 0.1718}}) {
    const Interval interval = Wilson(row.successes, row.trials);
    EXPECT_NEAR(interval.low, row.low, 5e-5) << row.successes << "/" << row.trials;
    EXPECT_NEAR(interval.high, row.high, 5e-5) << row.successes << "/" << row.trials;
  }
}

// The ends are the shares p from which the count is z standard deviations of p away.
TEST(Wilson, EndsWhereTheScoreIsTheDeviate) {
  for (const auto& [k, n] : {std::pair{1, 2}, {31, 40}, {0, 7}, {7, 7}, {500, 1000}}) {
    for (const double confidence : {0.9, 0.99}) {
      const Interval interval = Wilson(k, n, confidence);
      const double z = NormalDeviate(confidence), share = double(k) / n;
      for (const double p : {interval.low, interval.high}) {
        if (p == share) continue;  // 0 of n and n of n: the deviation is 0 there, and its error too
        EXPECT_NEAR((share - p) * (share - p), z * z * p * (1.0 - p) / n, 1e-14) << k << "/" << n;
      }
    }
  }
}

TEST(Wilson, EndsAtZeroAndOneExactly) {
  for (int n = 1; n <= 100; ++n) {
    EXPECT_EQ(Wilson(0, n).low, 0.0);
    EXPECT_EQ(Wilson(n, n).high, 1.0);
  }
}

TEST(Bounds, AreTheEndsOfTheIntervalOfTwiceTheRisk) {
  for (const auto& [k, n] : {std::pair{0, 3}, {1, 2}, {31, 40}, {3, 3}}) {
    const Interval interval = ClopperPearson(k, n, 0.9);
    EXPECT_NEAR(LowerBound(k, n, 0.95), interval.low, 1e-12) << k << "/" << n;
    EXPECT_NEAR(UpperBound(k, n, 0.95), interval.high, 1e-12) << k << "/" << n;
  }
}

// P(X >= 5) of 9 tosses of a fair coin is 1/2; Boost's inverse of the beta function throws here.
TEST(Bounds, AreTheMedianAtAConfidenceOfOneHalf) {
  EXPECT_NEAR(LowerBound(5, 9, 0.5), 0.5, 1e-15);
  EXPECT_NEAR(UpperBound(4, 9, 0.5), 0.5, 1e-15);
}

TEST(AllIntervals, KnowNothingWithoutTrials) {
  for (const Interval& interval : {ClopperPearson(0, 0), Wilson(0, 0),
                                   Interval{LowerBound(0, 0, 0.9), UpperBound(0, 0, 0.9)}}) {
    EXPECT_EQ(interval.low, 0.0);
    EXPECT_EQ(interval.high, 1.0);
  }
}

/// Chance that the interval of the count has the share in it, over all counts.
double Coverage(const std::vector<Interval>& of_count, double share) {
  const int n = static_cast<int>(of_count.size()) - 1;
  double covered = 0.0;
  for (int k = 0; k <= n; ++k) {
    const Interval& interval = of_count[static_cast<std::size_t>(k)];
    if (interval.low <= share && share <= interval.high) covered += BinomialChance(k, n, share);
  }
  return covered;
}

template <typename Rule>
std::vector<Interval> OfEachCount(int trials, Rule rule) {
  std::vector<Interval> intervals;
  for (int k = 0; k <= trials; ++k) intervals.push_back(rule(k));
  return intervals;
}

TEST(ClopperPearson, CoversEveryShareAtLeastWithItsConfidence) {
  for (int n = 1; n <= 60; ++n) {
    const auto intervals = OfEachCount(n, [&](int k) { return ClopperPearson(k, n); });
    const auto low = OfEachCount(n, [&](int k) { return Interval{LowerBound(k, n, 0.9), 1.0}; });
    const auto high = OfEachCount(n, [&](int k) { return Interval{0.0, UpperBound(k, n, 0.9)}; });
    for (double share = 0.005; share < 1.0; share += 0.01) {
      EXPECT_GE(Coverage(intervals, share), 0.95 - 1e-12) << n << " " << share;
      EXPECT_GE(Coverage(low, share), 0.9 - 1e-12) << n << " " << share;
      EXPECT_GE(Coverage(high, share), 0.9 - 1e-12) << n << " " << share;
    }
  }
}

TEST(Wilson, CoversWithItsConfidenceInTheMeanOfAllShares) {
  for (int n = 5; n <= 60; ++n) {
    const auto intervals = OfEachCount(n, [&](int k) { return Wilson(k, n); });
    double sum = 0.0, least = 1.0;
    for (int i = 0; i < 200; ++i) {
      const double coverage = Coverage(intervals, (i + 0.5) / 200.0);
      sum += coverage;
      least = std::min(least, coverage);
    }
    EXPECT_NEAR(sum / 200.0, 0.95, 0.01) << n;
    EXPECT_LT(least, 0.95) << n;  // at some shares it covers less: that is what its shortness costs
    EXPECT_GT(least, 0.82) << n;
  }
}

TEST(NormalDeviate, HasTheKnownValues) {
  EXPECT_NEAR(NormalDeviate(0.95), 1.959963984540054, 1e-12);
  EXPECT_NEAR(NormalDeviate(0.99), 2.575829303548901, 1e-12);
}

}  // namespace
}  // namespace dockyard
