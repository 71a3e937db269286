#include "sim/report/reproduction.h"

#include <gmock/gmock.h>

#include "sim/log/result_row.h"
#include "sim/log/results.h"
#include "sim/report/reproduction_text.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const char* const kPublished = R"(reproduction: yard
source: A paper
campaigns:
  - {name: grid, file: grid.yaml}
  - {name: reeling, file: reeling.yaml}
counted: [docked, partly]
rows:
  - {name: all, paper: [29, 40]}
  - {name: inside, paper: [20, 24], where: {region: interior}}
  - {name: boundary, paper: [9, 16], where: {region: boundary}}
  - {name: sand, where: {soil: [fine, coarse]}}
total: all
judged: [inside, boundary]
failures:
  - {name: one camera, says: no count, cases: [{sighting: wrong, methods: [left, right]}]}
  - {name: wrong point, paper: [5, 40], cases: [{outcomes: [misnamed]}, {sighting: wrong}]}
  - {name: blind, paper: [2, 24], where: {region: interior}, cases: [{outcomes: [unseen]}]}
others: 4 at most
sightings:
  wrong_place_m: 0.3
  wrong_heading_deg: 10
  methods: [stereo]
  within_m: 0.25
  errors: [{at_m: 1, r_m: 0.0256, heading_deg: 2.5}, {at_m: 5, r_m: 0.2}]
measures:
  - {name: current, campaign: grid, measure: current_a, low: 0.5, high: 1}
  - {name: pure reeling, campaign: reeling, measure: current_a, low: 1.5, high: 2}
  - {name: time, campaign: grid, measure: sim_time_s}
)";

RowColumns Columns() {
  RowColumns columns;
  columns.labels = {"region", "soil"};
  columns.measures = {{"current_a", "A", "of the spool"}};
  columns.outcomes = {{"docked", true, ""},  {"partly", false, ""}, {"misnamed", false, ""},
                      {"unseen", false, ""}, {"lost", false, ""},   {kCrashed, false, ""}};
  return columns;
}

class Reproduced : public testing::Test {
 protected:
  Reproduced() {
    for (const char* name : {"grid.yaml", "reeling.yaml"}) folder_.Write(name, "campaign: x\n");
    published_ = LoadPublished(folder_.Write("published.yaml", kPublished));
  }

  /// A line of results.csv.
  void Add(const std::string& region, const std::string& soil, const std::string& outcome) {
    ++run_;
    const std::string docked = outcome == "docked" ? "1" : "0";
    csv_ += std::to_string(run_) + ",7,axel,tsai," + region + "," + soil + "," + docked +
            ",docked," + docked + "," + outcome + ",99.5,12,0." + std::to_string(4 + run_ % 4) +
            ",00000000000000ff\n";
  }
  /// Successes first, every third of them partly; then failures.
  void AddRegion(const std::string& region, int successes, int runs, const char* failure) {
    for (int i = 0; i < runs; ++i) {
      const char* success = i % 3 == 0 ? "partly" : "docked";
      Add(region, i % 2 == 0 ? "fine" : "stone", i < successes ? success : failure);
    }
  }
  CampaignResults Results() const {
    return {RowsFromCsv(CsvHeader(Columns()) + "\n" + csv_, "results.csv", Columns()), Columns(), 2,
            sightings_};
  }
  ReproductionFinding Judge() const {
    return JudgeReproduction(published_, {Results(), CampaignResults{}});
  }
  /// The last sighting of a run.
  void Sight(int run, double place_error_m, double heading_error_rad, const char* method,
             double r_m = 3.0) {
    sightings_[run].push_back({r_m, -place_error_m, place_error_m, heading_error_rad, method});
  }

  ScratchFolder folder_;
  Published published_;
  std::string csv_;
  SightingErrors sightings_;
  int run_ = 0;
};

