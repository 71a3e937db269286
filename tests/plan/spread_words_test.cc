// The words `assumed` and `tolerance` stand for what the model files say.
#include <gmock/gmock.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "plan/toy_campaign.h"
#include "sim/base/text.h"
#include "sim/plan/file_keys.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kPoint = R"(name: point
wheel: {radius_m: 0.3, spokes: 6}
arm_m: 1
offset_m: 0
spreads:
  wheel.radius_m: {assumed: [0.2, 0.4], tolerance: {percent: 2}}
  wheel.spokes: {assumed: {one_of: [5, 6, 8]}}
  arm_m: {assumed: {log: [0.5, 2]}, tolerance: {within: 0.005}}
  offset_m: {tolerance: {plus: [0, 0.01]}}
)";
constexpr const char* kSoil =
    "name: soil\nk: 4\nspreads: {k: {assumed: [1, 9], tolerance: {percent: 30}}}\n";

class SpreadWords : public testing::Test {
 protected:
  SpreadWords() {
    folder_.Write("models/point.yaml", kPoint);
    folder_.Write("models/sand.yaml", kSoil);
    folder_.Write("models/gravel.yaml", kSoil);
  }
  Campaign Load(const std::string& keys) const {
    return LoadAndCheck(folder_.Write("scenarios/d.yaml", "campaign: d\nbase: toy.yaml\n" + keys));
  }
  std::string Message(const std::string& keys) const {
    return MessageOf([&] { Load(keys); }, folder_);
  }
  /// All drawn values of a label.
  static std::vector<double> Values(const Campaign& campaign, const std::string& label) {
    std::vector<double> values;
    for (const CampaignRun& run : AllRuns(campaign)) {
      for (std::size_t i = 0; i < campaign.labels.size(); ++i) {
        if (campaign.labels[i] == label) values.push_back(NumberFromText(run.labels[i]).value());
      }
    }
    return values;
  }
  static std::vector<std::string> Keys(const Campaign& campaign) {
    std::vector<std::string> keys;
    for (const Dispersion& each : campaign.dispersions) keys.push_back(each.key.name);
    return keys;
  }
  ToyFolder folder_;
};

void ExpectUniform(const Dispersion& dispersion, double min, double max) {
  const auto* uniform = std::get_if<Uniform>(&dispersion.distribution);
  ASSERT_NE(uniform, nullptr) << dispersion.key.name;
  EXPECT_DOUBLE_EQ(uniform->min, min) << dispersion.key.name;
  EXPECT_DOUBLE_EQ(uniform->max, max) << dispersion.key.name;
}

TEST_F(SpreadWords, AssumedIsDrawnAsTheModelSays) {
  const Campaign campaign = Load(
      "draw: {changes.robot.wheel.radius_m: assumed, changes.robot.arm_m: assumed,\n"
      "  changes.robot.wheel.spokes: assumed}\ndesign: {runs: 40}\n");
  ExpectUniform(campaign.dispersions[0], 0.2, 0.4);
  const auto& log = std::get<LogUniform>(campaign.dispersions[1].distribution);
  EXPECT_EQ(log.min, 0.5);
  EXPECT_EQ(log.max, 2.0);
  EXPECT_THAT(campaign.dispersions[2].values.labels, ElementsAre("5", "6", "8"));
  EXPECT_THAT(Values(campaign, "changes.robot.wheel.radius_m"),
              Each(::testing::AllOf(::testing::Ge(0.2), ::testing::Le(0.4))));
}

TEST_F(SpreadWords, ToleranceIsDrawnAgainstWhatIsTold) {
  const Campaign campaign = Load(
      "draw: {as_built.robot.wheel.radius_m: tolerance, as_built.robot.arm_m: tolerance,\n"
      "  as_built.robot.offset_m: tolerance}\ndesign: {runs: 3}\n");
  EXPECT_THAT(Keys(campaign),
              ElementsAre("as_built.robot.wheel.radius_m.times", "as_built.robot.arm_m.plus",
                          "as_built.robot.offset_m.plus"));
  ExpectUniform(campaign.dispersions[0], 0.98, 1.02);
  ExpectUniform(campaign.dispersions[1], -0.005, 0.005);
  ExpectUniform(campaign.dispersions[2], 0.0, 0.01);
  for (const CampaignRun& run : AllRuns(campaign)) {
    EXPECT_EQ(FindPath(run.scenario.as_built, "robot.wheel.radius_m.times")->scalar, run.labels[1]);
  }
}

TEST_F(SpreadWords, HeadTakesAllBelowItThatNothingElseSets) {
  EXPECT_THAT(Keys(Load("draw: {as_built: tolerance}\n")),
              ElementsAre("as_built.robot.wheel.radius_m.times", "as_built.robot.arm_m.plus",
                          "as_built.robot.offset_m.plus", "as_built.soil.k.times"));
  EXPECT_THAT(Keys(Load("draw: {changes.robot.wheel: assumed}\n")),
              ElementsAre("changes.robot.wheel.radius_m", "changes.robot.wheel.spokes"));
  EXPECT_THAT(Keys(Load("draw:\n  as_built: tolerance\n"
                        "  as_built.robot.arm_m: {uniform: {min: 0.9, max: 1.1}}\n"
                        "vary: {as_built.soil.k: [3, 4]}\n"
                        "scenario: {as_built: {robot: {offset_m: 0.002}}}\n")),
              ElementsAre("as_built.robot.wheel.radius_m.times", "as_built.robot.arm_m"));
}

