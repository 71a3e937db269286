#include "controller/axel/phases.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

namespace dockyard::axel {
namespace {

Phase PhaseAt(int i) { return static_cast<Phase>(i); }
Event EventAt(int i) { return static_cast<Event>(i); }

struct Row {
  Phase from;
  Event event;
  Phase to;
};
class PhaseTable : public testing::TestWithParam<Row> {};

TEST_P(PhaseTable, LeadsOn) { EXPECT_EQ(Next(GetParam().from, GetParam().event), GetParam().to); }

INSTANTIATE_TEST_SUITE_P(Paper, PhaseTable,
                         testing::Values(Row{Phase::kTighten, Event::kTaut, Phase::kLook},
                                         Row{Phase::kLook, Event::kGoApproach, Phase::kApproach},
                                         Row{Phase::kApproach, Event::kArrived, Phase::kTighten},
                                         Row{Phase::kLook, Event::kGoAlign, Phase::kAlign},
                                         Row{Phase::kLook, Event::kGoMate, Phase::kMate},
                                         Row{Phase::kMate, Event::kArrived, Phase::kRecheck},
                                         Row{Phase::kRecheck, Event::kGoMate, Phase::kEnter},
                                         Row{Phase::kRecheck, Event::kGoRecover, Phase::kRecover},
                                         Row{Phase::kEnter, Event::kArrived, Phase::kReel},
                                         Row{Phase::kConfirm, Event::kStopsShort, Phase::kReel},
                                         Row{Phase::kConfirm, Event::kStuck, Phase::kRecover},
                                         Row{Phase::kBackOff, Event::kDigs, Phase::kOut},
                                         Row{Phase::kRecover, Event::kDigs, Phase::kOut},
                                         Row{Phase::kOut, Event::kArrived, Phase::kTighten},
                                         Row{Phase::kReel, Event::kReeledIn, Phase::kConfirm},
                                         Row{Phase::kConfirm, Event::kSteady, Phase::kDocked}));

TEST(Phases, ReelingIsReachedOnlyByTheCheckAtTheMouthOrFromInside) {
  for (int p = 0; p < kPhaseCount; ++p) {
    for (int e = 0; e < kEventCount; ++e) {
      const auto to = Next(PhaseAt(p), EventAt(e));
      if (to == Phase::kReel && PhaseAt(p) == Phase::kHaul) continue;  // without cameras: felt
      if (to == Phase::kReel) {
        EXPECT_TRUE(PhaseAt(p) == Phase::kEnter || EventAt(e) == Event::kStopsShort ||
                    EventAt(e) == Event::kInside);
      }
      if (to == Phase::kEnter) {
        EXPECT_EQ(PhaseAt(p), Phase::kRecheck);
      }
      if (to == Phase::kDocked) {
        EXPECT_EQ(PhaseAt(p), Phase::kConfirm);
      }
    }
  }
}

TEST(Phases, TheSearchBeginsWithoutABoardOrWithTheTetherAbeam) {
  for (const Event event : {Event::kNotSeen, Event::kTetherAbeam})
    EXPECT_EQ(Next(Phase::kLook, event), Phase::kSearch);
}

TEST(Phases, TheWayOutLeadsBackToTheDocking) {
  EXPECT_EQ(Next(Phase::kUndock, Event::kArrived), Phase::kExcursion);
  EXPECT_EQ(Next(Phase::kExcursion, Event::kArrived), Phase::kReturn);
  EXPECT_EQ(Next(Phase::kReturn, Event::kArrived), Phase::kTighten);
}

TEST(Phases, NothingLeavesTheEnd) {
  for (int e = 0; e < kEventCount; ++e) {
    EXPECT_FALSE(Next(Phase::kDocked, EventAt(e)));
    EXPECT_FALSE(Next(Phase::kGivenUp, EventAt(e)));
  }
}

TEST(Phases, GivingUpIsPossibleFromEveryOtherPhase) {
  for (int p = 0; p < static_cast<int>(Phase::kDocked); ++p)
    EXPECT_EQ(Next(PhaseAt(p), Event::kLimitReached), Phase::kGivenUp);
}

TEST(Phases, EveryPhaseCanBeReached) {
  std::set<Phase> reached{Phase::kTighten, Phase::kUndock};  // where it starts
  for (int round = 0; round < kPhaseCount; ++round) {
    for (const Phase from : std::set<Phase>(reached)) {
      for (int e = 0; e < kEventCount; ++e) {
        if (const auto to = Next(from, EventAt(e))) reached.insert(*to);
      }
    }
  }
  EXPECT_EQ(reached.size(), static_cast<std::size_t>(kPhaseCount));
}

TEST(Phases, HaveDifferentNames) {
  std::set<std::string> names;
  for (int p = 0; p < kPhaseCount; ++p) names.insert(Name(PhaseAt(p)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kPhaseCount));
}

}  // namespace
}  // namespace dockyard::axel
