#include "controller/axel/search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/board_search.h"

namespace dockyard::axel {
namespace {

const SearchOptions kOptions{};

TEST(Search, LooksAgainFirst) {
  EXPECT_EQ(NextSearchAction(0, {.board_expected_in_view = true}, kOptions)->move,
            SearchMove::kAgain);
}

TEST(Search, IsBounded) {
  EXPECT_TRUE(NextSearchAction(8, {.board_expected_in_view = true}, kOptions));
  EXPECT_FALSE(NextSearchAction(9, {.board_expected_in_view = true}, kOptions));
}

TEST(Search, TurnsToWhereTheBoardShouldBe) {
  const SearchKnowledge aside{.expected_bearing_rad = -0.9, .tip_gap_m = 2.0};
  const auto action = NextSearchAction(0, aside, kOptions);
  EXPECT_EQ(action->move, SearchMove::kTurn);
  EXPECT_DOUBLE_EQ(action->amount, -0.9);
}

TEST(Search, GoesOnByDeadReckoningWhenFar) {
  const SearchKnowledge far{true, 0.0, 2.5};
  EXPECT_EQ(NextSearchAction(3, far, kOptions)->move, SearchMove::kAdvance);
}

TEST(Search, BacksUpInsteadWhenNear) {
  const SearchKnowledge near{true, 0.0, 0.4};
  EXPECT_EQ(NextSearchAction(3, near, kOptions)->move, SearchMove::kBackUp);
}

TEST(Search, TurnsToTheOtherSideInAMirroredWorld) {
  const SearchKnowledge left{true, 0.2, 2.5}, right{true, -0.2, 2.5};
  EXPECT_DOUBLE_EQ(NextSearchAction(5, left, kOptions)->amount,
                   -NextSearchAction(5, right, kOptions)->amount);
}

TEST(Search, LetsTheTetherTurnItWhileTheTetherIsAbeam) {
  const SearchKnowledge abeam{
      .expected_bearing_rad = 1.2, .tip_gap_m = 2.0, .tether_rad = Radians(80.0)};
  EXPECT_EQ(NextSearchAction(0, abeam, kOptions)->move, SearchMove::kReel);
}

// It tipped over with the tether at 95 to 104 deg against the arm.
TEST(BoardSearch, ARoverThatFoundTheBoardDrivesUnlessTheTetherWouldTipItOver) {
  for (const double tether_deg : {-100.0, -80.0, 50.0, 90.0, 100.0}) {
    BoardSearch search(TestNominal(), AxelOptions{});
    const SearchKnowledge known{.tip_gap_m = 2.0, .tether_rad = Radians(tether_deg)};
    EXPECT_EQ(search.PullsFirst(known), std::abs(tether_deg) > 95.0) << tether_deg;
  }
}

}  // namespace
}  // namespace dockyard::axel