TEST_F(SpreadWords, KeptCampaignNeedsNeitherWordNorModel) {
  const Campaign campaign =
      Load("draw: {as_built: tolerance, changes.soil.k: assumed}\ndesign: {runs: 4}\n");
  const std::string kept = CampaignYaml(WithAbsolutePaths(campaign, ToySystems()));
  folder_.Write("models/point.yaml", "name: point\n");
  const Campaign again = LoadAndCheck(folder_.Write("kept.yaml", kept));
  EXPECT_EQ(CampaignYaml(WithAbsolutePaths(again, ToySystems())), kept);
  EXPECT_EQ(again.labels, campaign.labels);
  EXPECT_EQ(Values(again, "as_built.soil.k.times"), Values(campaign, "as_built.soil.k.times"));
}

TEST_F(SpreadWords, PlanIsATableThatDrawsNothingAgain) {
  const std::string keys =
      "draw: {as_built: tolerance, changes.soil.k: assumed}\ndesign: {runs: 4}\n";
  const Campaign campaign = Load(keys);
  folder_.Write("scenarios/plan.csv", PlanCsv(campaign, ToySystems()));
  const Campaign again = Load(keys + "table: plan.csv\n");
  EXPECT_TRUE(again.dispersions.empty());
  for (const Dispersion& each : campaign.dispersions) {
    EXPECT_EQ(Values(again, each.key.name), Values(campaign, each.key.name)) << each.key.name;
  }
}

// The plan has the name that a run drew, and lies in another folder than the campaign.
TEST_F(SpreadWords, PlanOfDrawnFilesIsATableOfTheSameRuns) {
  for (const char* soils : {"{wet: ../models/sand.yaml, hard: ../models/gravel.yaml}",
                            "[../models/sand.yaml, ../models/gravel.yaml]"}) {
    const std::string keys = std::string("draw:\n  soil: {discrete: {values: ") + soils +
                             "}}\n  as_built: tolerance\ndesign: {runs: 8}\n";
    const Campaign campaign = Load(keys);
    const std::string plan = folder_.Write("out/plans/plan.csv", PlanCsv(campaign, ToySystems()));
    const Campaign again = Load(keys + "table: " + plan + "\n");
    const std::string kept = CampaignYaml(WithAbsolutePaths(again, ToySystems()));
    const std::vector<CampaignRun> runs = AllRuns(campaign), same = AllRuns(again),
                                   third = AllRuns(LoadAndCheck(folder_.Write("kept.yaml", kept)));
    ASSERT_EQ(same.size(), 8u);
    ASSERT_EQ(third.size(), 8u);
    std::set<std::string> files;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      EXPECT_EQ(same[i].scenario.seed, runs[i].scenario.seed);
      EXPECT_EQ(same[i].labels, runs[i].labels);
      EXPECT_THAT(DifferingKeys(same[i].scenario, runs[i].scenario), ElementsAre());
      EXPECT_EQ(third[i].scenario.seed, runs[i].scenario.seed);
      EXPECT_TRUE(
          std::filesystem::equivalent(third[i].scenario.soil_file, runs[i].scenario.soil_file));
      files.insert(runs[i].scenario.soil_file);
    }
    EXPECT_EQ(files.size(), 2u);
  }
}

TEST_F(SpreadWords, CellThatIsNoNameOfTheDrawIsAValue) {
  const std::string keys = "draw: {soil: {discrete: {values: {wet: ../models/sand.yaml}}}}\n";
  folder_.Write("out/t.csv", "run,soil\n1,wet\n2,../models/gravel.yaml\n");
  const std::vector<CampaignRun> runs = AllRuns(Load(keys + "table: ../out/t.csv\n"));
  EXPECT_THAT(runs.at(0).scenario.soil_file, HasSubstr("sand.yaml"));
  EXPECT_THAT(runs.at(1).scenario.soil_file, HasSubstr("gravel.yaml"));
  folder_.Write("out/t.csv", "run,soil\n1,wet\n2,wett\n");
  EXPECT_THAT(Message(keys + "table: ../out/t.csv\n"), HasSubstr("wett"));
}

