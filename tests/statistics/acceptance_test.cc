#include "sim/statistics/acceptance.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "sim/statistics/intervals.h"
#include "statistics/binomial.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;

std::vector<std::int64_t> RunsForFailures(double reliability, double confidence, int count) {
  std::vector<std::int64_t> runs;
  for (int k = 0; k < count; ++k) {
    runs.push_back(RunsNeeded(reliability, confidence, k).value());
  }
  return runs;
}

TEST(RunsNeeded, AreThoseOfWilksFormula) {  // Nutt and Wallis, Reliab. Eng. Syst. Saf. 83 (2004)
  EXPECT_THAT(RunsForFailures(0.95, 0.95, 6), ElementsAre(59, 93, 124, 153, 181, 208));
}

TEST(RunsNeeded, AreThoseOfTheSuccessRunTables) {
  EXPECT_THAT(RunsForFailures(0.99, 0.95, 3), ElementsAre(299, 473, 628));
}

TEST(RunsNeeded, AreThoseOfTenPercentConsumersRisk) {  // Hanson and Beard, NASA/TP-2010-216447
  EXPECT_THAT(RunsForFailures(0.99865, 0.9, 5), ElementsAre(1705, 2880, 3941, 4947, 5920));
  EXPECT_THAT(RunsForFailures(0.9, 0.9, 5), ElementsAre(22, 38, 52, 65, 78));
  EXPECT_THAT(RunsForFailures(0.95, 0.9, 5), ElementsAre(45, 77, 105, 132, 158));
  EXPECT_THAT(RunsForFailures(0.99, 0.9, 5), ElementsAre(230, 388, 531, 667, 798));
}

TEST(RunsNeeded, WithoutFailuresFollowTheSuccessRun) {  // n = ceil(ln(1 - C) / ln R), ASTM F3499
  for (const double reliability : {0.5, 0.8, 0.9, 0.95, 0.99, 0.997, 0.9999, 0.999999}) {
    for (const double confidence : {0.6, 0.9, 0.95, 0.999}) {
      EXPECT_EQ(RunsNeeded(reliability, confidence, 0).value(),
                std::ceil(std::log(1.0 - confidence) / std::log(reliability)))
          << reliability << " " << confidence;
    }
  }
}

TEST(RunsNeeded, DoNotHangOnTheLastBitOfARoundConfidence) {  // 0.2 = 1 - 0.8, 0.3^2 = 1 - 0.91
  EXPECT_EQ(RunsNeeded(0.2, 0.8, 0), 1);
  EXPECT_EQ(RunsNeeded(0.3, 0.91, 0), 2);
}

/// P(X <= failures) with many trials and few failures, each term from the one before.
double FewFailures(int failures, std::int64_t trials, double failing) {
  double term = std::exp(double(trials) * std::log1p(-failing)), sum = term;
  for (int k = 0; k < failures; ++k) {
    term *= double(trials - k) / (k + 1.0) * failing / (1.0 - failing);
    sum += term;
  }
  return sum;
}

TEST(RunsNeeded, AreTheFirstThatAreEnoughUpToTensOfMillions) {
  for (const double failing : {0.1, 1e-2, 1e-4, 1e-6}) {
    for (const int failures : {0, 1, 5, 20}) {
      const std::int64_t runs = RunsNeeded(1.0 - failing, 0.95, failures).value();
      EXPECT_LE(FewFailures(failures, runs, failing), 0.05) << failing << " " << failures;
      EXPECT_GT(FewFailures(failures, runs - 1, failing), 0.05) << failing << " " << failures;
    }
  }
}

TEST(RunsNeeded, AreNoneForAReliabilityOfOne) {
  EXPECT_FALSE(RunsNeeded(1.0, 0.95, 0).has_value());
  EXPECT_FALSE(RunsNeeded(1.0, 0.95, 3).has_value());
}

TEST(JudgeAcceptance, GoesByTheOneSidedBounds) {
  for (const double reliability : {0.5, 0.8, 0.95}) {
    for (const double confidence : {0.5, 0.9}) {
      for (int n = 0; n <= 60; n += 1 + n / 5) {
        for (int k = 0; k <= n; ++k) {
          const Acceptance judged = JudgeAcceptance(n, k, reliability, confidence);
          EXPECT_EQ(judged.lower, LowerBound(n - k, n, confidence));
          EXPECT_EQ(judged.upper, UpperBound(n - k, n, confidence));
          // 1e-12 for a bound that is the reliability itself, as with 1 run, R = C = 0.5.
          const AcceptanceVerdict expected =
              judged.lower >= reliability - 1e-12  ? AcceptanceVerdict::kAccepted
              : judged.upper < reliability - 1e-12 ? AcceptanceVerdict::kNotAccepted
                                                   : AcceptanceVerdict::kUndecided;
          EXPECT_EQ(judged.verdict, expected) << n << " " << k << " " << reliability;
        }
      }
    }
  }
}

