#include "sim/campaign/retention.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "sim/base/random.h"

namespace dockyard {
namespace {

RunResult ResultOf(int run) {
  RunResult result;
  result.run = run;
  result.success = run % 4 != 0;
  result.outcome = result.success ? "docked" : run % 8 == 0 ? "timeout" : "missed";
  return result;
}

/// The runs whose logs are there after all have ended in this order.
std::set<int> KeptOf(const Keep& keep, const std::vector<int>& order) {
  Retention retention(keep);
  std::set<int> kept;
  for (const int run : order) {
    const Retention::Choice choice = retention.Choose(ResultOf(run));
    if (choice.drop) {
      EXPECT_EQ(kept.erase(*choice.drop), 1u);
    }
    if (choice.keep) kept.insert(run);
  }
  return kept;
}

std::vector<int> InOrder(int count) {
  std::vector<int> order;
  for (int run = 1; run <= count; ++run) order.push_back(run);
  return order;
}

TEST(Retention, KeepsTheFirstFailuresOfEachCause) {
  EXPECT_EQ(KeptOf({2, 0, true}, InOrder(40)), (std::set<int>{4, 8, 12, 16}));
}

TEST(Retention, KeepsTheSameLogsInWhateverOrderTheRunsEnd) {
  const Keep keep{3, 5, true};
  std::vector<int> order = InOrder(200);
  const std::set<int> kept = KeptOf(keep, order);
  RandomStream stream(StreamKey(1, "order"));
  for (int times = 0; times < 20; ++times) {
    for (std::size_t i = order.size() - 1; i > 0; --i) {
      std::swap(
          order[i],
          order[static_cast<std::size_t>(stream.Uniform(0.0, 1.0) * static_cast<double>(i + 1))]);
    }
    EXPECT_EQ(KeptOf(keep, order), kept);
  }
}

TEST(Retention, KeepsAboutOneSuccessInN) {
  for (const int n : {2, 10, 50}) {
    const auto kept = static_cast<double>(KeptOf({0, n, true}, InOrder(40000)).size());
    EXPECT_NEAR(kept, 30000.0 / n, 4.0 * std::sqrt(30000.0 / n)) << n;
  }
}

TEST(Retention, KeepsAllOrNone) {
  EXPECT_EQ(KeptOf({}, InOrder(40)).size(), 40u);
  EXPECT_TRUE(KeptOf(Keep::None(), InOrder(40)).empty());
}

}  // namespace
}  // namespace dockyard
