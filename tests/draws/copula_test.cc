#include "sim/draws/copula.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "draws/goodness.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

using Sample = std::vector<std::vector<double>>;  // by run, then by key

Sample Independent(std::size_t keys, int runs, std::uint64_t seed) {
  RandomStream stream(seed);
  Sample sample(runs, std::vector<double>(keys));
  for (auto& run : sample) {
    for (double& u : run) u = OpenUnit(stream.NextBits());
  }
  return sample;
}

Sample Applied(const Correlation& correlation, Sample sample) {
  for (auto& run : sample) correlation.Apply(run);
  return sample;
}

std::vector<double> Column(const Sample& sample, std::size_t key) {
  std::vector<double> column;
  for (const auto& run : sample) column.push_back(run[key]);
  return column;
}

std::vector<double> Ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = static_cast<double>(i);
  return ranks;
}

/// Spearman's coefficient of values without ties.
double RankCorrelationOf(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> first = Ranks(a), second = Ranks(b);
  const auto n = static_cast<double>(a.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) squares += std::pow(first[i] - second[i], 2);
  return 1.0 - 6.0 * squares / (n * (n * n - 1.0));
}

// The coefficient's standard error is (1 - r^2) sqrt((1 + r^2 / 2) / runs) (Bonett and Wright,
// Psychometrika 65, 2000), so 1 / sqrt(runs) or less; four of them.
constexpr int kRuns = 20000;
constexpr double kTolerance = 0.0283;

TEST(Correlation, ReachesTheWantedRankCorrelation) {
  for (const double rank : {-0.999, -0.95, -0.5, -0.1, 0.0, 0.2, 0.4, 0.8, 0.99}) {
    const auto correlation = Correlation::FromRanks(2, {{0, 1, rank}});
    ASSERT_TRUE(correlation) << rank;
    const Sample sample = Applied(*correlation, Independent(2, kRuns, 11));
    EXPECT_NEAR(RankCorrelationOf(Column(sample, 0), Column(sample, 1)), rank, kTolerance);
  }
}

TEST(Correlation, ReachesAllPairsOfAGroupAndLeavesOthersUncorrelated) {
  const std::vector<RankCorrelation> ranks = {{4, 1, 0.6}, {1, 3, -0.4}, {3, 4, 0.1}, {0, 5, 0.7}};
  const auto correlation = Correlation::FromRanks(6, ranks);
  ASSERT_TRUE(correlation);
  const Sample sample = Applied(*correlation, Independent(6, kRuns, 12));
  double wanted[6][6] = {};
  for (const auto& [i, j, rank] : ranks) wanted[i][j] = wanted[j][i] = rank;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < i; ++j) {
      EXPECT_NEAR(RankCorrelationOf(Column(sample, i), Column(sample, j)), wanted[i][j], kTolerance)
          << i << " " << j;
    }
  }
}

TEST(Correlation, LeavesEachKeyUniform) {
  const auto correlation = Correlation::FromRanks(3, {{0, 1, 0.8}, {0, 2, -0.5}, {1, 2, -0.7}});
  ASSERT_TRUE(correlation);
  const Sample sample = Applied(*correlation, Independent(3, kRuns, 13));
  for (int key = 0; key < 3; ++key) {
    EXPECT_LT(KolmogorovSmirnov(Column(sample, key), [](double u) { return u; }),
              kKolmogorovSmirnovBound);
  }
}

// Computed by mpmath 1.3 from the definition: Cholesky's factor times the normal quantiles.
TEST(Correlation, IsTheHighPrecisionValue) {
  std::vector<double> uniforms = {0.3, 0.8, 0.1};
  Correlation::FromRanks(3, {{0, 1, 0.5}, {0, 2, -0.3}, {1, 2, 0.2}})->Apply(uniforms);
  EXPECT_EQ(uniforms[0], 0.3);
  EXPECT_NEAR(uniforms[1], 0.673154737308395174, 1e-15);
  EXPECT_NEAR(uniforms[2], 0.289810888122107394, 1e-15);
}

