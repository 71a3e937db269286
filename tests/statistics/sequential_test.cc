#include "sim/statistics/sequential.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "sim/base/random.h"
#include "statistics/follow_runs.h"

namespace dockyard {
namespace {

// R = 0.80 against 0.90, both risks 5 %.
const SequentialAims kEven{.reliability = 0.8,
                           .confidence = 0.95,
                           .design_reliability = 0.9,
                           .power = 0.95,
                           .max_runs = 5000};

// NIST/SEMATECH e-Handbook 6.2.6: lots of 1 % (good) and 10 % (bad), 5 % of the good rejected and
// 10 % of the bad accepted: accept at -0.939 + 0.0397 n failures, reject at 1.205 + 0.0397 n.
TEST(WaldPlan, HasTheLinesOfTheHandbook) {
  const SequentialPlan plan = WaldPlan({.reliability = 0.9,
                                        .confidence = 0.9,
                                        .design_reliability = 0.99,
                                        .power = 0.95,
                                        .max_runs = 1000});
  const double per_failure_more = plan.per_success - plan.per_failure;
  EXPECT_NEAR(plan.per_success / per_failure_more, 0.0397, 5e-5);
  EXPECT_NEAR(-plan.accept_at / per_failure_more, -0.939, 5e-4);
  EXPECT_NEAR(-plan.reject_at / per_failure_more, 1.205, 5e-4);
}

TEST(StateAfter, KeepsToTheLinesOfTheHandbook) {
  const SequentialPlan plan = WaldPlan({.reliability = 0.9,
                                        .confidence = 0.9,
                                        .design_reliability = 0.99,
                                        .power = 0.95,
                                        .max_runs = 100});
  EXPECT_EQ(StateAfter(plan, 0, 0), SequentialState::kContinue);
  EXPECT_EQ(StateAfter(plan, 23, 0), SequentialState::kContinue);  // -0.939 + 0.913 < 0
  EXPECT_EQ(StateAfter(plan, 24, 0), SequentialState::kAccepted);
  EXPECT_EQ(StateAfter(plan, 19, 2), SequentialState::kRejected);  // 1.205 + 0.754 < 2
  EXPECT_EQ(StateAfter(plan, 21, 2), SequentialState::kContinue);  // 1.205 + 0.834 > 2
  EXPECT_EQ(StateAfter(plan, 99, 4), SequentialState::kContinue);  // 2.99 to 5.14
  EXPECT_EQ(StateAfter(plan, 100, 4), SequentialState::kUndecided);
}

// Exact values of a recursion in Python; an earlier simulation of 4000 tests gave the means 65, 75,
// 38 and 27.
TEST(ExactOperation, HasTheKnownRisksAndMeansOfAnEvenTest) {
  const SequentialPlan plan = WaldPlan(kEven);
  const SequentialOperation bad = ExactOperation(plan, 0.8), good = ExactOperation(plan, 0.9);
  EXPECT_NEAR(bad.accept, 0.0483, 5e-5);
  EXPECT_NEAR(good.reject, 0.0392, 5e-5);
  EXPECT_NEAR(bad.mean_runs, 65.47, 5e-3);
  EXPECT_NEAR(good.mean_runs, 74.95, 5e-3);
  EXPECT_NEAR(ExactOperation(plan, 0.95).mean_runs, 38.0, 0.5);
  EXPECT_NEAR(ExactOperation(plan, 0.99).mean_runs, 27.0, 0.5);
}

TEST(ExactOperation, IsTheSumOverAllSequencesOfRuns) {
  SequentialAims aims = kEven;
  aims.confidence = 0.7;
  aims.power = 0.7;
  aims.max_runs = 14;
  const SequentialPlan plan = WaldPlan(aims);
  for (const double reliability : {0.5, 0.8, 0.93}) {
    SequentialOperation sum;
    for (unsigned bits = 0; bits < 1u << 14; ++bits) {
      std::vector<bool> failed;
      double chance = 1.0;
      for (int i = 0; i < 14; ++i) {
        failed.push_back((bits >> i & 1u) != 0);
        chance *= failed.back() ? 1.0 - reliability : reliability;
      }
      const SequentialEnd end = FollowRuns(plan, failed);
      sum.accept += end.state == SequentialState::kAccepted ? chance : 0.0;
      sum.reject += end.state == SequentialState::kRejected ? chance : 0.0;
      sum.undecided += end.state == SequentialState::kUndecided ? chance : 0.0;
      sum.mean_runs += chance * end.trials;
    }
    const SequentialOperation exact = ExactOperation(plan, reliability);
    EXPECT_NEAR(exact.accept, sum.accept, 1e-12);
    EXPECT_NEAR(exact.reject, sum.reject, 1e-12);
    EXPECT_NEAR(exact.undecided, sum.undecided, 1e-12);
    EXPECT_NEAR(exact.mean_runs, sum.mean_runs, 1e-11);
    EXPECT_GT(sum.accept * sum.reject * sum.undecided, 0.0);  // all three ends are there
  }
}

TEST(ExactOperation, AgreesWithAHundredThousandSimulatedTests) {
  SequentialAims aims = kEven;
  aims.max_runs = 120;  // so that some end undecided
  const SequentialPlan plan = PlanSequential(aims);
  const double reliability = 0.86;
  RandomStream random(StreamKey(20, "sequential"));
  constexpr int kTests = 100'000;
  double accepted = 0.0, rejected = 0.0, runs = 0.0, runs_squared = 0.0;
  for (int test = 0; test < kTests; ++test) {
    double ratio = 0.0;
    int n = 0;
    while (n < aims.max_runs && ratio < plan.accept_at && ratio > plan.reject_at) {
      ratio += random.Uniform() < reliability ? std::log(0.9 / 0.8) : std::log(0.1 / 0.2);
      ++n;
    }
    accepted += ratio >= plan.accept_at;
    rejected += ratio <= plan.reject_at;
    runs += n;
    runs_squared += double(n) * n;
  }
  const SequentialOperation exact = ExactOperation(plan, reliability);
  const auto four_sigma = [](double share) {
    return 4.0 * std::sqrt(share * (1 - share) / kTests);
  };
  EXPECT_NEAR(accepted / kTests, exact.accept, four_sigma(exact.accept));
  EXPECT_NEAR(rejected / kTests, exact.reject, four_sigma(exact.reject));
  EXPECT_NEAR(1.0 - (accepted + rejected) / kTests, exact.undecided, four_sigma(exact.undecided));
  const double mean = runs / kTests, variance = runs_squared / kTests - mean * mean;
  EXPECT_NEAR(mean, exact.mean_runs, 4.0 * std::sqrt(variance / kTests));
  EXPECT_GT(exact.undecided, 0.05);
}

TEST(ExactOperation, AccountsForEveryTest) {
  for (const int max_runs : {1, 10, 300, 20'000}) {
    SequentialAims aims = kEven;
    aims.max_runs = max_runs;
    const SequentialPlan plan = PlanSequential(aims);
    for (double reliability = 0.0; reliability <= 1.0; reliability += 0.0625) {
      const SequentialOperation exact = ExactOperation(plan, reliability);
      EXPECT_NEAR(exact.accept + exact.reject + exact.undecided, 1.0, 1e-12) << reliability;
      EXPECT_LE(exact.mean_runs, max_runs);
    }
  }
}

TEST(ExactOperation, AcceptsTheBetterSystemMoreOften) {
  const SequentialPlan plan = PlanSequential(kEven);
  double before = -1.0;
  for (double reliability = 0.6; reliability < 0.99; reliability += 0.03125) {
    const double accept = ExactOperation(plan, reliability).accept;
    EXPECT_GT(accept, before) << reliability;
    before = accept;
  }
}

TEST(ExactOperation, EndsAtTheBoundWithoutChance) {
  const SequentialPlan plan = PlanSequential(kEven);
  const SequentialOperation perfect = ExactOperation(plan, 1.0), broken = ExactOperation(plan, 0.0);
  EXPECT_EQ(perfect.accept, 1.0);
  EXPECT_EQ(perfect.mean_runs, std::ceil(plan.accept_at / plan.per_success));
  EXPECT_EQ(broken.reject, 1.0);
  EXPECT_EQ(broken.mean_runs, std::ceil(plan.reject_at / plan.per_failure));
}

TEST(WaldPlan, CanAcceptABadSystemMoreOftenThanItSays) {
  const SequentialAims aims{};  // 0.95 at 95 %, designed for 0.99
  EXPECT_GT(ExactOperation(WaldPlan(aims), 0.95).accept, 0.05);
  EXPECT_LE(ExactOperation(PlanSequential(aims), 0.95).accept, 0.05);
}

TEST(PlanSequential, NeverAcceptsABadSystemMoreOftenThanTheConfidenceAllows) {
  for (const double reliability : {0.6, 0.8, 0.9, 0.95, 0.99, 0.999}) {
    for (const double better : {0.3, 0.5, 0.9}) {  // how much of the failures the design removes
      for (const double confidence : {0.6, 0.9, 0.95, 0.99}) {
        for (const double power : {0.6, 0.9, 0.99}) {
          for (const int max_runs : {20, 200, 2000}) {
            const SequentialAims aims{reliability, confidence,
                                      1.0 - (1.0 - better) * (1.0 - reliability), power, max_runs};
            const SequentialPlan wald = WaldPlan(aims), plan = PlanSequential(aims);
            EXPECT_LE(ExactOperation(plan, reliability).accept, 1.0 - confidence);
            EXPECT_GE(plan.accept_at, wald.accept_at);
            EXPECT_LE(plan.accept_at, -std::log(1.0 - confidence) + 1e-12);
          }
        }
      }
    }
  }
}

TEST(PlanSequential, LosesLittlePowerToTheHigherBound) {
  const SequentialAims aims{.reliability = 0.99,
                            .confidence = 0.95,
                            .design_reliability = 0.998,
                            .power = 0.9,
                            .max_runs = 5000};
  const SequentialPlan wald = WaldPlan(aims), plan = PlanSequential(aims);
  EXPECT_GT(plan.accept_at, wald.accept_at);
  const SequentialOperation before = ExactOperation(wald, 0.998),
                            after = ExactOperation(plan, 0.998);
  EXPECT_GT(after.accept, aims.power);
  EXPECT_GT(after.accept, before.accept - 0.001);
  EXPECT_LT(after.mean_runs, 1.02 * before.mean_runs);
}

TEST(AnEarlierEnd, LowersTheChanceToAcceptAnySystem) {
  SequentialAims aims = kEven;
  for (const double reliability : {0.7, 0.8, 0.85, 0.9, 0.95}) {
    double before = 2.0;
    for (const int max_runs : {2000, 200, 100, 50, 20}) {
      aims.max_runs = max_runs;
      const SequentialOperation exact = ExactOperation(WaldPlan(aims), reliability);
      EXPECT_LE(exact.accept, before) << reliability << " " << max_runs;
      before = exact.accept;
    }
    EXPECT_EQ(before, 0.0);  // 20 runs are too few for any acceptance
  }
}

TEST(FollowRun, StopsAtTheRunThatEndsTheTest) {
  const SequentialPlan plan = WaldPlan(kEven);  // rejects after 5 failures in a row
  const SequentialEnd end = FollowRuns(plan, std::vector<bool>(10, true));
  EXPECT_EQ(end.state, SequentialState::kRejected);
  EXPECT_EQ(end.trials, 5);
  EXPECT_EQ(end.failures, 5);
  const SequentialEnd open = FollowRuns(plan, {false, true, false});
  EXPECT_EQ(open.state, SequentialState::kContinue);
  EXPECT_EQ(open.trials, 3);
  EXPECT_EQ(open.failures, 1);
}

// Failures early reject; that later successes would bring the sum back does not count.
TEST(FollowRun, KeepsTheFirstDecision) {
  const SequentialPlan plan = WaldPlan(kEven);
  std::vector<bool> failed(5, true);
  failed.resize(200, false);
  EXPECT_EQ(FollowRuns(plan, failed).state, SequentialState::kRejected);
  EXPECT_EQ(StateAfter(plan, 200, 5), SequentialState::kAccepted);
}

}  // namespace
}  // namespace dockyard
