#include "sim/run/sensor_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

using testing::ElementsAre;

TEST(SensorLink, GivesAPromptSensorAsItIs) {
  SensorLink link({{"closed", "", "a switch", 20}}, Seed{});
  for (Tick tick = 0; tick < 200; tick += 20) {
    const double now = tick % 60 == 0 ? 1.0 : 0.0;
    EXPECT_THAT(link.Pass({now}, tick), ElementsAre(now));
  }
}

// Sampled at 0, 100, 200; 250 ms later it arrives, three samples are pending.
TEST(SensorLink, DeliversEachSampleAfterTheLatency) {
  SensorLink link({{"range_m", "m", "slow and late", 100, 250}}, Seed{});
  for (Tick tick = 0; tick < 1000; tick += 10) {
    const double expected =
        tick < 350 ? 0.0 : std::floor(static_cast<double>(tick - 250) / 100.0) * 100.0;
    EXPECT_THAT(link.Pass({static_cast<double>(tick)}, tick), ElementsAre(expected)) << tick;
  }
}

// The mean of n samples has a standard error of noise / sqrt(n), their deviation noise / sqrt(2 n).
TEST(SensorLink, AddsTheStatedNoiseToEachSample) {
  SensorLink link({{"depth_m", "m", "noisy", 20, 0, 0.5}, {"same_m", "m", "too", 20, 0, 0.5}},
                  Seed{});
  constexpr int kCount = 10'000;
  double sum = 0.0, squares = 0.0, product = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const std::vector<double> values = link.Pass({3.0, 0.0}, 20 * i);
    sum += values[0];
    squares += (values[0] - 3.0) * (values[0] - 3.0);
    product += (values[0] - 3.0) * values[1];
  }
  EXPECT_NEAR(sum / kCount, 3.0, 4.0 * 0.5 / 100.0);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.5, 4.0 * 0.5 / std::sqrt(2.0 * kCount));
  EXPECT_NEAR(product / kCount, 0.0, 4.0 * 0.25 / 100.0);  // each has errors of its own
}

}  // namespace
}  // namespace dockyard
