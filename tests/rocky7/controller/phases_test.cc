#include "controller/rocky7/phases.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace dockyard::rocky7 {
namespace {

constexpr Task kTasks[] = {Task::kReach, Task::kGrasp, Task::kPlace};

Phase FirstOf(Task task) { return task == Task::kPlace ? Phase::kAim : Phase::kObserve; }

/// Phases that events lead to, but for failures, and those of these that nothing leaves.
struct Walk {
  std::set<Phase> reached, dead_ends;
  std::set<std::pair<Phase, Phase>> steps;

  explicit Walk(Task task) {
    std::set<Phase> open{FirstOf(task)};
    while (!open.empty()) {
      const Phase phase = *open.begin();
      open.erase(open.begin());
      if (!reached.insert(phase).second) continue;
      bool leads_on = false;
      for (int e = 1; e < static_cast<int>(Event::kFailed); ++e) {
        const auto next = Next(task, phase, static_cast<Event>(e));
        if (!next) continue;
        leads_on = true;
        open.insert(*next);
        steps.insert({phase, *next});
      }
      if (!leads_on) dead_ends.insert(phase);
    }
  }
};

TEST(Phases, EachTaskEndsDoneAndNowhereElse) {
  for (const Task task : kTasks) {
    EXPECT_EQ(Walk(task).dead_ends, std::set<Phase>{Phase::kDone}) << static_cast<int>(task);
  }
}

TEST(Phases, AnyPhaseMayFailAndNothingLeavesTheEnd) {
  for (const Task task : kTasks) {
    for (int p = 0; p < kPhaseCount; ++p) {
      const Phase phase = static_cast<Phase>(p);
      EXPECT_EQ(Next(task, phase, Event::kNone), phase);
      if (!IsOver(phase)) {
        EXPECT_EQ(Next(task, phase, Event::kFailed), Phase::kGivenUp);
      }
      for (int e = 1; e < kEventCount && IsOver(phase); ++e) {
        EXPECT_FALSE(Next(task, phase, static_cast<Event>(e)));
      }
    }
  }
}

TEST(Phases, EveryTaskHasItsOwnAndAllOfThemBelongToOne) {
  std::set<Phase> all;
  for (const Task task : kTasks) {
    for (const Phase phase : Walk(task).reached) {
      all.insert(phase);
      EXPECT_FALSE(Grasps(phase) && task != Task::kGrasp);
      EXPECT_FALSE(Places(phase) && task != Task::kPlace);
    }
  }
  all.insert(Phase::kGivenUp);
  EXPECT_EQ(all.size(), static_cast<std::size_t>(kPhaseCount));
}

// The rover must not drive while arm or mast is out. A lift that missed ends with the arm up.
TEST(Phases, ArmAndMastComeBackBeforeTheRoverDrives) {
  for (const auto& [from, to] : Walk(Task::kGrasp).steps) {
    if (Approaches(to) && !Approaches(from)) {
      EXPECT_TRUE(from == Phase::kInspect || from == Phase::kLift);
    }
  }
  for (const auto& [from, to] : Walk(Task::kPlace).steps) {
    const bool moves = Approaches(to) || to == Phase::kBackOff;
    if (moves && !Approaches(from)) {
      EXPECT_EQ(from, Phase::kStow);
    }
  }
}

TEST(Phases, TheScoopsCloseOnlyAfterATouchAndTheInstrumentIsHeldOnlyAfterOne) {
  for (const Task task : kTasks) {
    for (int p = 0; p < kPhaseCount; ++p) {
      for (int e = 0; e < kEventCount; ++e) {
        const Phase from = static_cast<Phase>(p);
        const auto to = Next(task, from, static_cast<Event>(e));
        if (to == from) continue;
        if (to == Phase::kClose || to == Phase::kPress) {
          EXPECT_EQ(static_cast<Event>(e), Event::kTouched);
        }
        if (to == Phase::kHold) {
          EXPECT_EQ(from, Phase::kPress);
        }
      }
    }
  }
}

TEST(Phases, OnlyTheLastTwoAreAVerdict) {
  for (int p = 0; p < kPhaseCount; ++p) {
    const Phase phase = static_cast<Phase>(p);
    EXPECT_EQ(VerdictOf(phase) == Verdict::kUnderWay, !IsOver(phase));
    EXPECT_FALSE(std::string(Name(phase)).empty());
  }
  EXPECT_EQ(VerdictOf(Phase::kDone), Verdict::kDone);
  EXPECT_EQ(VerdictOf(Phase::kGivenUp), Verdict::kGivenUp);
}

TEST(PhasesDeathTest, AnEventThatMeansNothingIsAFault) {
  Phase phase = Phase::kDrive;
  EXPECT_DEATH(Follow(Task::kReach, Event::kTouched, phase), "check failed");
}

}  // namespace
}  // namespace dockyard::rocky7
