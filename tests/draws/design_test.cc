#include "sim/draws/design.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draws/goodness.h"

namespace dockyard {
namespace {

constexpr DesignKind kKinds[] = {DesignKind::kMonteCarlo, DesignKind::kLatinHypercube,
                                 DesignKind::kSobol};
constexpr std::uint64_t kSeed = 7;
const std::vector<std::string> kKeys = {"start.r_m", "start.alpha_deg", "light"};

Design Make(DesignKind kind, std::uint64_t repeats, const std::vector<std::string>& keys = kKeys) {
  return Design(kind, repeats, kSeed, keys);
}

double Same(double u) { return u; }

/// Spread of the estimates of one mean, each from all repeats at one place.
double SpreadOfMeans(const Design& design, std::uint64_t repeats) {
  constexpr int kPlaces = 20;
  double sum = 0.0, squares = 0.0;
  for (int place = 0; place < kPlaces; ++place) {
    double mean = 0.0;
    for (std::uint64_t i = 0; i < repeats; ++i) {
      double product = 1.0;  // smooth, with an interaction of all keys
      for (int k = 0; k < 3; ++k) product *= 0.5 + design.Uniform(k, place, i);
      mean += product / static_cast<double>(repeats);
    }
    sum += mean;
    squares += mean * mean;
  }
  return std::sqrt((squares - sum * sum / kPlaces) / (kPlaces - 1));
}

// Literals of a program in Python that shares nothing with the source: a change of the arithmetic
// must not go unseen.
TEST(Design, DrawsTheNumbersOfAnIndependentProgram) {
  const Design monte_carlo = Make(DesignKind::kMonteCarlo, 1);
  EXPECT_EQ(monte_carlo.Uniform(0, 0, 0), 0.15440617814655122);
  EXPECT_EQ(monte_carlo.Uniform(0, 0, 1), 0.875853091923421);
  EXPECT_EQ(monte_carlo.Uniform(0, 3, 0), 0.46402452039051434);
  EXPECT_EQ(monte_carlo.Uniform(2, 0, 0), 0.03690400341609579);
  const Design ten = Make(DesignKind::kLatinHypercube, 10);
  EXPECT_EQ(ten.Uniform(0, 0, 0), 0.11544061781465516);
  EXPECT_EQ(ten.Uniform(0, 3, 0), 0.14640245203905167);
  EXPECT_EQ(ten.Uniform(2, 0, 1), 0.0040127044930734716);
  const Design thousand = Make(DesignKind::kLatinHypercube, 1000);
  EXPECT_EQ(thousand.Uniform(0, 0, 0), 0.8731544061781464);
  EXPECT_EQ(thousand.Uniform(2, 3, 0), 0.2611744126604758);
  const Design sobol = Make(DesignKind::kSobol, 6);
  EXPECT_EQ(sobol.Uniform(0, 0, 0), 0.14702204242959593);
  EXPECT_EQ(sobol.Uniform(0, 3, 5), 0.9614569686597197);
  EXPECT_EQ(sobol.Uniform(2, 0, 1), 0.15966652529746417);
  EXPECT_EQ(sobol.Uniform(2, 3, 5), 0.4318498779963805);
}

TEST(Design, DrawsTheSameInAnyOrder) {
  for (const DesignKind kind : kKinds) {
    const Design forwards = Make(kind, 50), backwards = Make(kind, 50);
    std::vector<double> first, second;
    for (int i = 0; i < 300; ++i) first.push_back(forwards.Uniform(i % 3, i / 150, i / 3 % 50));
    for (int i = 299; i >= 0; --i) second.push_back(backwards.Uniform(i % 3, i / 150, i / 3 % 50));
    EXPECT_EQ(first, std::vector<double>(second.rbegin(), second.rend()));
  }
}

TEST(Design, DrawsInsideTheOpenInterval) {
  for (const DesignKind kind : kKinds) {
    for (const std::uint64_t repeats : {1, 3, 64, 1000}) {
      const Design design = Make(kind, repeats);
      for (std::uint64_t i = 0; i < 3 * repeats; ++i) {
        const double u = design.Uniform(i % 3, 1, i / 3);
        ASSERT_GT(u, 0.0);
        ASSERT_LT(u, 1.0);
      }
    }
  }
}

TEST(Design, GivesAKeyTheSameDrawsWhateverKeysFollowIt) {
  for (const DesignKind kind : kKinds) {
    const Design three = Make(kind, 100),
                 four = Make(kind, 100, {"start.r_m", "start.alpha_deg", "light", "friction"});
    for (int i = 0; i < 300; ++i) {
      EXPECT_EQ(three.Uniform(i % 3, 2, i / 3), four.Uniform(i % 3, 2, i / 3));
    }
  }
}

TEST(Design, GivesAKeyTheSameDrawsInAnyPlaceOfTheListExceptBySobol) {
  for (const DesignKind kind : {DesignKind::kMonteCarlo, DesignKind::kLatinHypercube}) {
    const Design listed = Make(kind, 100);
    const Design mixed = Make(kind, 100, {"friction", "light", "start.r_m", "start.alpha_deg"});
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(listed.Uniform(0, 2, i), mixed.Uniform(2, 2, i));
      EXPECT_EQ(listed.Uniform(1, 2, i), mixed.Uniform(3, 2, i));
      EXPECT_EQ(listed.Uniform(2, 2, i), mixed.Uniform(1, 2, i));
    }
  }
}

TEST(Design, GivesTheSameDrawsForMoreRepeatsExceptByLatinHypercube) {
  for (const DesignKind kind : {DesignKind::kMonteCarlo, DesignKind::kSobol}) {
    const Design few = Make(kind, 20), many = Make(kind, 1000);
    for (int i = 0; i < 60; ++i)
      EXPECT_EQ(few.Uniform(i % 3, 1, i / 3), many.Uniform(i % 3, 1, i / 3));
  }
}

TEST(MonteCarlo, NeedsNoNumberOfRepeats) {
  for (const std::uint64_t repeats : {std::uint64_t{0}, ~std::uint64_t{0}}) {
    EXPECT_EQ(Make(DesignKind::kMonteCarlo, repeats).Uniform(0, 0, 1), 0.875853091923421);
  }
}

TEST(MonteCarlo, DrawsAreUniformAndIndependentOverRepeatsPlacesAndKeys) {
  const Design design = Make(DesignKind::kMonteCarlo, 1);
  constexpr int kRuns = 20000;
  std::vector<double> draws;
  PairCounts repeats(12), places(12), keys(12);
  for (int i = 0; i < kRuns; ++i) {
    const double u = design.Uniform(0, 0, i);
    draws.push_back(u);
    repeats.Add(u, design.Uniform(0, 0, i + 1));
    places.Add(design.Uniform(0, i, 0), design.Uniform(0, i + 1, 0));
    keys.Add(u, design.Uniform(1, 0, i));
  }
  EXPECT_LT(KolmogorovSmirnov(draws, Same), kKolmogorovSmirnovBound);
  EXPECT_LT(repeats.ChiSquare(), ChiSquareBound(143));
  EXPECT_LT(places.ChiSquare(), ChiSquareBound(143));
  EXPECT_LT(keys.ChiSquare(), ChiSquareBound(143));
}

TEST(LatinHypercube, HitsEachStratumOnceForEachKeyAndPlace) {
  for (const std::uint64_t repeats : {1, 2, 7, 10, 64, 65, 100, 1000, 4099}) {
    const Design design = Make(DesignKind::kLatinHypercube, repeats);
    for (int key = 0; key < 3; ++key) {
      for (int place = 0; place < 3; ++place) {
        std::vector<int> hits(repeats);
        for (std::uint64_t i = 0; i < repeats; ++i) {
          ++hits.at(static_cast<std::size_t>(design.Uniform(key, place, i) * repeats));
        }
        EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), static_cast<long>(repeats)) << repeats;
      }
    }
  }
}

