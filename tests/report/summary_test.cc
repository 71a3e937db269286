#include "sim/report/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "sim/base/text.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Four runs whose every number is known.
FinishedRuns FourRuns() {
  FinishedRuns runs;
  for (int i = 1; i <= 4; ++i) {
    RunResult row;
    row.run = i;
    row.labels = {i % 2 == 1 ? "loose" : "compact", "1.5"};
    row.success = i == 1;
    row.outcome = i == 1 ? "docked" : i == 2 ? "timeout" : i == 3 ? "missed" : kCrashed;
    row.sim_time_s = 100.25 * i;
    row.images = 2 * i;
    if (i < 4) row.measures = {0.21034 * i, 7.0, 8.0};
    runs.Add({row, {}, i == 3 ? "it drove past" : ""});
  }
  return runs;
}

TEST(Summary, OfFourRunsIsThis) {
  EXPECT_EQ(SummaryText("four", FourRuns(), FakeColumns(), 6),
            "four: docked 1/4 (25 %, 1-81 %), 95 % intervals (Clopper-Pearson)\n"
            "incomplete: 4 of 6 runs\n"
            "all runs: start.r_m 1.5\n"
            "\n"
            "  soil  loose    docked 1/2 (50 %, 1-99 %)\n"
            "  soil  compact  docked 0/2 (0 %, 0-84 %)\n"
            "\n"
            "failures by cause\n"
            "  missed   1   run 3\n"
            "  timeout  1   run 2\n"
            "  crashed  1   run 4\n"
            "\n"
            "run  soil     outcome  time_s  images  depth_m\n"
            "  1  loose    docked    100.2       2   0.2103\n"
            "  2  compact  timeout   200.5       4   0.4207\n"
            "  3  loose    missed    300.8       6    0.631\n"
            "     it drove past\n"
            "  4  compact  crashed   401.0       8        -\n");
}

TEST(Summary, ListsNumbersOfALabelInRisingOrder) {
  FinishedRuns runs;
  for (const char* angle : {"5", "-10", "0", "5", "-10", "0"}) {
    RunResult row;
    row.run = static_cast<int>(runs.results.size()) + 1;
    row.labels = {"loose", angle};
    row.outcome = "missed";
    runs.Add({row, {}, ""});
  }
  EXPECT_THAT(SummaryText("angles", runs, FakeColumns(), 6),
              testing::ContainsRegex(" -10 .*\n.* 0 .*\n.* 5 .*\n\nfailures"));
}

TEST(Summary, LeavesOutRepeatsThatOnlySayTheRunsNumbersAgain) {
  RowColumns columns = FakeColumns();
  columns.labels = {"repeat", "start.r_m"};
  FinishedRuns runs;
  for (int i = 1; i <= 4; ++i) {
    RunResult row;
    row.run = i;
    row.labels = {std::to_string(i), std::to_string(i)};
    row.outcome = "missed";
    runs.Add({row, {}, ""});
  }
  EXPECT_THAT(SummaryText("repeats", runs, columns, 4),
              AllOf(HasSubstr("\nrun  r_m  outcome "), Not(HasSubstr("repeat "))));
  runs.results.back().labels[0] = "1";  // now it says more
  EXPECT_THAT(SummaryText("repeats", runs, columns, 4), HasSubstr("\nrun  repeat  r_m  outcome "));
}

TEST(Summary, GroupsByEveryLabelOfTwoToEightValues) {
  const std::string text = SummaryText("fake", FakeResults(12), FakeColumns(), 12);
  EXPECT_THAT(text, HasSubstr("fake: docked 8/12 (67 %, 35-90 %)"));
  EXPECT_THAT(text, HasSubstr("  soil  compact  docked 4/6 (67 %, 22-96 %)\n"
                              "  soil  loose    docked 4/6 (67 %, 22-96 %)\n"));
  EXPECT_THAT(text, Not(HasSubstr("start.r_m  2.5")));  // nine values
  EXPECT_THAT(SummaryText("fake", FourRuns(), FakeColumns(), 4), HasSubstr("  soil  loose"));
  EXPECT_THAT(text, HasSubstr("missed  4   runs 3 6 9 12"));
  EXPECT_THAT(text, Not(HasSubstr("incomplete")));
}