// Intervals and p by whole numbers (Python's fractions).
TEST_F(Reproduced, StandsBesideThePapersTable) {
  AddRegion("interior", 40, 48, "lost");
  AddRegion("boundary", 18, 32, "lost");
  const ReproductionFinding found = Judge();
  ASSERT_EQ(found.rows.size(), 4u);
  EXPECT_EQ(found.rows[0].successes, 58);
  EXPECT_EQ(found.rows[0].runs, 80);
  EXPECT_EQ(found.rows[0].at_95.low, 22);
  EXPECT_EQ(found.rows[0].at_95.high, 35);
  EXPECT_EQ(found.rows[1].confidence, 0.975);  // 1 - 0.05 / 2
  EXPECT_EQ(found.rows[1].judged_at.low, 14);
  EXPECT_EQ(found.rows[1].judged_at.high, 24);
  EXPECT_EQ(found.rows[1].at_95.low, 15);
  EXPECT_EQ(found.rows[2].judged_at.low, 3);
  EXPECT_EQ(found.rows[2].judged_at.high, 14);
  EXPECT_EQ(found.rows[3].runs, 40);  // fine, half of all
  EXPECT_FALSE(found.rows[3].counts);
  EXPECT_EQ(found.verdict, ReproductionVerdict::kInside);
  const std::string text = ReproductionText(found);
  EXPECT_THAT(text,
              ContainsRegex("all +29/40 \\(73 %, 56-85 %\\) +58/80 \\(73 %, 61-82 %\\) +22-35 "
                            "+inside at 95 %: 22-35, p = 1\n"));
  EXPECT_THAT(text, ContainsRegex("boundary .* 4-14 +inside at 97.5 %: 3-14, p = 1\n"));
  EXPECT_THAT(text, ContainsRegex("sand +not given +29/40"));
  EXPECT_THAT(text, HasSubstr("each of 2 rows at 1 - 0.05/2"));
  EXPECT_THAT(text,
              HasSubstr("\ninside: the paper's total, and each row and measure that counts\n"));
}

// A row of two is judged at 0.975: p = 0.0426 is inside, 0.0194 is not.
TEST_F(Reproduced, IsOutsideWhereOneRowIsAlone) {
  AddRegion("interior", 30, 48, "lost");
  AddRegion("boundary", 28, 32, "lost");
  EXPECT_EQ(Judge().verdict, ReproductionVerdict::kInside);
  csv_.clear();
  run_ = 0;
  AddRegion("interior", 29, 48, "lost");
  AddRegion("boundary", 29, 32, "lost");
  const ReproductionFinding found = Judge();
  EXPECT_NEAR(found.rows[2].p, 0.01941683724218435, 1e-12);
  EXPECT_TRUE(found.rows[0].inside());
  EXPECT_EQ(VerdictText(found), "outside: boundary");
  const Json json = ReproductionJson(found);
  EXPECT_EQ(json.at("verdict"), "outside");
  EXPECT_EQ(json.at("rows").at(2).at("inside"), false);
  EXPECT_EQ(json.at("rows").at(2).at("predicted"), Json::parse("[10, 16]"));
}

// The grid's current is 0.6 A in the mean.
TEST_F(Reproduced, IsOutsideByTheMeanOfAJudgedMeasure) {
  AddRegion("interior", 40, 48, "lost");
  AddRegion("boundary", 18, 32, "lost");
  published_.measures[0].judged = true;
  EXPECT_EQ(Judge().verdict, ReproductionVerdict::kInside);
  EXPECT_THAT(ReproductionText(Judge()), ContainsRegex("current .* 80 +inside\n"));
  published_.measures[0].low = 0.7;
  EXPECT_EQ(VerdictText(Judge()), "outside: current");
  EXPECT_EQ(ReproductionJson(Judge()).at("measures").at(0).at("inside"), false);
  // Its campaign was not run.
  published_.measures[1].judged = true;
  EXPECT_EQ(VerdictText(Judge()),
            "not judged: these runs are not those of the paper: pure reeling");
}

