#include "models/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

TEST(RandomStream, IsTheSameForTheSameKeyAndOtherForAnother) {
  RandomStream a(StreamKey(7, "imu")), b(StreamKey(7, "imu")), c(StreamKey(7, "light"));
  const std::uint64_t first = a.NextBits();
  EXPECT_EQ(first, b.NextBits());
  EXPECT_NE(first, c.NextBits());
}

TEST(RandomStream, UniformHasItsMomentsAndBounds) {
  RandomStream random(3);
  constexpr int kDraws = 100000;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.Uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  // Standard errors: 0.00091 of the mean, 0.00094 of the second moment; four of them.
  EXPECT_NEAR(sum / kDraws, 0.5, 0.0037);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.0038);
}

TEST(RandomStream, NormalFollowsItsDistributionFunction) {
  RandomStream random(4);
  constexpr int kDraws = 100000;
  for (const double z : {-2.0, -1.0, 0.0, 0.5, 1.5}) {
    int below = 0;
    for (int i = 0; i < kDraws; ++i) below += random.Normal() < z;
    const double p = 0.5 * std::erfc(-z / std::sqrt(2.0));
    EXPECT_NEAR(static_cast<double>(below) / kDraws, p, 4.0 * std::sqrt(p * (1 - p) / kDraws));
  }
}

TEST(RunSeed, DiffersFromRunToRunAndFromCampaignToCampaign) {
  EXPECT_NE(RunSeed(1, 1), RunSeed(1, 2));
  EXPECT_NE(RunSeed(1, 1), RunSeed(2, 1));
  EXPECT_NE(RunSeed(1, 2), RunSeed(2, 1));
}

}  // namespace
}  // namespace dockyard
