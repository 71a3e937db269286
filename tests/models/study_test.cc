#include "models/study.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "bad_files.h"
#include "models/load_scenario.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A study beside copies of the models and the typical scenario.
class StudyFile : public testing::Test {
 protected:
  StudyFile() {
    for (const char* model : {"axel", "station", "soils"}) folder_.CopyModel(model);
    folder_.Write("scenarios/t.yaml", Slurp(SourceFile("scenarios/axel_typical.yaml")));
  }
  Study Load(const std::string& keys) const {
    return LoadStudy(folder_.Write("scenarios/s.yaml", kHead + keys));
  }
  std::string Message(const std::string& keys) const {
    return MessageOf([&] { Load(keys); }, folder_);
  }

  const std::string kHead = "study: s\nbase: t.yaml\nrepeats: 2\n";
  ScratchFolder folder_;
};

TEST_F(StudyFile, GridHasEveryCombinationFirstFactorFastest) {
  const Study study = Load("vary:\n  start.r_m: [2, 3]\n  start.alpha_deg: [-5, 0, 5]\n");
  ASSERT_EQ(study.points.size(), 6u);
  EXPECT_EQ(study.grid_size(), 6);
  EXPECT_EQ(study.points[1].scenario.start.r_m, 3.0);
  EXPECT_EQ(study.points[1].scenario.start.alpha_rad, Radians(-5.0));
  EXPECT_EQ(study.points[2].scenario.start.r_m, 2.0);
  EXPECT_EQ(study.points[5].scenario.start.alpha_rad, Radians(5.0));
}

TEST_F(StudyFile, RangeTakesInBothEndsAndReadsRound) {
  const Study study = Load("vary:\n  start.alpha_deg: {from: -0.3, to: 0.3, step: 0.1}\n");
  EXPECT_THAT(study.factors[0].labels,
              ElementsAre("-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"));
  EXPECT_TRUE(study.factors[0].numeric());
}

TEST_F(StudyFile, LabelsNameValuesAndFilesAreRelativeToTheStudy) {
  const Study study = Load(
      "vary:\n  soil: {hard: ../models/soils/compact_gravel.yaml,"
      " soft: ../models/soils/loose_sand.yaml}\n");
  EXPECT_THAT(study.factors[0].labels, ElementsAre("hard", "soft"));
  EXPECT_FALSE(study.factors[0].numeric());
  EXPECT_THAT(study.points[1].scenario.soil_file, HasSubstr("loose_sand.yaml"));
}

TEST_F(StudyFile, OneAtATimeKeepsTheGridAndAddsItChanged) {
  const Study study = Load(
      "vary:\n  start.r_m: [2, 3]\n"
      "one_at_a_time:\n  changes.station.cone.funnel_friction: [0.1, 0.5]\n");
  ASSERT_EQ(study.points.size(), 6u);  // 2 unchanged, 2 x 2 changed
  EXPECT_EQ(study.points[0].changed, -1);
  EXPECT_EQ(LoadModels(study.points[1].scenario).station.cone.funnel_friction, 0.15);
  EXPECT_EQ(study.points[2].changed_level, 0);
  EXPECT_EQ(LoadModels(study.points[2].scenario).station.cone.funnel_friction, 0.1);
  EXPECT_EQ(LoadModels(study.points[5].scenario).station.cone.funnel_friction, 0.5);
  EXPECT_EQ(study.points[5].scenario.start.r_m, 3.0);
}

TEST_F(StudyFile, ScriptIsInSIUnits) {
  const Study study = Load(
      "script:\n  - {for_s: 3, speed_m_s: 0.05, turn_deg_s: 90, tension_n: 40}\n"
      "  - {for_s: 1, free_wheels: true}\n");
  const std::vector<ScriptStep>& script = study.points.at(0).script;
  ASSERT_EQ(script.size(), 2u);
  EXPECT_EQ(script[0].turn_rad_s, 0.5 * kPi);
  EXPECT_EQ(script[0].tension_n, 40.0);
  EXPECT_TRUE(script[1].free_wheels);
  EXPECT_FALSE(script[1].tension_n.has_value());
}

TEST_F(StudyFile, ScriptCanBeVariedLikeAKey) {
  const Study study =
      Load("vary:\n  script:\n    short: [{for_s: 1}]\n    long: [{for_s: 9}, {for_s: 1}]\n");
  ASSERT_EQ(study.points.size(), 2u);
  EXPECT_EQ(study.points[0].script.size(), 1u);
  EXPECT_EQ(study.points[1].script.at(0).for_s, 9.0);
}

