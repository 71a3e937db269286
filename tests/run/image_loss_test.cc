// Lost images: independent of each other and of the delay.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/run/camera_faults.h"
#include "sim/statistics/intervals.h"

namespace dockyard {
namespace {

ImageLink LinkWith(double lost, double delay_s, std::uint64_t seed) {
  CameraFaults faults;
  faults.lost = lost;
  faults.delay_s = delay_s;
  return {faults, seed};
}

std::vector<CameraImage> Two() { return {{0, GrayImage{1, 1, {3}}}, {1, GrayImage{1, 1, {4}}}}; }

// Two in succession are both lost by the square of the rate, three by its cube.
TEST(ImageLoss, IsIndependentOfThoseBefore) {
  constexpr int kGroups = 10000;
  constexpr double kLost = 0.4;
  ImageLink link = LinkWith(kLost, 0.0, 17);
  int pairs = 0, triples = 0;
  for (int i = 0; i < kGroups; ++i) {
    const bool first = !link.Send(Two(), 0), second = !link.Send(Two(), 0),
               third = !link.Send(Two(), 0);
    pairs += first && second;
    triples += first && second && third;
  }
  for (const auto& [count, power] : {std::pair{pairs, 2}, {triples, 3}}) {
    const Interval interval = ClopperPearson(count, kGroups, 0.999);
    EXPECT_LE(interval.low, std::pow(kLost, power));
    EXPECT_GE(interval.high, std::pow(kLost, power));
  }
}

TEST(ImageLoss, IsTheSameAtAnyDelay) {
  ImageLink prompt = LinkWith(0.3, 0.0, 5), late = LinkWith(0.3, 0.05, 5);
  for (Tick now = 0; now < 20'000; now += 100) {
    const bool arrives = prompt.Send(Two(), now);
    ASSERT_EQ(late.Send(Two(), now), arrives);
    ASSERT_TRUE(late.Receive(now + 49).empty());
    ASSERT_EQ(late.Receive(now + 50).size(), arrives ? 2u : 0u);  // of both cameras or of neither
  }
}

// An answer on its path is dropped when cameras are asked again, also where the new one is lost.
TEST(ImageLoss, LeavesNothingOfTheAnswerBefore) {
  int cases = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    ImageLink link = LinkWith(0.5, 0.1, seed);
    const bool first = link.Send(Two(), 0), second = link.Send(Two(), 20);
    if (!first || second) continue;
    ++cases;
    EXPECT_TRUE(link.Receive(100).empty());
    EXPECT_TRUE(link.Receive(1000).empty());
  }
  EXPECT_GT(cases, 5);  // a quarter of the seeds
}

}  // namespace
}  // namespace dockyard
