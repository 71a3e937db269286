#include "sim/report/requirement.h"

#include <gmock/gmock.h>

#include <cmath>

#include "sim/statistics/intervals.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Campaign TwoArms() {
  Campaign campaign;
  campaign.arms = {{"ours", {}}, {"paper", {}}};
  campaign.grid = {{{"soil", {}}, {"loose", "compact"}, {}}};
  return campaign;
}

RowColumns Columns() {
  RowColumns columns = FakeColumns();
  columns.labels = {"arm", "soil", "start.r_m"};
  return columns;
}

/// Twenty runs, ours and the paper's in turn: of ours 8 of 10 dock, the first crashes; of the
/// paper's 5 of 10. Depths are 0.1, 0.2 .. by run.
std::vector<RunResult> Rows20() {
  std::vector<RunResult> rows;
  for (int i = 0; i < 20; ++i) {
    RunResult row;
    row.run = i + 1;
    const bool ours = i % 2 == 0;
    row.labels = {ours ? "ours" : "paper", i % 4 < 2 ? "loose" : "compact", "2"};
    row.success = ours ? i > 3 : i < 10;
    row.outcome = row.success ? "docked" : i == 0 ? kCrashed : "missed";
    row.sim_time_s = 10.0 * i;
    if (i > 0) row.measures = {0.1 * (i + 1), i == 1 ? std::nan("") : 5.0, 0.0};
    rows.push_back(row);
  }
  return rows;
}

Requirement Parsed(const std::string& text) {
  const auto parsed = ParseRequirement(text, Columns(), TwoArms());
  EXPECT_TRUE(parsed) << parsed.error();
  return parsed ? *parsed : Requirement{};
}

Judgement Judged(const std::string& text) { return Judge(Parsed(text), Columns(), Rows20()); }

std::string Refused(const std::string& text) {
  const auto parsed = ParseRequirement(text, Columns(), TwoArms());
  return parsed ? "taken" : parsed.error();
}

TEST(Requirement, ComparesTheObservedShare) {
  EXPECT_DOUBLE_EQ(Judged("success >= 0.65").found, 0.65);
  EXPECT_TRUE(Judged("success >= 0.65").met);
  EXPECT_FALSE(Judged("success > 0.65").met);
  EXPECT_TRUE(Judged("success <= 0.65").met);
  EXPECT_FALSE(Judged("success<0.65").met);
  EXPECT_EQ(Judged("success >= 0.7").text, "not met: success >= 0.7, found 0.65 (13/20)");
}

TEST(Requirement, HoldsForTheRunsWithItsLabels) {
  EXPECT_DOUBLE_EQ(Judged("success[arm=ours] >= 0.9").found, 0.8);
  EXPECT_DOUBLE_EQ(Judged(" success [ arm = paper ] >= 0.5 ").found, 0.5);
  EXPECT_EQ(Judged("success[arm=ours, soil=loose] >= 0").count, 5);
  EXPECT_EQ(Judged("success[start.r_m=2] >= 0").count, 20);
}

TEST(Requirement, BoundsAreThoseOfClopperAndPearsonOneSided) {
  EXPECT_EQ(Judged("success.lower95 >= 0.5").found, LowerBound(13, 20, 0.95));
  EXPECT_EQ(Judged("success[arm=ours].upper99.5 <= 1").found, UpperBound(8, 10, 0.995));
  EXPECT_EQ(Judged("outcome.missed.upper90 <= 1").found, UpperBound(6, 20, 0.90));
}

TEST(Requirement, CountsACrashAsNotDockedAndAsAnOutcome) {
  EXPECT_DOUBLE_EQ(Judged("outcome.crashed <= 0").found, 0.05);
  EXPECT_DOUBLE_EQ(Judged("outcome.timeout <= 0").found, 0.0);
  EXPECT_DOUBLE_EQ(Judged("outcome.docked[arm=ours] >= 0").found, 0.8);
}

