#include "controller/custom/phases.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace dockyard::custom {
namespace {

std::vector<Phase> AllPhases() {
  std::vector<Phase> all;
  for (int i = 0; i < kPhaseCount; ++i) all.push_back(static_cast<Phase>(i));
  return all;
}

std::set<Phase> ReachedFrom(Phase start) {
  std::set<Phase> reached;
  std::vector<Phase> open{start};
  while (!open.empty()) {
    const Phase phase = open.back();
    open.pop_back();
    for (const Phase next : AllPhases()) {
      if (MayFollow(phase, next) && reached.insert(next).second) open.push_back(next);
    }
  }
  return reached;
}

std::set<Phase> Before(Phase phase) {
  std::set<Phase> before;
  for (const Phase from : AllPhases()) {
    if (MayFollow(from, phase)) before.insert(from);
  }
  return before;
}

TEST(CustomPhases, CanAllEndInSuccessAndInFailureUntilTheyHaveEnded) {
  EXPECT_EQ(ReachedFrom(AllPhases().front()).size(), static_cast<std::size_t>(kPhaseCount));
  for (const Phase phase : AllPhases()) {
    const bool ended = phase == Phase::kDocked || phase == Phase::kGivenUp;
    const std::set<Phase> reached = ReachedFrom(phase);
    EXPECT_EQ(reached.contains(Phase::kDocked), !ended) << Name(phase);
    EXPECT_EQ(reached.contains(Phase::kGivenUp), !ended) << Name(phase);
    EXPECT_EQ(reached.empty(), ended) << Name(phase);
  }
}

TEST(CustomPhases, ClaimADockingAfterTheWaitAlone) {
  EXPECT_EQ(Before(Phase::kDocked), std::set<Phase>{Phase::kWait});
}

TEST(CustomPhases, BackOffFromTheDockBeforeAnotherTry) {
  for (const Phase phase : {Phase::kControl, Phase::kPress, Phase::kWait, Phase::kWiggle})
    EXPECT_TRUE(MayFollow(phase, Phase::kBackOff)) << Name(phase);
}

TEST(CustomPhases, TakeNoImagesWhileWheelsSlipAtTheDock) {
  EXPECT_FALSE(TakesImages(Phase::kPress));
  EXPECT_FALSE(TakesImages(Phase::kWiggle));
  EXPECT_TRUE(TakesImages(Phase::kControl));
}

}  // namespace
}  // namespace dockyard::custom
