#include "sim/statistics/unpaired.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

// Fisher's tea (The Design of Experiments, 1935): 16 of the 70 choices are 3 of 4 right, 1 is 4 of
// 4. Two-sided (1 + 16 + 16 + 1) / 70.
TEST(FisherExact, CountsTheTablesThatAreNoMoreLikely) {
  EXPECT_NEAR(FisherExact({3, 4, 1, 4}), 34.0 / 70.0, 1e-12);
  EXPECT_NEAR(FisherExact({4, 4, 0, 4}), 2.0 / 70.0, 1e-12);
  EXPECT_NEAR(ChanceOfAWorseGroup({1, 4, 3, 4}), 17.0 / 70.0, 1e-12);
  EXPECT_NEAR(ChanceOfAWorseGroup({0, 4, 4, 4}), 1.0 / 70.0, 1e-12);
}

// Whole numbers by Python's math.comb: the sum of C(11, a) C(13, 10 - a) over those that are no
// more than C(11, 7) C(13, 3), over C(24, 10).
TEST(FisherExact, AgreesWithWholeNumbers) {
  const auto choose = [](int n, int k) {
    double c = 1.0;
    for (int i = 1; i <= k; ++i) c = c * (n - k + i) / i;
    return std::round(c);
  };
  double sum = 0.0;
  for (int a = 0; a <= 10; ++a) {
    const double tables = choose(11, a) * choose(13, 10 - a);
    if (tables <= choose(11, 7) * choose(13, 3)) sum += tables;
  }
  EXPECT_NEAR(FisherExact({7, 11, 3, 13}), sum / choose(24, 10), 1e-12);
}

TEST(FisherExact, KnowsNothingWithoutRunsOrDifference) {
  EXPECT_NEAR(FisherExact({0, 0, 3, 9}), 1.0, 1e-12);
  EXPECT_NEAR(FisherExact({5, 5, 9, 9}), 1.0, 1e-12);
  EXPECT_NEAR(FisherExact({500, 1000, 500, 1000}), 1.0, 1e-9);
}

// Newcombe (Stat. Med. 17, 873, 1998), table II, (a) and (e) by method 10.
TEST(GroupDifference, HasNewcombesIntervals) {
  const Estimate a = GroupDifference({56, 70, 48, 80});
  EXPECT_NEAR(a.value, 0.2, 1e-12);
  EXPECT_NEAR(a.interval.low, 0.0524, 5e-5);
  EXPECT_NEAR(a.interval.high, 0.3339, 5e-5);
  const Estimate all = GroupDifference({10, 10, 0, 20});
  EXPECT_NEAR(all.value, 1.0, 1e-12);
  EXPECT_NEAR(all.interval.low, 0.6791, 5e-5);
  EXPECT_NEAR(all.interval.high, 1.0, 1e-12);
}

TEST(GroupDifference, TurnsItsSignWithTheGroups) {
  const Estimate ab = GroupDifference({9, 10, 3, 10}), ba = GroupDifference({3, 10, 9, 10});
  EXPECT_NEAR(ab.value, -ba.value, 1e-15);
  EXPECT_NEAR(ab.interval.low, -ba.interval.high, 1e-15);
  EXPECT_TRUE(std::isnan(GroupDifference({0, 0, 1, 2}).value));
}

}  // namespace
}  // namespace dockyard