TEST(Requirement, TakesMeansAndQuantilesOfMeasures) {
  EXPECT_DOUBLE_EQ(Judged("depth_m.min >= 0").found, 0.2);
  EXPECT_DOUBLE_EQ(Judged("depth_m.max >= 0").found, 2.0);
  EXPECT_DOUBLE_EQ(Judged("depth_m.mean >= 0").found, 1.1);
  EXPECT_DOUBLE_EQ(Judged("depth_m.median >= 0").found, 1.1);
  EXPECT_DOUBLE_EQ(Judged("depth_m.p25 >= 0").found, 0.65);
  EXPECT_DOUBLE_EQ(Judged("sim_time_s[arm=paper].p100 <= 1e3").found, 190.0);
  EXPECT_EQ(Judged("force_peak_n.mean <= 5").count, 18);  // without the crash and the NaN
  EXPECT_TRUE(Judged("yaw_error_deg.max > -1").met);
}

TEST(Requirement, IsNotMetWithoutARun) {
  for (const char* text : {"success[start.r_m=9] >= 0", "success[start.r_m=9].lower95 >= 0",
                           "depth_m[start.r_m=9].mean >= 0", "depth_m[start.r_m=9].p5 <= 0"}) {
    const Judgement judged = Judged(text);
    EXPECT_FALSE(judged.met) << text;
    EXPECT_TRUE(std::isnan(judged.found)) << text;
    EXPECT_THAT(judged.text, HasSubstr("found no run to judge"));
  }
}

TEST(Requirement, RefusesWhatItDoesNotKnowAndNamesWhatItDoes) {
  EXPECT_THAT(Refused("docket >= 0.9"),
              AllOf(HasSubstr("expected one of success, sim_time_s, depth_m"),
                    HasSubstr("outcome.missed"), HasSubstr("found 'docket'")));
  EXPECT_THAT(Refused("outcome.lost >= 0.9"), HasSubstr("found 'outcome.lost'"));
  EXPECT_THAT(Refused("success[weather=calm] >= 0.9"),
              HasSubstr("expected a label (arm, soil, start.r_m, controller), found 'weather'"));
  EXPECT_THAT(Refused("success[arm=our] >= 0.9"),
              HasSubstr("expected arm to be one of ours, paper, found 'our'"));
  EXPECT_THAT(Refused("success[soil=sand] >= 0.9"), HasSubstr("one of loose, compact"));
  EXPECT_THAT(Refused("success.lower >= 0.9"), HasSubstr(".lower95"));
  EXPECT_THAT(Refused("success.lower40 >= 0.9"), HasSubstr("from 50 on"));
  EXPECT_THAT(Refused("success.mean >= 0.9"), HasSubstr("found '.mean'"));
  EXPECT_THAT(Refused("depth_m >= 0.9"), HasSubstr(".p90 or another per cent, found ''"));
  EXPECT_THAT(Refused("depth_m.p101 >= 0.9"), HasSubstr("found '.p101'"));
  EXPECT_THAT(Refused("success >= 90"), HasSubstr("a share from 0 to 1, found '90'"));
  EXPECT_THAT(Refused("success == 0.9"), HasSubstr(">=, >, <= or <, found '=='"));
  EXPECT_THAT(Refused("depth_m.mean <= nan"), HasSubstr("expected a number, found 'nan'"));
  EXPECT_THAT(Refused("success[arm] >= 0.9"), HasSubstr("LABEL=TEXT in the brackets, found 'arm'"));
}

TEST(Requirement, RefusesWhatIsNoneAtAll) {
  for (const char* text : {"", " ", "success", ">=", "success >=", "success[arm=ours >= 0.9",
                           "success]arm=ours[ >= 0.9", "[] >= 0", "success[] >= 0.9",
                           "success[arm=ours]] >= 0.9", "success >= 0.9 0.9", "success >= 0.9]"}) {
    EXPECT_NE(Refused(text), "taken") << text;
  }
}

}  // namespace
}  // namespace dockyard
