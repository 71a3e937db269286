#include <gmock/gmock.h>

#include <set>

#include "plan/toy_campaign.h"
#include "sim/base/random.h"
#include "sim/base/text.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SweepFile : public testing::Test {
 protected:
  Campaign Load(const std::string& keys) const {
    return LoadAndCheck(folder_.Write("scenarios/s.yaml", kHead + keys));
  }
  std::string Message(const std::string& keys) const {
    return MessageOf([&] { Load(keys); }, folder_);
  }

  const std::string kHead = "campaign: s\nbase: toy.yaml\n";
  ToyFolder folder_;
};

TEST_F(SweepFile, GridHasEveryCombinationFirstFactorFastest) {
  const Campaign campaign = Load("vary:\n  start.r_m: [2, 3]\n  start.alpha_deg: [-5, 0, 5]\n");
  const std::vector<CampaignRun> runs = AllRuns(campaign);
  ASSERT_EQ(runs.size(), 6u);
  EXPECT_EQ(runs[1].scenario.start.on_plane().r, 3.0);
  EXPECT_EQ(runs[1].scenario.start.on_plane().alpha, Radians(-5.0));
  EXPECT_EQ(runs[2].scenario.start.on_plane().r, 2.0);
  EXPECT_EQ(runs[5].scenario.start.on_plane().alpha, Radians(5.0));
  EXPECT_THAT(campaign.labels, ElementsAre("point", "start.r_m", "start.alpha_deg"));
  EXPECT_THAT(runs[5].labels, ElementsAre("6", "3", "5"));
}

TEST_F(SweepFile, RangeTakesInBothEndsAndReadsRound) {
  EXPECT_THAT(Load("vary:\n  start.alpha_deg: {from: -0.3, to: 0.3, step: 0.1}\n").grid[0].labels,
              ElementsAre("-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"));
}

TEST_F(SweepFile, LabelsNameValuesAndFilesAreRelativeToTheFile) {
  const std::vector<CampaignRun> runs =
      AllRuns(Load("vary:\n  soil: {hard: ../models/gravel.yaml, soft: ../models/sand.yaml}\n"));
  EXPECT_THAT(runs[0].scenario.soil_file, HasSubstr("gravel.yaml"));
  EXPECT_THAT(runs[1].scenario.soil_file, HasSubstr("sand.yaml"));
  EXPECT_THAT(runs[1].labels, ElementsAre("2", "soft"));
}

TEST_F(SweepFile, OneAtATimeKeepsTheGridAndAddsItChanged) {
  const Campaign campaign = Load(
      "scenario: {changes: {flag: {height_m: 2}}}\nvary:\n  start.r_m: [2, 3]\n"
      "one_at_a_time:\n  changes.flag.height_m: [1, 5]\n");
  const std::vector<CampaignRun> runs = AllRuns(campaign);
  const auto height = [&](std::size_t run) {
    return FindPath(runs.at(run).scenario.changes, "flag.height_m")->scalar;
  };
  ASSERT_EQ(runs.size(), 6u);  // 2 unchanged, 2 x 2 changed
  EXPECT_THAT(campaign.labels, ElementsAre("point", "start.r_m", "changed", "changed_to"));
  EXPECT_EQ(height(1), "2");
  EXPECT_THAT(runs[1].labels, ElementsAre("2", "3", "", ""));
  EXPECT_EQ(height(2), "1");
  EXPECT_EQ(height(5), "5");
  EXPECT_THAT(runs[5].labels, ElementsAre("6", "3", "changes.flag.height_m", "5"));
}

TEST_F(SweepFile, SeedsFollowFromPlaceAndRepeatAndAreSharedByArmsAndChangedKeys) {
  const Campaign campaign = Load(
      "seed: 9\narms: {a: {controller: wave}, b: {controller: straight}}\n"
      "vary: {start.r_m: [2, 3]}\none_at_a_time: {light: [speckled]}\ndesign: {runs: 3}\n");
  EXPECT_EQ(campaign.run_count(), 2 * 2 * 3 * 2);
  std::set<std::uint64_t> seeds;
  for (const CampaignRun& run : AllRuns(campaign)) {
    const int point = std::stoi(run.labels[1]) - 1, repeat = std::stoi(run.labels[2]) - 1;
    EXPECT_EQ(run.scenario.seed, WorldSeed(9, static_cast<std::uint64_t>(point % 2),
                                           static_cast<std::uint64_t>(repeat)));
    EXPECT_EQ(run.scenario.controller, run.labels[0] == "a" ? "wave" : "straight");
    seeds.insert(run.scenario.seed.number);
  }
  EXPECT_EQ(seeds.size(), 6u);
}

TEST_F(SweepFile, ScriptIsAKeyOfTheScenario) {
  EXPECT_EQ(
      AllRuns(Load("script:\n  - {for_s: 3}\n  - {for_s: 1}\n")).at(0).scenario.script.items.size(),
      2u);
  const std::vector<CampaignRun> varied = AllRuns(
      Load("vary:\n  script:\n    short: [{for_s: 1}]\n    long: [{for_s: 9}, {for_s: 1}]\n"));
  ASSERT_EQ(varied.size(), 2u);
  EXPECT_EQ(varied[0].scenario.script.items.size(), 1u);
  EXPECT_EQ(FlowText(varied[1].scenario.script), R"([{"for_s": 9}, {"for_s": 1}])");
}