TEST(JudgeAcceptance, ErrsAtMostWithTheRiskThatTheConfidenceLeaves) {
  for (const double reliability : {0.6, 0.8, 0.95}) {
    for (const double confidence : {0.6, 0.95}) {
      for (int n = 1; n <= 120; n += 1 + n / 5) {
        double accepted = 0.0, refused = 0.0;
        for (int k = 0; k <= n; ++k) {
          const double chance = BinomialChance(k, n, 1.0 - reliability);
          const auto verdict = JudgeAcceptance(n, k, reliability, confidence).verdict;
          if (verdict == AcceptanceVerdict::kAccepted) accepted += chance;
          if (verdict == AcceptanceVerdict::kNotAccepted) refused += chance;
        }
        EXPECT_LE(accepted, 1.0 - confidence + 1e-12) << n << " " << reliability;
        EXPECT_LE(refused, 1.0 - confidence + 1e-12) << n << " " << reliability;
      }
    }
  }
}

TEST(JudgeAcceptance, NamesTheFewestFurtherSuccessesThatAreEnough) {
  for (const int k : {0, 1, 2, 4}) {
    const int n = 50 + 20 * k;
    const Acceptance now = JudgeAcceptance(n, k, 0.95, 0.95);
    ASSERT_EQ(now.verdict, AcceptanceVerdict::kUndecided) << k;
    const int then = n + static_cast<int>(now.further_runs.value());
    EXPECT_EQ(JudgeAcceptance(then, k, 0.95, 0.95).verdict, AcceptanceVerdict::kAccepted);
    EXPECT_EQ(JudgeAcceptance(then - 1, k, 0.95, 0.95).verdict, AcceptanceVerdict::kUndecided);
  }
  EXPECT_EQ(JudgeAcceptance(0, 0, 0.95, 0.95).further_runs, 59);
}

TEST(JudgeAcceptance, AsksForNoFurtherRunsOnceItIsDecided) {
  EXPECT_EQ(JudgeAcceptance(59, 0, 0.95, 0.95).further_runs, 0);
  const Acceptance refused = JudgeAcceptance(59, 20, 0.95, 0.95);
  EXPECT_EQ(refused.verdict, AcceptanceVerdict::kNotAccepted);
  EXPECT_FALSE(refused.further_runs.has_value());
}

TEST(JudgeAcceptance, NeverAcceptsAReliabilityOfOne) {
  const Acceptance spotless = JudgeAcceptance(10'000'000, 0, 1.0, 0.95);
  EXPECT_EQ(spotless.verdict, AcceptanceVerdict::kUndecided);
  EXPECT_FALSE(spotless.further_runs.has_value());
  EXPECT_EQ(JudgeAcceptance(10'000'000, 1, 1.0, 0.95).verdict, AcceptanceVerdict::kNotAccepted);
}

TEST(JudgeAcceptance, HasTheRightBoundsOfTenMillionRuns) {
  for (const int k : {0, 1, 5, 20}) {
    const Acceptance judged = JudgeAcceptance(10'000'000, k, 0.999999, 0.95);
    EXPECT_NEAR(FewFailures(k, 10'000'000, 1.0 - judged.lower), 0.05, 1e-8) << k;
    if (k == 0) continue;
    EXPECT_NEAR(1.0 - FewFailures(k - 1, 10'000'000, 1.0 - judged.upper), 0.05, 1e-8) << k;
  }
}

/// Chance that a system of that reliability passes one of the plans of 0 to `most` failures, when
/// one looks at each plan's number of runs and goes on.
double ChanceToPassSomePlan(double reliability, double confidence, int most) {
  std::vector<double> going(static_cast<std::size_t>(most) + 1, 0.0);  // by failures so far
  going[0] = 1.0;
  double passed = 0.0;
  std::int64_t runs = 0;
  for (int plan = 0; plan <= most; ++plan) {
    for (; runs < RunsNeeded(reliability, confidence, plan); ++runs) {
      for (std::size_t k = going.size() - 1; k > 0; --k) {
        going[k] = going[k] * reliability + going[k - 1] * (1.0 - reliability);
      }
      going[0] *= reliability;
    }
    for (std::size_t k = 0; k <= static_cast<std::size_t>(plan); ++k) {
      passed += going[k];
      going[k] = 0.0;
    }
  }
  return passed;
}

// The reason for sequential.h.
TEST(JudgeAcceptance, PassesTooOftenWhenOneLooksAgainAfterEachFailure) {
  EXPECT_NEAR(ChanceToPassSomePlan(0.99, 0.95, 0), 0.05, 5e-4);
  EXPECT_NEAR(ChanceToPassSomePlan(0.99, 0.95, 4), 0.118, 5e-4);
  EXPECT_NEAR(ChanceToPassSomePlan(0.99, 0.95, 10), 0.160, 5e-4);
  EXPECT_NEAR(ChanceToPassSomePlan(0.95, 0.95, 4), 0.117, 5e-4);
  EXPECT_NEAR(ChanceToPassSomePlan(0.95, 0.95, 10), 0.159, 5e-4);
}

}  // namespace
}  // namespace dockyard