// Forty keys, so that Eigen's factorisation by blocks is met as well.
TEST(Correlation, KeepsTheFirstOfAGroupAndKeysWithoutAnyBitForBit) {
  std::vector<RankCorrelation> ranks = {{40, 42, 0.0}};
  for (std::size_t pair = 0; pair < 20; ++pair) ranks.push_back({pair, 39 - pair, 0.3});
  const auto correlation = Correlation::FromRanks(45, ranks);
  ASSERT_TRUE(correlation);
  for (const auto& run : Independent(45, 100, 14)) {
    std::vector<double> applied = run;
    correlation->Apply(applied);
    for (int key = 0; key < 45; ++key) {
      if (key < 20 || key >= 40) {
        EXPECT_EQ(applied[key], run[key]) << key;
      } else {
        EXPECT_NE(applied[key], run[key]) << key;
      }
    }
  }
}

TEST(Correlation, OfLaterKeysChangesNoEarlierOne) {
  const auto two = Correlation::FromRanks(2, {{0, 1, 0.6}});
  const auto four = Correlation::FromRanks(4, {{2, 1, -0.2}, {0, 3, 0.3}, {1, 0, 0.6}});
  for (const auto& run : Independent(4, 100, 15)) {
    std::vector<double> few(run.begin(), run.begin() + 2), many = run;
    two->Apply(few);
    four->Apply(many);
    EXPECT_EQ(few[0], many[0]);
    EXPECT_EQ(few[1], many[1]);
  }
}

TEST(Correlation, WithoutPairsChangesNothing) {
  std::vector<double> uniforms = {0.25, 0.75};
  Correlation::FromRanks(2, {})->Apply(uniforms);
  EXPECT_EQ(uniforms, std::vector<double>({0.25, 0.75}));
}

TEST(Correlation, StaysInsideTheOpenInterval) {
  const auto correlation = Correlation::FromRanks(3, {{0, 1, 0.5}, {0, 2, 0.5}, {1, 2, 0.5}});
  for (const double end : {0x1.0p-53, 1.0 - 0x1.0p-53}) {
    std::vector<double> uniforms(3, end);
    correlation->Apply(uniforms);
    for (const double u : uniforms) {
      EXPECT_GT(u, 0.0);
      EXPECT_LT(u, 1.0);
    }
  }
}

TEST(Correlation, IsNoneWhenNoNumbersCanHaveIt) {
  EXPECT_FALSE(Correlation::FromRanks(3, {{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, -0.9}}));
  EXPECT_FALSE(Correlation::FromRanks(3, {{0, 1, 0.8}, {1, 2, 0.8}, {0, 2, 0.2}}));
  EXPECT_TRUE(Correlation::FromRanks(3, {{0, 1, 0.8}, {1, 2, 0.8}, {0, 2, 0.4}}));
}

TEST(Correlation, IsNoneWhenOneKeyFollowsFromTheOthers) {
  for (const double rank : {-1.0, 1.0}) EXPECT_FALSE(Correlation::FromRanks(2, {{0, 1, rank}}));
  EXPECT_TRUE(Correlation::FromRanks(2, {{0, 1, 1.0 - 1e-8}}));
}

TEST(CorrelationDeathTest, RefusesPairsThatAreNone) {
  EXPECT_DEATH((void)Correlation::FromRanks(2, {{0, 2, 0.1}}), "check failed");
  EXPECT_DEATH((void)Correlation::FromRanks(2, {{1, 1, 0.1}}), "check failed");
  EXPECT_DEATH((void)Correlation::FromRanks(2, {{0, 1, 1.1}}), "check failed");
  EXPECT_DEATH((void)Correlation::FromRanks(2, {{0, 1, 0.1}, {1, 0, 0.1}}), "check failed");
}

}  // namespace
}  // namespace dockyard
