#include "sim/draws/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "draws/goodness.h"
#include "sim/base/normal.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFirst = 0x1.0p-53, kLast = 1.0 - 0x1.0p-53;  // the ends of OpenUnit()
constexpr int kDraws = 20000;

std::vector<double> Draws(const Distribution& distribution, std::uint64_t seed) {
  RandomStream stream(seed);
  std::vector<double> values;
  for (int i = 0; i < kDraws; ++i) {
    values.push_back(Quantile(distribution, OpenUnit(stream.NextBits())));
  }
  return values;
}

TEST(Quantile, OfEachDistributionFollowsItsDistributionFunction) {
  const Normal plain{.mean = 3.0, .std = 2.0};
  EXPECT_LT(KolmogorovSmirnov(Draws(plain, 1), [](double x) { return NormalShare((x - 3) / 2); }),
            kKolmogorovSmirnovBound);
  const Normal cut{.mean = 3.0, .std = 2.0, .min = 2.0, .max = 8.0};
  const double below = NormalShare(-0.5), inside = NormalShare(2.5) - below;
  EXPECT_LT(
      KolmogorovSmirnov(Draws(cut, 2),
                        [&](double x) { return (NormalShare((x - 3) / 2) - below) / inside; }),
      kKolmogorovSmirnovBound);
  EXPECT_LT(KolmogorovSmirnov(Draws(Uniform{-2.0, 6.0}, 3), [](double x) { return (x + 2) / 8; }),
            kKolmogorovSmirnovBound);
  EXPECT_LT(KolmogorovSmirnov(Draws(LogUniform{0.5, 8.0}, 4),
                              [](double x) { return std::log2(x / 0.5) / 4; }),
            kKolmogorovSmirnovBound);
}

TEST(Quantile, OfAnUncutNormalIsThatOfTheStandardNormal) {
  for (const double u : {kFirst, 1e-9, 0.3, 0.5, 0.8, kLast}) {
    EXPECT_EQ(Quantile(Normal{.mean = 10.0, .std = 0.5}, u), 10.0 + 0.5 * NormalQuantile(u));
  }
}

// Computed by mpmath 1.3 with 60 digits. Beyond 8 standard deviations the shares below min are 1 to
// all digits, so an inverse in one tail alone would give min or infinity.
TEST(Quantile, OfANormalCutInATailIsTheHighPrecisionValue) {
  const struct {
    Normal normal;
    double u, value;
  } cases[] = {{{0, 1, 8, kInfinity}, 0.5, 8.0849110073915441},
               {{0, 1, 8, 9}, 0.01, 8.0012371990595918},
               {{0, 1, 8, 9}, 0.99, 8.5467036811274182},
               {{0, 1, -9, -8}, 0.25, -8.1688987085648934},
               {{0, 1, 30, 31}, 0.5, 30.023070467827309},
               {{0, 1, 36, kInfinity}, 0.9, 36.063854914197815},
               {{0, 1, -kInfinity, -36}, 0.1, -36.063854914197815},
               {{10, 2, -10, -5}, 0.3, -5.3124830639628436},
               {{0, 10, -40, 40}, 0.75, 6.7443991847102593},
               {{0, 1, -1, 12}, kFirst, -0.99999999999999961},
               {{0, 1, -1, 12}, kLast, 8.2302545274160014},
               {{0, 1, -12, 1}, kFirst, -8.2302545274160014},
               {{0, 1, 2, kInfinity}, kLast, 8.6522012971175980}};
  for (const auto& [normal, u, value] : cases) {
    EXPECT_NEAR(Quantile(normal, u), value, 1e-15 * std::abs(value)) << normal.min << " " << u;
  }
}

