#include "sim/statistics/prediction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "statistics/binomial.h"

namespace dockyard {
namespace {

// Fisher's twins (R, example of fisher.test): 10 of 13 against 2 of 17, one-sided p = 0.0004652.
TEST(Prediction, IsTwiceFishersExactTest) {
  EXPECT_NEAR(PredictionP(10, 13, 2, 17), 2 * 0.0004652, 2e-7);
  EXPECT_NEAR(PredictionP(3, 4, 1, 4), 2 * 17.0 / 70.0, 1e-12);  // the lady tasting tea
  EXPECT_EQ(PredictionP(3, 4, 3, 4), 1.0);
}

// Summed in whole numbers by Python's fractions.
TEST(Prediction, HasTheCountsOfExactArithmetic) {
  struct Row {
    int successes, trials, future;
    double confidence;
    int low, high;
  };
  for (const Row& row : {Row{310, 400, 40, 0.95, 25, 36},
                         {290, 400, 40, 0.95, 23, 35},
                         {30, 400, 40, 0.95, 0, 7},
                         {0, 400, 40, 0.95, 0, 1},
                         {400, 400, 40, 0.95, 39, 40},
                         {180, 240, 24, 0.9875, 12, 23},
                         {120, 150, 15, 0.9875, 7, 15},
                         {3, 40, 40, 0.95, 0, 10},
                         {29, 40, 40, 0.95, 20, 36},
                         {0, 10, 5, 0.95, 0, 2}}) {
    const CountInterval found = PredictCount(row.successes, row.trials, row.future, row.confidence);
    EXPECT_EQ(found.low, row.low) << row.successes << "/" << row.trials;
    EXPECT_EQ(found.high, row.high) << row.successes << "/" << row.trials;
  }
}

/// P(Y >= y) of a beta-binomial count: the chance has the density of Beta(a, b).
double BetaBinomialAtLeast(int y, int n, double a, double b) {
  double sum = 0.0;
  for (int i = y; i <= n; ++i) {
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                    std::lgamma(i + a) + std::lgamma(n - i + b) - std::lgamma(n + a + b) +
                    std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b));
  }
  return sum;
}

// Thatcher (1964): the exact limits are those of Bayes with the priors Beta(1, 0) above, Beta(0, 1)
// below.
TEST(Prediction, EndsWhereTheBayesianTailsOfThatcherDo) {
  for (const int k : {1, 17, 100, 249}) {
    for (const double confidence : {0.9, 0.95, 0.9875}) {
      const int trials = 250, future = 25;
      const double tail = 0.5 * (1.0 - confidence);
      const CountInterval found = PredictCount(k, trials, future, confidence);
      EXPECT_GT(BetaBinomialAtLeast(found.high, future, k + 1.0, trials - k), tail);
      if (found.high < future) {
        EXPECT_LE(BetaBinomialAtLeast(found.high + 1, future, k + 1.0, trials - k), tail);
      }
      // At most `low` successes: at least future - low failures.
      EXPECT_GT(BetaBinomialAtLeast(future - found.low, future, trials - k + 1.0, k), tail);
      if (found.low > 0) {
        EXPECT_LE(BetaBinomialAtLeast(future - found.low + 1, future, trials - k + 1.0, k), tail);
      }
    }
  }
}

// Every count of both experiments with its chance.
TEST(Prediction, CoversAtEveryChance) {
  const int trials = 150, future = 15;
  for (const double confidence : {0.95, 0.9875}) {
    std::vector<CountInterval> intervals;
    for (int k = 0; k <= trials; ++k) {
      intervals.push_back(PredictCount(k, trials, future, confidence));
    }
    for (const double p : {0.01, 0.05, 0.2, 0.5, 0.533, 0.725, 0.9, 0.99}) {
      double covered = 0.0;
      for (int k = 0; k <= trials; ++k) {
        const CountInterval& at = intervals[static_cast<std::size_t>(k)];
        const double below = at.low > 0 ? BinomialAtMost(at.low - 1, future, p) : 0.0;
        covered +=
            BinomialChance(k, trials, p) * (1.0 - below - BinomialAtLeast(at.high + 1, future, p));
      }
      EXPECT_GE(covered, confidence) << p;
    }
  }
}

// The same starts again: an easy one docks nearly always, a hard one seldom.
TEST(Prediction, CoversWhereEachStartHasAChanceOfItsOwn) {
  const int starts = 40, replications = 10, times = 20000;
  std::mt19937_64 random(1);
  std::map<int, CountInterval> intervals;  // by the known count
  int covered = 0;
  for (int time = 0; time < times; ++time) {
    int known = 0, future = 0;
    for (int start = 0; start < starts; ++start) {
      const double p = start % 4 == 0 ? 0.2 : start % 4 == 1 ? 0.7 : 0.98;
      known += std::binomial_distribution<int>(replications, p)(random);
      future += std::bernoulli_distribution(p)(random);
    }
    const auto [at, fresh] = intervals.try_emplace(known);
    if (fresh) at->second = PredictCount(known, starts * replications, starts);
    covered += at->second.Holds(future);
  }
  EXPECT_GE(covered, 0.95 * times);
}

// Of so many known trials nothing but the chance matters.
TEST(Prediction, EndsAsTheBinomialCountsOfAKnownChance) {
  const CountInterval found = PredictCount(725000, 1000000, 40);
  EXPECT_GT(BinomialAtMost(found.low, 40, 0.725), 0.025);
  EXPECT_LE(BinomialAtMost(found.low - 1, 40, 0.725), 0.025);
  EXPECT_GT(BinomialAtLeast(found.high, 40, 0.725), 0.025);
  EXPECT_LE(BinomialAtLeast(found.high + 1, 40, 0.725), 0.025);
}

TEST(Prediction, HoldsEveryCountWhereNothingIsKnown) {
  const CountInterval found = PredictCount(0, 0, 7);
  EXPECT_EQ(found.low, 0);
  EXPECT_EQ(found.high, 7);
  EXPECT_TRUE(found.Holds(0));
  EXPECT_FALSE(found.Holds(8));
}

}  // namespace
}  // namespace dockyard
