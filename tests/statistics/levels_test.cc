#include "sim/statistics/levels.h"

#include <gmock/gmock.h>

#include <cmath>

#include "sim/base/random.h"
#include "statistics/correlations_of_columns.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;

// Hollander and Wolfe, Nonparametric Statistical Methods (1973), p. 116: mucociliary efficiency of
// three groups, the example of R's kruskal.test, which gives 0.77143 and 0.68.
TEST(EffectOfLevels, IsTheTestOfKruskalAndWallis) {
  const std::vector<double> efficiency{2.9, 3.0, 2.5, 2.6, 3.2, 3.8, 2.7,
                                       4.0, 2.4, 2.8, 3.4, 3.7, 2.2, 2.0};
  const std::vector<int> group{0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 2};
  const LevelEffect effect = EffectOfLevels(group, Ranks(efficiency));
  EXPECT_NEAR(13.0 * effect.eta_squared, 0.77143, 5e-6);
  EXPECT_NEAR(effect.p_value, std::exp(-0.5 * 0.77143), 5e-6);  // two degrees of freedom
  EXPECT_NEAR(effect.p_value, 0.68, 5e-4);
}

// Of a table of two rows and two columns: chi^2 = n (ad - bc)^2 / the product of the margins.
TEST(EffectOfLevels, IsPearsonsChiSquareOfShares) {
  const int a = 13, b = 7, c = 4, d = 16, n = a + b + c + d;
  std::vector<int> levels;
  std::vector<double> docked;
  for (int i = 0; i < n; ++i) {
    levels.push_back(i < a + b ? 0 : 3);  // levels without a run between them
    docked.push_back(i < a || (i >= a + b && i < a + b + c) ? 1.0 : 0.0);
  }
  const LevelEffect effect = EffectOfLevels(levels, docked);
  const double chi2 =
      double(n) * std::pow(a * d - b * c, 2) / (double(a + b) * (c + d) * (a + c) * (b + d));
  EXPECT_NEAR(n * effect.eta_squared, chi2, 1e-12);
  const double z = std::sqrt((n - 1) * effect.eta_squared);
  EXPECT_NEAR(effect.p_value, std::erfc(z / std::sqrt(2.0)), 1e-12);
}

TEST(EffectOfLevels, OfTwoLevelsIsTheSquareOfTheCorrelation) {
  const std::vector<double> x{0, 0, 0, 1, 1, 1, 1}, y{5, 1, 2, 4, 9, 8, 7};
  const double r = Spearman(x, y).value;
  EXPECT_NEAR(EffectOfLevels({0, 0, 0, 1, 1, 1, 1}, Ranks(y)).eta_squared, r * r, 1e-14);
}

TEST(EffectOfLevels, IsNoneOnTheMeanWhereLevelsDoNotMatter) {
  RandomStream random(StreamKey(3, "levels"));
  double raw = 0.0;
  int below_5_percent = 0;
  constexpr int kSamples = 2000, kRuns = 100, kLevels = 10;
  for (int sample = 0; sample < kSamples; ++sample) {
    std::vector<int> levels;
    std::vector<double> values;
    for (int i = 0; i < kRuns; ++i) {
      levels.push_back(i % kLevels);
      values.push_back(random.Uniform());
    }
    const LevelEffect effect = EffectOfLevels(levels, Ranks(values));
    raw += 1.0 - (1.0 - effect.eta_squared) * (kRuns - 1.0) / (kRuns - kLevels);
    below_5_percent += effect.p_value < 0.05;
  }
  // A sum of 2000 values with the spread of (chi^2 of 9) / 90: four of its standard deviations.
  EXPECT_NEAR(raw / kSamples, 0.0, 4.0 * std::sqrt(18.0) / 90.0 / std::sqrt(double(kSamples)));
  EXPECT_NEAR(double(below_5_percent) / kSamples, 0.05, 0.02);
}

TEST(EffectOfLevels, SeesARelationThatRisesAndFalls) {
  std::vector<double> x, y;
  for (int i = -200; i <= 200; ++i) {
    x.push_back(i);
    y.push_back(std::abs(i) < 100 ? 1.0 : 0.0);
  }
  EXPECT_NEAR(Spearman(x, y).value, 0.0, 1e-12);
  const LevelEffect effect = EffectOfLevels(LevelsOfRanks(Ranks(x), 10), Ranks(y));
  EXPECT_GT(effect.epsilon_squared, 0.75);
  EXPECT_LT(effect.p_value, 1e-6);
}

TEST(EffectOfLevels, IsUnknownWhereItCannotBeTold) {
  for (const LevelEffect& effect :
       {EffectOfLevels({}, {}), EffectOfLevels({0, 0, 0}, {1, 2, 3}),
        EffectOfLevels({0, 1, 1}, {5, 5, 5}), EffectOfLevels({0, 1, 2}, {1, 2, 3})}) {
    EXPECT_TRUE(std::isnan(effect.eta_squared));
    EXPECT_TRUE(std::isnan(effect.epsilon_squared));
    EXPECT_TRUE(std::isnan(effect.p_value));
  }
}

TEST(LevelsOfRanks, HaveTheSameNumberOfRuns) {
  EXPECT_THAT(LevelsOfRanks(Ranks({5, 1, 4, 2, 6, 3}), 3), ElementsAre(2, 0, 1, 0, 2, 1));
}

TEST(LevelsOfRanks, KeepEqualValuesTogether) {
  EXPECT_THAT(LevelsOfRanks(Ranks({7, 7, 7, 1, 7, 7}), 3), ElementsAre(1, 1, 1, 0, 1, 1));
  EXPECT_THAT(LevelsOfRanks(Ranks({2, 2, 2}), 5), ElementsAre(2, 2, 2));
}

}  // namespace
}  // namespace dockyard