TEST_F(SpreadWords, AllFilesOfACampaignMustAgree) {
  const std::string soils =
      "vary: {soil: {a: ../models/sand.yaml, b: ../models/gravel.yaml}}\n"
      "draw: {as_built.soil.k: tolerance}\n";
  EXPECT_THAT(Keys(Load(soils)), ElementsAre("as_built.soil.k.times"));
  folder_.Write("models/gravel.yaml", Replaced(kSoil, "percent: 30", "percent: 20"));
  EXPECT_EQ(Message(soils),
            "scenarios/d.yaml:4:25: draw.as_built.soil.k: expected a distribution, as the files "
            "differ in soil.k: [0.7, 1.3] in models/sand.yaml, [0.8, 1.2] in models/gravel.yaml, "
            "found 'tolerance'");
  EXPECT_THAT(
      Message("draw:\n  as_built.soil.k: tolerance\n"
              "  soil: {discrete: {values: [../models/sand.yaml, ../models/gravel.yaml]}}\n"),
      HasSubstr("the files differ in soil.k"));
  folder_.Write("models/gravel.yaml", "name: gravel\nk: 4\n");
  EXPECT_THAT(Message(soils), HasSubstr("not all of the files have this spread of soil.k"));
}

// As the plan of a campaign whose draws are all words.
TEST_F(SpreadWords, LeaveEverythingToATableOfAllDraws) {
  const Campaign campaign = Load(
      "draw: {as_built.soil: tolerance}\n"
      "runs: [{run: 1, as_built.soil.k.times: 1.1}, {run: 2, as_built.soil.k.times: 0.8}]\n");
  EXPECT_TRUE(campaign.dispersions.empty());
  EXPECT_THAT(Values(campaign, "as_built.soil.k.times"), ElementsAre(1.1, 0.8));
}

TEST_F(SpreadWords, FaultsAreToldByPlaceAndPath) {
  EXPECT_EQ(Message("draw: {as_built.robot.arm_m: assumed}\n"),
            "scenarios/d.yaml:3:30: draw.as_built.robot.arm_m: expected tolerance; what the robot "
            "may be belongs under changes, found 'assumed'");
  EXPECT_THAT(Message("draw: {changes.robot.arm_m: tolerance}\n"),
              HasSubstr("expected assumed; under changes the controller would be told"));
  EXPECT_THAT(Message("draw: {start.r_m: tolerance}\n"),
              HasSubstr("only keys under changes and as_built have spreads"));
  EXPECT_THAT(Message("draw: {as_built.robot.arm_m: tolerances}\n"),
              HasSubstr("or one of the words assumed and tolerance, found 'tolerances'"));
  EXPECT_THAT(Message("draw: {as_built.robot.arm: tolerance}\n"),
              HasSubstr("such as 'as_built.robot.arm_m'"));
  EXPECT_THAT(Message("draw: {as_built.robot.wheel.spokes: tolerance}\n"),
              HasSubstr("expected a key with this spread in its model's file"));
  EXPECT_THAT(
      Message("draw: {as_built.robot.arm_m: tolerance}\nvary: {as_built.robot.arm_m: [1]}\n"),
      HasSubstr("is not set by"));
}

TEST_F(SpreadWords, FaultsOfASpreadAreToldByPlaceAndPath) {
  const auto message = [&](const std::string& spread) {
    folder_.Write("models/sand.yaml", "name: sand\nk: 4\nspreads: {k: " + spread + "}\n");
    return Message("draw: {as_built: tolerance}\n");
  };
  EXPECT_EQ(message("{assumed: [2, 1]}"),
            "models/sand.yaml:3:24: spreads.k.assumed: expected two numbers in ascending order, "
            "found a list");
  EXPECT_THAT(message("{assumed: {log: [0, 1]}}"), HasSubstr("in ascending order above 0"));
  EXPECT_THAT(message("{assumed: {one_of: [1, x]}}"), HasSubstr("expected a list of numbers"));
  EXPECT_THAT(message("{tolerance: {percent: 0}}"), HasSubstr("spreads.k.tolerance.percent"));
  EXPECT_THAT(message("{tolerance: {percent: 1, within: 2}}"),
              HasSubstr("expected one of percent"));
  EXPECT_THAT(message("{tolerance: 2}"), HasSubstr("spreads.k.tolerance: expected a mapping"));
  EXPECT_THAT(message("{}"), HasSubstr("expected assumed, tolerance or both"));
  EXPECT_THAT(message("{range: [1, 2]}"), HasSubstr("unknown key"));
}

// A draw beyond the range of a model's key must be found before the first run.
TEST_F(SpreadWords, SystemChecksTheEndsOfWhatItsModelsHave) {
  const Campaign campaign = LoadCampaign(
      folder_.Write("scenarios/d.yaml",
                    "campaign: d\nbase: toy.yaml\ndraw: {as_built.soil.k: tolerance}\n"),
      {}, ToyCampaigns());
  std::vector<std::string> seen;
  CheckRuns(campaign, ToySystems(), [&](const Scenario& scenario) {
    seen.push_back(FindPath(scenario.as_built, "soil.k.times")->scalar);
  });
  ASSERT_EQ(seen.size(), 3u);  // both ends, and the first run's own
  EXPECT_NEAR(NumberFromText(seen[0]).value(), 0.7, 1e-9);
  EXPECT_NEAR(NumberFromText(seen[1]).value(), 1.3, 1e-9);
}

}  // namespace
}  // namespace dockyard