TEST_F(StudyFile, FaultsAreToldByPlaceAndPath) {
  EXPECT_EQ(Message("vary:\n  start.r_m: [2, ten]\n"),
            "scenarios/s.yaml:5:18: start.r_m: expected a number from 0.5 to 100, found 'ten'");
  EXPECT_EQ(Message("vary:\n  start.r_m: 3\n"),
            "scenarios/s.yaml:5:14: vary.start.r_m: expected a list of values, {from, to, step}, "
            "or labels with values");
  EXPECT_THAT(Message("vary:\n  start.rm: [2]\n"), HasSubstr("scenarios/s.yaml:5:"));
  EXPECT_THAT(Message("one_at_a_time:\n  changes.station.cone.frction: [2]\n"),
              HasSubstr("scenarios/s.yaml:5:"));
  EXPECT_THAT(Message("plot: {measures: [dcked]}\n"), HasSubstr("nearest is 'docked'"));
  EXPECT_THAT(Message("plot: {x: start.r_m}\n"), HasSubstr("scenarios/s.yaml:4:"));
  EXPECT_THAT(Message("repeats2: 3\n"), HasSubstr("repeats"));
  EXPECT_EQ(
      Message("vary:\n  seed: [1, 2]\n"),
      "scenarios/s.yaml:5:3: vary.seed: expected none; seeds follow from the study's seed and "
      "repeats");
}

// The products of the numbers of values in each file, counted by hand; with one_at_a_time the grid
// times one more than all its values.
TEST(Studies, OfTheTreeHaveAllTheirPoints) {
  const std::map<std::string, std::size_t> expected{{"assisted", 2 * 2 * 10},
                                                    {"cone_height", 2 * 2 * 11},
                                                    {"reel_alpha", 2 * 3 * 15},
                                                    {"reel_heading", 2 * 2 * 9},
                                                    {"sensitivity", 2 * 4 * (1 + 24 * 2)},
                                                    {"sensitivity_compact", 4 * (1 + 2 + 9 * 2)},
                                                    {"sensitivity_loose", 4 * (1 + 2 + 9 * 2)},
                                                    {"slack_arc", 6 * 3 * 2},
                                                    {"tether_arc", 4 * 2}};
  std::map<std::string, std::size_t> found;
  for (const auto& entry : std::filesystem::directory_iterator(SourceFile("scenarios/studies"))) {
    const Study study = LoadStudy(entry.path().string());
    EXPECT_EQ(study.name, entry.path().stem()) << entry.path();
    std::set<std::tuple<std::vector<int>, int, int>> places;
    for (const StudyPoint& point : study.points) {
      places.insert({point.level, point.changed, point.changed_level});
    }
    EXPECT_EQ(places.size(), study.points.size()) << entry.path();
    found[study.name] = study.points.size();
  }
  EXPECT_EQ(found, expected);
}

TEST(Changes, ReachTheModelsOfAScenario) {
  const ScenarioModels models = LoadModels(
      LoadScenario(SourceFile("scenarios/axel_typical.yaml"),
                   {"changes.station.feet.friction=0.3", "changes.station.mass_kg=70",
                    "changes.station.mouth_height_m=0.4", "changes.rover.mass_scale=1.5",
                    "changes.rover.body_com_x_m=-0.02", "changes.soil.cohesion_pa=123"}));
  EXPECT_EQ(models.station.foot_friction, 0.3);
  EXPECT_EQ(models.station.module.mass_kg, 70.0);
  EXPECT_NEAR(models.station.module.I_LCom_L(1, 1), 2.0 * 3.23203125, 1e-9);
  EXPECT_EQ(models.station.mouth_height_m, 0.4);
  EXPECT_NEAR(models.rover.mass_kg(), 60.0, 1e-9);
  EXPECT_EQ(models.rover.body.p_LoCom_L.x(), -0.02);
  EXPECT_EQ(models.soil.cohesion_pa, 123.0);
}

TEST(Changes, AreWrittenOutAndReadBack) {
  const std::vector<std::string> sets{"changes.station.feet.friction=0.3",
                                      "changes.rover.name='a \"b\" \\ c'",
                                      "changes.soil.rgb=[0.1, 0.2, 0.3]"};
  const Scenario s = LoadScenario(SourceFile("scenarios/axel_typical.yaml"), sets);
  const ScratchFolder folder;
  const Scenario back = LoadScenario(folder.Write("r.yaml", ResolvedYaml(s)));
  EXPECT_EQ(FlowText(back.changes), FlowText(s.changes));
  EXPECT_EQ(LoadModels(back).rover.name, "a \"b\" \\ c");
  EXPECT_EQ(LoadModels(back).soil.rgb.y(), 0.2);
}

TEST(Changes, UnknownKeysAndValuesAreRefusedWithTheirPlace) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& set) {
    return MessageOf(
        [&] { LoadModels(LoadScenario(SourceFile("scenarios/axel_typical.yaml"), {set})); },
        folder);
  };
  EXPECT_THAT(message("changes.staton.mass_kg=3"), HasSubstr("station"));
  EXPECT_THAT(message("changes.station.feet.frction=3"), HasSubstr("--set"));
  EXPECT_EQ(message("changes.station.feet.friction=x"),
            "--set changes.station.feet.friction=x: feet.friction: expected a number >= 0, found "
            "'x'");
}

}  // namespace
}  // namespace dockyard