TEST_F(Reproduced, IsOutsideByItsTotal) {
  AddRegion("interior", 40, 48, "lost");
  AddRegion("boundary", 32, 32, "lost");
  const ReproductionFinding found = Judge();
  EXPECT_NEAR(found.rows[0].p, 0.03051170388976563, 1e-12);
  EXPECT_EQ(VerdictText(found), "outside: all, boundary");
}

TEST_F(Reproduced, IsNotJudgedWhereRunsAreMissing) {
  AddRegion("interior", 40, 48, "lost");
  AddRegion("boundary", 18, 31, "lost");
  const ReproductionFinding found = Judge();
  EXPECT_EQ(VerdictText(found), "not judged: these runs are not those of the paper: all, boundary");
  EXPECT_THAT(ReproductionText(found), ContainsRegex("boundary .*31 of 32 runs: not judged\n"));
  EXPECT_FALSE(ReproductionJson(found).at("rows").at(0).contains("predicted"));
  EXPECT_TRUE(found.rows[1].comparable());
}

TEST_F(Reproduced, PutsEachFailureIntoTheFirstClassThatHolds) {
  for (int i = 0; i < 40; ++i) Add("interior", "fine", "docked");
  for (const char* outcome : {"unseen", "unseen", "misnamed", "lost", "lost", "lost", "lost"}) {
    Add("interior", "fine", outcome);
  }
  Add("interior", "fine", kCrashed);
  for (int i = 0; i < 31; ++i) Add("boundary", "fine", "partly");
  Add("boundary", "fine", "unseen");  // that class is of the interior alone
  Sight(44, 0.1, 0.0, "stereo");      // right
  Sight(45, 0.31, 0.0, "stereo");     // too far off
  Sight(46, 0.0, -0.18, "left");      // 10.3 deg
  Sight(47, 0.5, 0.0, "stereo");      // of an earlier sighting, the last one is right
  Sight(47, 0.0, 0.0, "stereo");
  Sight(1, 5.0, 0.0, "left");  // it docked all the same
  const ReproductionFinding found = Judge();
  ASSERT_EQ(found.failures.size(), 4u);
  EXPECT_EQ(found.failures[0].count, 1);
  EXPECT_EQ(found.failures[1].count, 2);
  EXPECT_EQ(found.failures[2].count, 2);
  EXPECT_EQ(found.failures[2].runs, 48);
  EXPECT_EQ(found.failures[3].count, 4);  // 44, 47, the crash, and the one of the boundary
  EXPECT_FALSE(found.failures[0].at_95);
  EXPECT_TRUE(found.failures[1].at_95);
  EXPECT_THAT(ReproductionText(found), ContainsRegex("others +4 of 80 +4 at most\n"));
}

// Runs have 0.4, 0.5, 0.6 and 0.7 A in turn, the first one 0.5.
TEST_F(Reproduced, PutsAFailureIntoAClassByAColumnOfItsResults) {
  for (int i = 0; i < 9; ++i) Add("interior", "fine", i < 3 ? "docked" : "lost");
  Add("interior", "fine", kCrashed);
  FailureClass& blind = published_.failures.at(2);
  blind.cases = {{.where = {{{"current_a", {}, ""}, {0.4, 0.7}}}}};
  EXPECT_EQ(Judge().failures.at(2).count, 3);  // runs 4, 7 and 8; not 3, which docked
  blind.cases = {{.outcomes = {{"lost", {}, ""}}, .where = {{{"sim_time_s", {}, ""}, {99.5}}}}};
  EXPECT_EQ(Judge().failures.at(2).count, 6);
  blind.cases = {{.outcomes = {{"misnamed", {}, ""}}, .where = {{{"sim_time_s", {}, ""}, {99.5}}}}};
  EXPECT_EQ(Judge().failures.at(2).count, 0);
}