// Of 8 runs each has its own distance: the table of runs has those.
TEST(Summary, GroupsByNoLabelWhoseValuesDoNotRepeat) {
  FinishedRuns runs = FakeResults(8);
  const std::string single = "  start.r_m  2.5 ";
  EXPECT_THAT(SummaryText("fake", runs, FakeColumns(), 8), Not(HasSubstr(single)));
  const FinishedRuns again = FakeResults(8);
  for (RunResult row : again.results) {
    row.run += 8;
    runs.Add({row, {}, ""});
  }
  EXPECT_THAT(SummaryText("fake", runs, FakeColumns(), 16), HasSubstr(single));
}

TEST(Summary, OfACampaignThatWasEnoughIsNotIncomplete) {
  const std::string text = SummaryText("fake", FakeResults(12), FakeColumns(), 628, true);
  EXPECT_THAT(text, HasSubstr("ended early, by --until-accepted: 12 of 628 runs\n"));
  EXPECT_THAT(text, Not(HasSubstr("incomplete")));
}

TEST(Summary, HasColumnsAsWideAsTheirLongestCell) {
  FinishedRuns runs = FourRuns();
  runs.results[1].labels[0] = "a soil with a long name, \"quoted\"";
  const std::string text = SummaryText("four", runs, FakeColumns(), 4);
  EXPECT_THAT(text, HasSubstr("\n  2  a soil with a long name, \"quoted\"  timeout"));
  EXPECT_THAT(text, HasSubstr("\n  1  loose                              docked"));
}

TEST(Summary, StaysUnderAHundredColumns) {
  FinishedRuns runs = FakeResults(120);
  for (RunResult& result : runs.results) {
    result.success = false;
    result.outcome = "missed";
  }
  std::istringstream lines(SummaryText("fake", runs, FakeColumns(), 120));
  std::string line, all;
  while (std::getline(lines, line)) {
    EXPECT_LT(line.size(), 100u) << line;
    all += line + " ";
  }
  EXPECT_THAT(all, HasSubstr(" 59 60 ... "));
}

TEST(Summary, LeavesOutLabelsThatALineHasNoRoomFor) {
  FinishedRuns runs = FourRuns();
  RowColumns columns = FakeColumns();
  for (int label = 0; label < 20; ++label) {
    columns.labels.push_back("as_built.robot.number_" + std::to_string(label));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs.results[i].labels.push_back(NumberText(1.0 / static_cast<double>(3 + i + label)));
    }
  }
  const std::string text = SummaryText("four", runs, columns, 4);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 100u) << line;
  EXPECT_THAT(text,
              HasSubstr("run  soil     number_0  number_1  number_2  number_3  number_4  outcome"));
  EXPECT_THAT(text,
              HasSubstr("  1  loose      0.3333      0.25       0.2    0.1667    0.1429  docked"));
  EXPECT_THAT(text, HasSubstr("15 more labels are in results.csv\n"));
}

TEST(Summary, OfManyRunsListsTheFirstFailures) {
  const std::string text = SummaryText("fake", FakeResults(900), FakeColumns(), 900);
  EXPECT_THAT(text, HasSubstr("of 900 runs the first 60 failures; results.csv has all"));
  EXPECT_THAT(text, HasSubstr("\n  3  "));
  EXPECT_THAT(text, Not(HasSubstr("\n  4  ")));
}

TEST(Summary, OfNoRunsSaysSo) {
  EXPECT_THAT(SummaryText("none", {}, FakeColumns(), 3),
              HasSubstr("none: docked 0/0, 95 % intervals (Clopper-Pearson)\nincomplete: 0 of 3"));
}

}  // namespace
}  // namespace dockyard
