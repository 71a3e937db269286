#include "sim/statistics/paired.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "statistics/binomial.h"

namespace dockyard {
namespace {

// Fagerland, Lydersen and Laake, BMC Med. Res. Methodol. 13:91 (2013): airway responsiveness
// before and after transplantation, and their second example.
TEST(McNemar, GivesThePublishedExamples) {
  EXPECT_NEAR(McNemarExact(1, 7), 0.070, 5e-4);
  EXPECT_NEAR(McNemarMidP(1, 7), 0.039, 5e-4);
  EXPECT_NEAR(McNemarExact(6, 16), 0.052, 5e-4);
  EXPECT_NEAR(McNemarMidP(6, 16), 0.035, 5e-4);
}

TEST(McNemar, IsTheChanceOfCountsAtLeastAsUnequal) {
  for (int a = 0; a <= 30; ++a) {
    for (int b = 0; a + b <= 30; ++b) {
      const int n = a + b;
      double more = 0.0, equal = 0.0;
      for (int x = 0; x <= n; ++x) {
        const int unequal = std::abs(2 * x - n);
        if (unequal > std::abs(a - b)) more += BinomialChance(x, n, 0.5);
        if (unequal == std::abs(a - b)) equal += BinomialChance(x, n, 0.5);
      }
      EXPECT_NEAR(McNemarExact(a, b), more + equal, 1e-12) << a << " " << b;
      if (n > 0) {
        EXPECT_NEAR(McNemarMidP(a, b), more + 0.5 * equal, 1e-12) << a << " " << b;
      }
    }
  }
}

TEST(McNemar, SaysNothingWithoutPairsThatDiffer) {
  EXPECT_EQ(McNemarExact(0, 0), 1.0);
  EXPECT_EQ(McNemarMidP(0, 0), 1.0);
}

TEST(McNemar, ApproachesTheChiSquareOfManyPairs) {
  const double z = 1000.0 / std::sqrt(1'001'000.0);  // (b - c) / sqrt(b + c)
  EXPECT_NEAR(McNemarMidP(500'000, 501'000), std::erfc(z / std::sqrt(2.0)), 1e-6);
}

TEST(McNemarExact, ErrsAtMostWithItsLevel) {
  for (int n = 1; n <= 100; ++n) {
    double found = 0.0;
    for (int a = 0; a <= n; ++a) {
      if (McNemarExact(a, n - a) <= 0.05) found += BinomialChance(a, n, 0.5);
    }
    EXPECT_LE(found, 0.05) << n;
  }
}

TEST(ChanceOfAWorse, IsTheSumOfTheCountsAtLeastAsBad) {
  for (int a = 0; a <= 20; ++a) {
    for (int b = 0; b <= 20; ++b) {
      double sum = 0.0;
      for (int x = b; x <= a + b; ++x) sum += BinomialChance(x, a + b, 0.5);
      EXPECT_NEAR(ChanceOfAWorse(a, b), sum, 1e-12) << a << " " << b;
    }
  }
}

// Half of the two-sided value where B is ahead, as the test is symmetric.
TEST(ChanceOfAWorse, IsHalfOfThePublishedTwoSidedValues) {
  EXPECT_NEAR(ChanceOfAWorse(1, 7), 0.0703 / 2, 5e-5);
  EXPECT_NEAR(ChanceOfAWorse(6, 16), 0.0525 / 2, 5e-5);
  EXPECT_GT(ChanceOfAWorse(16, 6), 0.97);
}

// Fagerland, Lydersen and Laake, Statistical Analysis of Contingency Tables (2017), chapter 8: the
// airway example, and the tests of its package contingencytables for Cavo et al. (2012).
TEST(PairedDifference, GivesThePublishedExamples) {
  const Estimate airway = PairedDifference({.both = 1, .only_a = 1, .only_b = 7, .neither = 12});
  EXPECT_NEAR(airway.value, -0.286, 5e-4);
  EXPECT_NEAR(airway.interval.low, -0.507, 5e-4);
  EXPECT_NEAR(airway.interval.high, -0.026, 5e-4);
  const Estimate response =
      PairedDifference({.both = 59, .only_a = 6, .only_b = 16, .neither = 80});
  EXPECT_NEAR(response.value, -0.0621, 5e-5);
  EXPECT_NEAR(response.interval.low, -0.1186, 5e-5);
  EXPECT_NEAR(response.interval.high, -0.0046, 5e-5);
}

TEST(PairedDifference, ChangesItsSignWithTheNames) {
  for (const PairedCounts& c :
       {PairedCounts{1, 1, 7, 12}, {30, 4, 0, 2}, {0, 5, 9, 0}, {8, 0, 0, 0}, {0, 6, 0, 0}}) {
    const Estimate ab = PairedDifference(c),
                   ba = PairedDifference({c.both, c.only_b, c.only_a, c.neither});
    EXPECT_EQ(ab.value, -ba.value);
    EXPECT_NEAR(ab.interval.low, -ba.interval.high, 1e-15);
    EXPECT_NEAR(ab.interval.high, -ba.interval.low, 1e-15);
    EXPECT_LE(ab.interval.low, ab.value);
    EXPECT_GE(ab.interval.low, -1.0);
    EXPECT_LE(ab.interval.high, 1.0);
  }
}

// The gain of pairs: the same rates say more when A and B fail on the same runs.
TEST(PairedDifference, IsKnownBetterWhenThePairsAreAlike) {
  const Interval alike = PairedDifference({80, 5, 0, 15}).interval;
  const Interval unlike = PairedDifference({68, 17, 12, 3}).interval;
  EXPECT_LT(alike.high - alike.low, 0.6 * (unlike.high - unlike.low));
}

TEST(PairedDifference, KnowsNothingWithoutPairs) {
  const Estimate none = PairedDifference({});
  EXPECT_TRUE(std::isnan(none.value));
  EXPECT_EQ(none.interval.low, -1.0);
  EXPECT_EQ(none.interval.high, 1.0);
}

/// Chance that the interval covers, over all tables of so many pairs.
double Coverage(int n, double both, double only_a, double only_b) {
  const double truth = only_a - only_b, neither = 1.0 - both - only_a - only_b;
  double covered = 0.0;
  for (int e = 0; e <= n; ++e) {
    for (int f = 0; e + f <= n; ++f) {
      for (int g = 0; e + f + g <= n; ++g) {
        const Interval interval = PairedDifference({e, f, g, n - e - f - g}).interval;
        if (truth < interval.low || truth > interval.high) continue;
        // e of n, then f of the rest, then g of what is left
        covered += BinomialChance(e, n, both) * BinomialChance(f, n - e, only_a / (1.0 - both)) *
                   BinomialChance(g, n - e - f, only_b / (only_b + neither));
      }
    }
  }
  return covered;
}

TEST(PairedDifference, CoversWithItsConfidenceOrLittleLess) {
  EXPECT_GT(Coverage(25, 0.8, 0.1, 0.05), 0.94);
  EXPECT_GT(Coverage(25, 0.5, 0.2, 0.2), 0.94);
  EXPECT_GT(Coverage(25, 0.3, 0.4, 0.1), 0.94);
  EXPECT_GT(Coverage(40, 0.9, 0.02, 0.06), 0.94);
}

}  // namespace
}  // namespace dockyard