// 4 of 80 against 5 of 40 have p = 0.272, 0 of 80 p = 0.0069 (whole numbers, Python).
TEST_F(Reproduced, IsOutsideByACauseThatCounts) {
  AddRegion("interior", 44, 48, "misnamed");
  AddRegion("boundary", 22, 32, "lost");
  published_.failures.at(1).judged = true;
  published_.failures.at(2).judged = true;
  const ReproductionFinding found = Judge();
  const FailureFinding& wrong = found.failures.at(1);
  EXPECT_EQ(wrong.confidence, 0.975);  // 1 - 0.05 / 2
  EXPECT_NEAR(wrong.p, 0.27186543486124926, 1e-12);
  EXPECT_TRUE(wrong.inside());
  EXPECT_FALSE(found.failures.at(0).counts);
  EXPECT_THAT(ReproductionText(found),
              ContainsRegex("wrong point +5 of 40 +4 of 80 +0-7 +inside at "
                            "97.5 %: 0-8, p = 0.27[0-9]*\n"));
  EXPECT_THAT(ReproductionText(found), HasSubstr(", each of 2 causes at 1 - 0.05/2\n"));
  EXPECT_THAT(ReproductionText(found), HasSubstr("each row, cause and measure that counts\n"));
  csv_.clear();
  run_ = 0;
  AddRegion("interior", 44, 48, "lost");
  AddRegion("boundary", 22, 32, "lost");
  EXPECT_NEAR(Judge().failures.at(1).p, 0.006905392197790864, 1e-12);
  EXPECT_EQ(VerdictText(Judge()), "outside: wrong point");
  const Json json = ReproductionJson(Judge());
  EXPECT_EQ(json.at("failures").at(1).at("inside"), false);
  EXPECT_EQ(json.at("failures").at(0).at("judged"), false);
}

TEST_F(Reproduced, JudgesNoCauseOfOtherRuns) {
  AddRegion("interior", 40, 48, "lost");
  AddRegion("boundary", 18, 32, "lost");
  published_.failures.at(2).judged = true;
  published_.failures.at(2).where.clear();  // 80 runs, of the paper's 2 x 24
  EXPECT_EQ(VerdictText(Judge()), "not judged: these runs are not those of the paper: blind");
}

// Every third success is a partly seated one, which the paper counts.
TEST_F(Reproduced, ShowsTheTrueSuccessesWithThoseOfThePaper) {
  AddRegion("interior", 39, 48, "lost");
  AddRegion("boundary", 18, 32, "lost");
  EXPECT_FALSE(Judge().rows[0].strict);
  EXPECT_THAT(ReproductionText(Judge()), Not(HasSubstr("strictly")));
  published_.strict = {{"docked", {}, ""}};
  const ReproductionFinding found = Judge();
  EXPECT_EQ(found.rows[0].successes, 57);
  ASSERT_TRUE(found.rows[0].strict);
  EXPECT_EQ(found.rows[0].strict->successes, 38);
  EXPECT_NEAR(found.rows[0].strict->p, 0.01507069229982165, 1e-12);
  EXPECT_EQ(found.verdict, ReproductionVerdict::kInside);  // it does not count
  EXPECT_THAT(ReproductionText(found),
              ContainsRegex("strictly: docked alone; it does not count\n"));
  EXPECT_THAT(ReproductionText(found),
              ContainsRegex("all +29/40 \\(73 %, 56-85 %\\) +38/80 .* outside, p = 0.01"));
  const Json row = ReproductionJson(found).at("rows").at(0);
  EXPECT_EQ(row.at("strict_count"), 38);
  EXPECT_TRUE(row.contains("strict_predicted95"));
}

TEST_F(Reproduced, ARowCountsTheOutcomesThatItNames) {
  AddRegion("interior", 36, 48, "misnamed");
  AddRegion("boundary", 18, 32, "lost");
  published_.rows.at(2) = {.name = "wrong point",
                           .paper = PublishedCount{6, 40},
                           .where = {},
                           .outcomes = {{"misnamed", {}, ""}}};
  const ReproductionFinding found = Judge();
  EXPECT_EQ(found.rows[0].successes, 54);
  EXPECT_EQ(found.rows[2].successes, 12);
  EXPECT_EQ(found.rows[2].runs, 80);
  EXPECT_TRUE(found.rows[2].counts);
  EXPECT_TRUE(found.rows[2].inside());
  published_.rows.at(2).paper = PublishedCount{30, 40};
  EXPECT_EQ(VerdictText(Judge()), "outside: wrong point");
}

