#include "controller/raposa/phases.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace dockyard::raposa {
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

TEST(Phases, AreAllReachedFromTheFirst) {
  EXPECT_EQ(ReachedFrom(AllPhases().front()).size(), static_cast<std::size_t>(kPhaseCount));
}

TEST(Phases, CanAllEndInSuccessAndInFailureUntilTheyHaveEnded) {
  for (const Phase phase : AllPhases()) {
    const bool ended = phase == Phase::kDocked || phase == Phase::kGivenUp;
    const std::set<Phase> reached = ReachedFrom(phase);
    EXPECT_EQ(reached.contains(Phase::kDocked), !ended) << Name(phase);
    EXPECT_EQ(reached.contains(Phase::kGivenUp), !ended) << Name(phase);
    EXPECT_EQ(reached.empty(), ended) << Name(phase);
  }
}

TEST(Phases, ClaimADockingAfterAPullAtClosedDoorsAlone) {
  EXPECT_EQ(Before(Phase::kDocked), std::set<Phase>{Phase::kProve});
  EXPECT_EQ(Before(Phase::kProve), std::set<Phase>{Phase::kClose});
  EXPECT_EQ(Before(Phase::kClose), std::set<Phase>{Phase::kBrake});
}

TEST(Phases, TakeNoImagesWithTheRobotOnItsSeat) {
  for (const Phase phase : {Phase::kBrake, Phase::kClose, Phase::kAjar, Phase::kProve}) {
    EXPECT_FALSE(TakesImages(phase)) << Name(phase);
    EXPECT_FALSE(MayFollow(phase, AllPhases().front())) << Name(phase);
  }
  EXPECT_TRUE(TakesImages(Phase::kApproach));
  EXPECT_TRUE(TakesImages(Phase::kRetreat));
}

}  // namespace
}  // namespace dockyard::raposa
