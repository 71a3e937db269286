#include "sim/statistics/multiple.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace dockyard {
namespace {

// By hand: 4 x 0.005, 3 x 0.01, 2 x 0.03, then 1 x 0.04 raised to the one before it.
TEST(Holm, TakesEachPTimesTheTestsThatAreLeft) {
  const std::vector<double> found = HolmAdjusted({0.01, 0.04, 0.03, 0.005});
  const std::vector<double> expected{0.03, 0.06, 0.06, 0.02};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-15);
}

TEST(Holm, IsAtMostOneAndLeavesOneTestAsItIs) {
  EXPECT_EQ(HolmAdjusted({0.3}), std::vector<double>{0.3});
  EXPECT_EQ(HolmAdjusted({0.6, 0.7, 1.0}), (std::vector<double>{1.0, 1.0, 1.0}));
  EXPECT_TRUE(HolmAdjusted({}).empty());
}

TEST(Holm, DoesNotCountWhatIsNoTest) {
  const std::vector<double> found = HolmAdjusted({std::nan(""), 0.01, 0.02});
  EXPECT_TRUE(std::isnan(found[0]));
  EXPECT_NEAR(found[1], 0.02, 1e-15);
  EXPECT_NEAR(found[2], 0.02, 1e-15);
}

// Of 40 draws that do not matter, 1 - 0.95^40 = 87 % of campaigns have a p below 0.05. Adjusted,
// 1 - (1 - 0.05 / 40)^40 = 4.88 % have one. 4000 campaigns: 3 sigma is 1.0 %.
TEST(Holm, KeepsTheChanceOfAnyFalseFinding) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  int raw = 0, adjusted = 0;
  for (int campaign = 0; campaign < 4000; ++campaign) {
    std::vector<double> p(40);
    for (double& each : p) each = uniform(random);
    const auto below = [](double each) { return each <= 0.05; };
    raw += std::any_of(p.begin(), p.end(), below);
    const std::vector<double> holm = HolmAdjusted(p);
    adjusted += std::any_of(holm.begin(), holm.end(), below);
  }
  EXPECT_NEAR(raw / 4000.0, 1.0 - std::pow(0.95, 40), 0.016);
  EXPECT_NEAR(adjusted / 4000.0, 1.0 - std::pow(1.0 - 0.05 / 40, 40), 0.0103);
}

TEST(ConfidenceOfEach, SharesTheRiskOut) {
  EXPECT_EQ(ConfidenceOfEach(0.95, 1), 0.95);
  EXPECT_NEAR(ConfidenceOfEach(0.95, 5), 0.99, 1e-15);
}

}  // namespace
}  // namespace dockyard