TEST(LatinHypercube, IsUniformInsideItsStrata) {
  constexpr int kRepeats = 20000;
  const Design design = Make(DesignKind::kLatinHypercube, kRepeats);
  std::vector<double> inside;
  for (int i = 0; i < kRepeats; ++i) {
    const double strata = design.Uniform(0, 0, i) * kRepeats;
    inside.push_back(strata - std::floor(strata));
  }
  EXPECT_LT(KolmogorovSmirnov(inside, Same), kKolmogorovSmirnovBound);
}

// With each stratum hit once, the sums of rows and columns are fixed: (cells - 1)^2 degrees.
TEST(LatinHypercube, PairsItsKeysPlacesAndNeighboursAtRandom) {
  constexpr int kRepeats = 14400;
  const Design design = Make(DesignKind::kLatinHypercube, kRepeats);
  PairCounts keys(12), places(12), neighbours(12);
  for (int i = 0; i < kRepeats; ++i) {
    const double u = design.Uniform(0, 0, i);
    keys.Add(u, design.Uniform(1, 0, i));
    places.Add(u, design.Uniform(0, 1, i));
    neighbours.Add(u, design.Uniform(0, 0, (i + 1) % kRepeats));
  }
  EXPECT_LT(keys.ChiSquare(), ChiSquareBound(121));
  EXPECT_LT(places.ChiSquare(), ChiSquareBound(121));
  EXPECT_LT(neighbours.ChiSquare(), ChiSquareBound(121));
}

