#include "sim/report/baseline.h"

#include <gmock/gmock.h>

#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<RunResult> Rows(int count) { return FakeResults(count).results; }

BaselinePairs Pair(const std::vector<RunResult>& rows, const std::vector<RunResult>& baseline) {
  return PairWithBaseline(FakeColumns(), rows, FakeColumns(), baseline);
}

TEST(Baseline, OfTheSameResultsPairsAllOfThem) {
  const BaselinePairs pairs = Pair(Rows(9), Rows(9));
  EXPECT_EQ(pairs.counts.both, 6);
  EXPECT_EQ(pairs.counts.neither, 3);
  EXPECT_EQ(pairs.same_bits, 9);
  EXPECT_THAT(pairs.lost, IsEmpty());
  EXPECT_THAT(pairs.only_here, IsEmpty());
}

TEST(Baseline, NamesTheRunsThatOneSideAloneDocks) {
  std::vector<RunResult> rows = Rows(9);
  rows[0].success = rows[3].success = false;  // runs 1 and 4, lost
  rows[0].state_hash ^= 1;
  rows[3].state_hash ^= 1;
  rows[2].success = true;  // run 3
  rows[2].state_hash ^= 1;
  const BaselinePairs pairs = Pair(rows, Rows(9));
  EXPECT_THAT(pairs.lost, ElementsAre(1, 4));
  EXPECT_THAT(pairs.won, ElementsAre(3));
  EXPECT_EQ(pairs.counts.only_a, 1);
  EXPECT_EQ(pairs.counts.only_b, 2);
  EXPECT_EQ(pairs.counts.both, 4);
  EXPECT_EQ(pairs.counts.neither, 2);
  EXPECT_EQ(pairs.same_bits, 6);
}

TEST(Baseline, SaysWhichRunsDoNotPair) {
  std::vector<RunResult> here = Rows(7), there = Rows(9);
  here.erase(here.begin());        // run 1 is there alone, and so are 8 and 9
  there.erase(there.begin() + 1);  // run 2 is here alone
  here[1].seed ^= 1;               // run 3
  here[2].labels[1] = "3.25";      // run 4
  const BaselinePairs pairs = Pair(here, there);
  EXPECT_THAT(pairs.only_here, ElementsAre(2));
  EXPECT_THAT(pairs.only_there, ElementsAre(1, 8, 9));
  EXPECT_THAT(pairs.other_draw, ElementsAre(3, 4));
  EXPECT_EQ(pairs.counts.both + pairs.counts.neither, 3);
}

TEST(Baseline, ComparesTheLabelsThatBothHaveByTheirNames) {
  RowColumns swapped = FakeColumns();
  swapped.labels = {"start.r_m", "new"};
  std::vector<RunResult> there = Rows(3);
  for (RunResult& row : there) row.labels = {row.labels[1], "x"};
  there[1].labels[0] = "77";
  const BaselinePairs pairs = PairWithBaseline(FakeColumns(), Rows(3), swapped, there);
  EXPECT_THAT(pairs.other_draw, ElementsAre(2));
  EXPECT_EQ(pairs.same_bits, 2);
}

}  // namespace
}  // namespace dockyard