TEST_F(Reproduced, AveragesErrorsAboutEachDistance) {
  AddRegion("interior", 2, 2, "lost");
  Sight(1, 0.01, 0.02, "stereo", 1.25);
  Sight(1, 0.03, -0.04, "stereo", 0.75);
  Sight(2, 0.05, 0.0, "stereo", 1.0);
  Sight(2, 0.9, 1.0, "stereo", 1.26);  // too far away
  Sight(2, 0.9, 1.0, "left", 1.0);     // by one camera
  Sight(2, 0.9, 0.0, "stereo", 1.0);   // wrong
  const ReproductionFinding found = Judge();
  EXPECT_EQ(found.errors[0].sightings, 4);
  EXPECT_EQ(found.errors[0].wrong, 1);
  EXPECT_EQ(found.errors[0].runs, 2);
  EXPECT_NEAR(found.errors[0].mean_r_m, 0.03, 1e-12);
  EXPECT_NEAR(found.errors[0].mean_heading_rad, 0.02, 1e-12);
  EXPECT_NEAR(found.errors[0].median_heading_rad, 0.02, 1e-12);
  EXPECT_EQ(found.errors[1].sightings, 0);
  const std::string text = ReproductionText(found);
  EXPECT_THAT(
      text,
      ContainsRegex("1 m +2.56 +3.0 \\(3.0\\) +3.0 \\(3.0\\) +2.50 +1.1 \\(1.1\\) +4 in 2 runs +1\n"
                    "5 m +20.00 +- +- +- +- +0 in 0 runs +0\n"));
}

TEST_F(Reproduced, TellsMeasuresAndWhichCampaignWasNotRun) {
  AddRegion("interior", 48, 48, "lost");  // 0.4, 0.5, 0.6, 0.7 in turn
  const ReproductionFinding found = Judge();
  EXPECT_EQ(found.measures[0].runs, 48);
  EXPECT_NEAR(found.measures[0].mean, 0.55, 1e-12);
  EXPECT_FALSE(found.measures[1].simulated);
  const std::string text = ReproductionText(found);
  EXPECT_THAT(text, ContainsRegex("current +0.5-1 A +0.55 A +0.55 +0.4-0.7 +48\n"));
  EXPECT_THAT(text, ContainsRegex("pure reeling +1.5-2 A +not run\n"));
  EXPECT_THAT(text, ContainsRegex("time +not given +99.5 s +99.5 +99.5-99.5 +48\n"));
  EXPECT_TRUE(ReproductionJson(found).at("measures").at(2).at("paper").is_null());
}

TEST_F(Reproduced, MeasuresTheCountedRunsAlone) {
  // 0.4, 0.5, 0.6, 0.7 in turn: the first 24 runs succeed.
  AddRegion("interior", 24, 48, "lost");
  EXPECT_EQ(Judge().measures[0].runs, 48);
  for (PublishedMeasure& measure : published_.measures) measure.counted = true;
  const ReproductionFinding counted = Judge();
  EXPECT_EQ(counted.measures[0].runs, 24);
}

TEST_F(Reproduced, ARowOfAFurtherCampaignHasItsOwnRuns) {
  published_.rows[3].campaign = PublishedName{"reeling", {}, ""};
  published_.rows[3].paper = PublishedCount{3, 4};
  published_.rows[3].where.clear();
  published_.rows[3].runs = 20;
  AddRegion("interior", 48, 48, "lost");
  EXPECT_EQ(Judge().rows[3].runs, 0);
  EXPECT_EQ(Judge().rows[3].lacking, 20);
  EXPECT_FALSE(Judge().rows[3].comparable());
}

}  // namespace
}  // namespace dockyard