TEST_F(SweepFile, TableAndGridMultiply) {
  const Campaign campaign = Load(
      "vary: {light: [even, speckled]}\nruns: [{run: 7, start.r_m: 2}, {run: 4, start.r_m: 3}]\n"
      "design: {runs: 2}\n");
  const std::vector<CampaignRun> runs = AllRuns(campaign);
  ASSERT_EQ(runs.size(), 8u);
  EXPECT_THAT(campaign.labels, ElementsAre("point", "repeat", "start.r_m", "light"));
  EXPECT_THAT(runs[7].labels, ElementsAre("4", "2", "3", "speckled"));
  EXPECT_EQ(runs[7].run, 8);
  // The row's own number is its place, whatever rows are beside it.
  EXPECT_EQ(runs[4].scenario.seed, WorldSeed(1, 4, 0));
}

TEST_F(SweepFile, DryRunIsATableOfTheSameRuns) {
  const std::string keys =
      "arms: {a: {toy.colour: red}, b: {toy.colour: blue}}\n"
      "vary: {soil: {hard: ../models/gravel.yaml, 'soft, wet': ../models/sand.yaml}}\n"
      "one_at_a_time: {light: [speckled]}\ndesign: {runs: 2}\n"
      "draw: {start.r_m: {uniform: {min: 2, max: 7}}, changes.a.b: {discrete: {values: [1, 5]}}}\n";
  const Campaign campaign = Load(keys);
  folder_.Write("scenarios/t.csv", PlanCsv(campaign, ToySystems()));
  const Campaign again = Load(keys + "table: t.csv\n");
  EXPECT_EQ(again.labels.size(), campaign.labels.size());
  const std::vector<CampaignRun> runs = AllRuns(campaign), same = AllRuns(again);
  ASSERT_EQ(runs.size(), 16u);
  ASSERT_EQ(same.size(), 16u);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(same[i].run, runs[i].run);
    EXPECT_EQ(same[i].scenario.seed, runs[i].scenario.seed);
    EXPECT_THAT(DifferingKeys(same[i].scenario, runs[i].scenario), ElementsAre());
  }
  EXPECT_EQ(PlanCsv(again, ToySystems()).size(), PlanCsv(campaign, ToySystems()).size());
}

TEST_F(SweepFile, PlotsMeasuresOfItsSystem) {
  EXPECT_THAT(Load("figures: {measures: [distance_to_toy]}\n").figures.measures,
              ElementsAre("distance_to_toy"));
  EXPECT_THAT(Load("figures:\n").figures.measures, ElementsAre("success"));
  EXPECT_THAT(Message("figures: {measures: [distance_to_other]}\n"),
              HasSubstr("expected a column of results.csv, found 'distance_to_other'"));
  EXPECT_THAT(Message("figures: {measures: [sucess]}\n"), HasSubstr("nearest is 'success'"));
}

TEST_F(SweepFile, FaultsAreToldByPlaceAndPath) {
  EXPECT_EQ(Message("vary:\n  start.r_m: [2, ten]\n"),
            "scenarios/s.yaml:4:18: start.r_m: expected a number from 0.1 to 100, found 'ten'");
  EXPECT_EQ(Message("vary:\n  start.r_m: 3\n"),
            "scenarios/s.yaml:4:14: vary.start.r_m: expected a list of values, {from, to, step}, "
            "or labels with values");
  EXPECT_EQ(Message("vary:\n  start.rm: [2]\n"),
            "scenarios/s.yaml:4:3: start.rm: unknown key, did you mean 'r_m'?");
  EXPECT_EQ(Message("vary:\n  tip_angle_deg: [2]\n"),
            "scenarios/s.yaml:4:3: tip_angle_deg: expected it under the key of the system's own "
            "name");
  EXPECT_THAT(Message("figures: {x: start.r_m}\n"), HasSubstr("scenarios/s.yaml:3:"));
  EXPECT_THAT(Message("desing: {runs: 3}\n"), HasSubstr("did you mean 'design'"));
  EXPECT_THAT(Message("vary:\n  seed: [1, 2]\n"),
              HasSubstr("vary.seed: expected none; names and seeds follow"));
  EXPECT_THAT(Message("vary:\n  system: [toy, other]\n"), HasSubstr("runs are of one system"));
  EXPECT_THAT(Message("vary: {start.r_m: [2]}\narms: {a: {start: {r_m: 3}}}\n"),
              HasSubstr("arms.a.start: expected a key that is not set by 'start.r_m' as well"));
}

TEST_F(SweepFile, FormerStudiesSayWhatTheyAreNow) {
  EXPECT_THAT(Message("repeats: 3\n"), HasSubstr("repeats: expected design: {runs: N} instead"));
  EXPECT_THAT(Message("plot: {x: start.r_m}\n"), HasSubstr("plot: expected figures instead"));
}

}  // namespace
}  // namespace dockyard