// Ten runs at each of many places: Pearson's correlation of two keys has the variance 1 / (10 - 1)
// under random pairing of fixed strata, so its mean over the places is normal with 1 / (9 places).
TEST(LatinHypercube, OfFewRunsHasUncorrelatedKeysOnAverage) {
  constexpr int kRepeats = 10, kPlaces = 4000;
  const Design design = Make(DesignKind::kLatinHypercube, kRepeats);
  double sum = 0.0;
  for (int place = 0; place < kPlaces; ++place) {
    double product = 0.0;
    for (int i = 0; i < kRepeats; ++i) {
      const double a = std::floor(design.Uniform(0, place, i) * kRepeats) - 4.5;
      const double b = std::floor(design.Uniform(1, place, i) * kRepeats) - 4.5;
      product += a * b;
    }
    sum += product / 82.5;  // the sum of squares of -4.5, -3.5 ... 4.5
  }
  EXPECT_LT(std::abs(sum / kPlaces), 3.29 / std::sqrt(9.0 * kPlaces));
}

TEST(Sobol, HitsEachDyadicIntervalOnceAfterTheShift) {
  const Design design = Make(DesignKind::kSobol, 1024);
  for (int key = 0; key < 3; ++key) {
    for (int place = 0; place < 3; ++place) {
      for (int count = 1; count <= 1024; count *= 2) {
        std::vector<int> hits(count);
        for (int i = 0; i < count; ++i) {
          ++hits[static_cast<int>(design.Uniform(key, place, i) * count)];
        }
        EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), count);
      }
    }
  }
}

TEST(Sobol, HitsEachBoxOfTheFirstTwoKeysOnceAfterTheShift) {
  const Design design = Make(DesignKind::kSobol, 1024);
  for (const int wide : {2, 8, 32, 128, 512}) {
    const int high = 1024 / wide;
    std::vector<int> hits(1024);
    for (int i = 0; i < 1024; ++i) {
      ++hits[static_cast<int>(design.Uniform(0, 5, i) * wide) * high +
             static_cast<int>(design.Uniform(1, 5, i) * high)];
    }
    EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), 1024) << wide;
  }
}

TEST(Sobol, IsShiftedAtRandomForEachPlaceAndKey) {
  const Design design = Make(DesignKind::kSobol, 8);
  constexpr int kPlaces = 14400;
  std::vector<double> draws;
  PairCounts keys(12), places(12);
  for (int place = 0; place < kPlaces; ++place) {
    const double u = design.Uniform(0, place, 5);
    draws.push_back(u);
    keys.Add(u, design.Uniform(1, place, 5));
    places.Add(u, design.Uniform(0, place + 1, 5));
  }
  EXPECT_LT(KolmogorovSmirnov(draws, Same), kKolmogorovSmirnovBound);
  EXPECT_LT(keys.ChiSquare(), ChiSquareBound(143));
  EXPECT_LT(places.ChiSquare(), ChiSquareBound(143));
}

// The keys alone make 3/12 / ((13/12)^3 - 1) = 0.92 of the function's variance, which the hypercube
// removes: it spreads 3.6 times less. Sobol's points take the interaction as well, measured over
// 1000 places: 16 times less. Twenty places tell both within a third.
TEST(Design, SpreadsEstimatesOfAMeanLessByStrataAndLeastBySobol) {
  constexpr std::uint64_t kRuns = 256;
  const double random = SpreadOfMeans(Make(DesignKind::kMonteCarlo, kRuns), kRuns);
  EXPECT_LT(SpreadOfMeans(Make(DesignKind::kLatinHypercube, kRuns), kRuns), random / 2.0);
  EXPECT_LT(SpreadOfMeans(Make(DesignKind::kSobol, kRuns), kRuns), random / 8.0);
}

TEST(Design, MayHaveNoKeys) {
  for (const DesignKind kind : kKinds) EXPECT_NO_THROW(Make(kind, 4, {}));
}

TEST(DesignDeathTest, RefusesRunsAndKeysThatItDoesNotHave) {
  EXPECT_DEATH(Make(DesignKind::kMonteCarlo, 4).Uniform(3, 0, 0), "check failed");
  EXPECT_DEATH(Make(DesignKind::kLatinHypercube, 4).Uniform(0, 0, 4), "check failed");
  EXPECT_DEATH(Make(DesignKind::kSobol, 5).Uniform(0, 0, 5), "check failed");
  EXPECT_DEATH(Make(DesignKind::kSobol, 0), "check failed");
  EXPECT_DEATH(Make(DesignKind::kLatinHypercube, kMostRepeats + 1), "check failed");
  EXPECT_DEATH(Make(DesignKind::kMonteCarlo, 1, {"light", "light"}), "check failed");
  std::vector<std::string> many;
  for (std::size_t i = 0; i <= kSobolDimensions; ++i) many.push_back(std::to_string(i));
  EXPECT_DEATH(Make(DesignKind::kSobol, 4, many), "check failed");
}

}  // namespace
}  // namespace dockyard