TEST(Quantile, RisesWithTheShareAndStaysBetweenMinAndMax) {
  struct Case {
    Distribution distribution;
    double min, max;
  };
  const Case cases[] = {{Normal{0, 1, -0.1, 1e-12}, -0.1, 1e-12},
                        {Normal{5, 0.01, 5.3, 5.31}, 5.3, 5.31},
                        {Normal{-1e6, 3, -1e6 - 1e-6, -1e6 + 1e-6}, -1e6 - 1e-6, -1e6 + 1e-6},
                        {Normal{0.3, 0.1, 0.1, 0.7}, 0.1, 0.7},
                        {Uniform{0.1, 0.7}, 0.1, 0.7},
                        {Uniform{-1.7e308, 1.7e308}, -1.7e308, 1.7e308},
                        {Uniform{3.0, 3.0}, 3.0, 3.0},
                        {LogUniform{1e-300, 1e300}, 1e-300, 1e300},
                        {LogUniform{0.8, 1.25}, 0.8, 1.25},
                        {LogUniform{0.3, 0.3}, 0.3, 0.3}};
  for (const auto& [distribution, min, max] : cases) {
    double last = min;
    for (int i = -1; i <= 1000; ++i) {
      const double u = i < 0 ? kFirst : i == 1000 ? kLast : (i + 0.5) / 1000.0;
      const double value = Quantile(distribution, u);
      EXPECT_GE(value, last) << min << " " << u;
      EXPECT_LE(value, max) << min << " " << u;
      last = value;
    }
  }
}

TEST(ShareLeft, IsExactInEitherTail) {
  EXPECT_EQ(ShareLeft(Normal{}), 1.0);
  EXPECT_NEAR(ShareLeft({0, 1, -1, 1}), 0.68268949213708590, 2e-16);  // mpmath, as those below
  EXPECT_NEAR(ShareLeft({0, 2, 60, 62}) / 4.9067139271481870e-198, 1.0, 2e-13);
  EXPECT_NEAR(ShareLeft({0, 2, -62, -60}) / 4.9067139271481870e-198, 1.0, 2e-13);
  EXPECT_LT(ShareLeft({0, 1, 37, kInfinity}), kLeastShareLeft);
  EXPECT_GT(ShareLeft({0, 1, 36, kInfinity}), kLeastShareLeft);
  EXPECT_EQ(ShareLeft({0, 1, 1, 1}), 0.0);
}

TEST(Pick, TakesEachPlaceInProportionToItsWeight) {
  const Discrete discrete{.weights = {1.0, 0.0, 2.0, 0.5, 3.5, 0.0}};
  RandomStream stream(6);
  std::vector<int> counts(6);
  for (int i = 0; i < kDraws; ++i) ++counts[Pick(discrete, OpenUnit(stream.NextBits()))];
  EXPECT_EQ(counts[1] + counts[5], 0);
  EXPECT_LT(ChiSquare({counts[0], counts[2], counts[3], counts[4]}, {1.0, 2.0, 0.5, 3.5}),
            ChiSquareBound(3));
}

TEST(Pick, ChangesWhereTheWeightsAddUp) {
  const Discrete discrete{.weights = {0.0, 1.0, 0.0, 1.0, 2.0, 0.0}};
  EXPECT_EQ(Pick(discrete, kFirst), 1u);
  EXPECT_EQ(Pick(discrete, 0.25 - 1e-16), 1u);
  EXPECT_EQ(Pick(discrete, 0.25), 3u);
  EXPECT_EQ(Pick(discrete, 0.5), 4u);
  EXPECT_EQ(Pick(discrete, kLast), 4u);
}

TEST(Pick, EndsInTheListWhateverTheWeights) {
  RandomStream stream(8);
  for (int i = 0; i < 1000; ++i) {
    Discrete discrete;
    for (int j = 0; j < 20; ++j) discrete.weights.push_back(std::pow(stream.Uniform(), 5.0));
    EXPECT_LT(Pick(discrete, kLast), 20u);
  }
}

TEST(QuantileDeathTest, RefusesWhatIsNoDistribution) {
  EXPECT_DEATH(Quantile(Normal{}, 0.0), "check failed");
  EXPECT_DEATH(Quantile(Normal{}, 1.0), "check failed");
  EXPECT_DEATH(Quantile(Normal{.std = 0.0}, 0.5), "check failed");
  EXPECT_DEATH(Quantile(Normal{0, 1, 40, 41}, 0.5), "check failed");
  EXPECT_DEATH(Quantile(Uniform{1.0, 0.0}, 0.5), "check failed");
  EXPECT_DEATH(Quantile(LogUniform{0.0, 1.0}, 0.5), "check failed");
  EXPECT_DEATH(Pick(Discrete{}, 0.5), "check failed");
  EXPECT_DEATH(Pick(Discrete{{1.0, -1.0}}, 0.5), "check failed");
  EXPECT_DEATH(Pick(Discrete{{0.0}}, 0.5), "check failed");
}

}  // namespace
}  // namespace dockyard
