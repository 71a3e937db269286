#include "sim/page/overview_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/page/markdown.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

TEST(OverviewPart, CountsWhatTheRowsHave) {
  const FinishedRuns runs = FakeResults(12);
  int docked = 0;
  for (const RunResult& row : runs.results) docked += row.success;
  const Json json = OverviewPart(nullptr, runs, FakeColumns(), {});
  EXPECT_EQ(json["totals"]["runs"], 12);
  EXPECT_EQ(json["totals"]["successes"], docked);
  int failed = 0;
  for (const Json& cause : json["causes"]) failed += cause["count"].get<int>();
  EXPECT_EQ(failed, 12 - docked);
  EXPECT_EQ(json["causes"][0]["outcome"], "missed");
  int in_groups = 0;
  for (const Json& value : json["groups"][0]["values"]) in_groups += value["runs"].get<int>();
  EXPECT_EQ(json["groups"][0]["label"], "soil");
  EXPECT_EQ(in_groups, 12);
}

// 4 of 6: the exact interval of Clopper and Pearson, from tables: 22.3 to 95.7 %.
TEST(OverviewPart, HasExactIntervals) {
  const Json json = OverviewPart(nullptr, FakeResults(12), FakeColumns(), {});
  const Json loose = json["groups"][0]["values"][0];
  ASSERT_EQ(loose["runs"], 6);
  ASSERT_EQ(loose["successes"], 4);
  EXPECT_NEAR(loose["interval"][0].get<double>(), 0.223, 5e-4);
  EXPECT_NEAR(loose["interval"][1].get<double>(), 0.957, 5e-4);
}

// 59 of 59 is the smallest success run for 95 % at 95 % (0.95^59 = 0.0485).
TEST(OverviewPart, JudgesAReliabilityThatIsAskedFor) {
  FinishedRuns runs = FakeResults(59);
  for (RunResult& row : runs.results) row.success = true;
  const Json shown = OverviewPart(nullptr, runs, FakeColumns(), AcceptanceAim{0.95, 0.95});
  EXPECT_EQ(shown["acceptance"]["verdict"], "accepted");
  runs.results[7].success = false;
  const Json open = OverviewPart(nullptr, runs, FakeColumns(), AcceptanceAim{0.95, 0.95});
  EXPECT_EQ(open["acceptance"]["verdict"], "undecided");
  EXPECT_EQ(open["acceptance"]["further_runs"], 93 - 59);  // 93 with one failure: Hanson and Beard
  EXPECT_FALSE(OverviewPart(nullptr, runs, FakeColumns(), {}).contains("acceptance"));
}

TEST(OverviewMarkdown, HasTheRateTheCausesAndTheCommandsThatReplayThem) {
  const Json json = OverviewPart(nullptr, FakeResults(12), FakeColumns(), AcceptanceAim{0.8, 0.95});
  const std::string text = OverviewMarkdown("yard", json, "dockyard replay out {run}");
  EXPECT_THAT(text, testing::StartsWith("# yard\n\ndocked 8/12 (67 %, 35-90 %)"));
  EXPECT_THAT(text, testing::HasSubstr("| soil | loose | 4/6 (67 %, 22-96 %) |"));
  EXPECT_THAT(text, testing::HasSubstr("| missed | 4 | 3 6 9 12 |"));
  EXPECT_THAT(text, testing::HasSubstr("\ndockyard replay out 6\n"));
  EXPECT_THAT(text, testing::HasSubstr("**undecided**: 8 of 12 docked"));
}

}  // namespace
}  // namespace dockyard
