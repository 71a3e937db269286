#include "sim/scenario/study.h"

#include <gmock/gmock.h>

#include "scenario/toy_system.h"
#include "sim/scenario/key_path.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class StudyFile : public testing::Test {
 protected:
  Study Load(const std::string& keys) const {
    return LoadStudy(folder_.Write("scenarios/s.yaml", kHead + keys), {}, ToyStudies(&checked_));
  }
  std::string Message(const std::string& keys) const {
    return MessageOf([&] { Load(keys); }, folder_);
  }

  const std::string kHead = "study: s\nbase: toy.yaml\nrepeats: 2\n";
  ToyFolder folder_;
  mutable std::vector<std::string> checked_;
};

TEST_F(StudyFile, GridHasEveryCombinationFirstFactorFastest) {
  const Study study = Load("vary:\n  start.r_m: [2, 3]\n  start.alpha_deg: [-5, 0, 5]\n");
  ASSERT_EQ(study.points.size(), 6u);
  EXPECT_EQ(study.grid_size(), 6);
  EXPECT_EQ(study.points[1].scenario.start.r, 3.0);
  EXPECT_EQ(study.points[1].scenario.start.alpha, Radians(-5.0));
  EXPECT_EQ(study.points[2].scenario.start.r, 2.0);
  EXPECT_EQ(study.points[5].scenario.start.alpha, Radians(5.0));
}

TEST_F(StudyFile, RangeTakesInBothEndsAndReadsRound) {
  const Study study = Load("vary:\n  start.alpha_deg: {from: -0.3, to: 0.3, step: 0.1}\n");
  EXPECT_THAT(study.factors[0].labels,
              ElementsAre("-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"));
  EXPECT_TRUE(study.factors[0].numeric());
}

TEST_F(StudyFile, LabelsNameValuesAndFilesAreRelativeToTheStudy) {
  const Study study =
      Load("vary:\n  soil: {hard: ../models/gravel.yaml, soft: ../models/sand.yaml}\n");
  EXPECT_THAT(study.factors[0].labels, ElementsAre("hard", "soft"));
  EXPECT_FALSE(study.factors[0].numeric());
  EXPECT_THAT(study.points[0].scenario.soil_file, HasSubstr("gravel.yaml"));
  EXPECT_THAT(study.points[1].scenario.soil_file, HasSubstr("sand.yaml"));
}

TEST_F(StudyFile, OneAtATimeKeepsTheGridAndAddsItChanged) {
  const Study study = Load(
      "scenario: {changes: {flag: {height_m: 2}}}\nvary:\n  start.r_m: [2, 3]\n"
      "one_at_a_time:\n  changes.flag.height_m: [1, 5]\n");
  const auto height = [&](std::size_t point) {
    return FindPath(study.points.at(point).scenario.changes, "flag.height_m")->scalar;
  };
  ASSERT_EQ(study.points.size(), 6u);  // 2 unchanged, 2 x 2 changed
  EXPECT_EQ(study.points[0].changed, -1);
  EXPECT_EQ(height(1), "2");
  EXPECT_EQ(study.points[2].changed_level, 0);
  EXPECT_EQ(height(2), "1");
  EXPECT_EQ(height(5), "5");
  EXPECT_EQ(study.points[5].scenario.start.r, 3.0);
}

TEST_F(StudyFile, SystemChecksEverySetOfModelsOnce) {
  Load(
      "vary:\n  changes.flag.a: [1, 2]\n  start.r_m: [2, 3]\n"
      "one_at_a_time:\n  changes.flag.b: [3]\n");
  EXPECT_THAT(checked_,
              ElementsAre(R"({"flag": {"a": 1}})", R"({"flag": {"a": 2}})",
                          R"({"flag": {"a": 1, "b": 3}})", R"({"flag": {"a": 2, "b": 3}})"));
}

TEST_F(StudyFile, ScriptIsAKeyOfTheScenario) {
  const Study study = Load("script:\n  - {for_s: 3}\n  - {for_s: 1}\n");
  EXPECT_EQ(study.points.at(0).scenario.script.items.size(), 2u);
  const Study varied =
      Load("vary:\n  script:\n    short: [{for_s: 1}]\n    long: [{for_s: 9}, {for_s: 1}]\n");
  ASSERT_EQ(varied.points.size(), 2u);
  EXPECT_EQ(varied.points[0].scenario.script.items.size(), 1u);
  EXPECT_EQ(FlowText(varied.points[1].scenario.script), R"([{"for_s": 9}, {"for_s": 1}])");
}

TEST_F(StudyFile, PlotsMeasuresOfItsSystem) {
  EXPECT_THAT(Load("plot: {measures: [distance_to_toy]}\n").measures,
              ElementsAre("distance_to_toy"));
  EXPECT_THAT(Message("plot: {measures: [distance_to_other]}\n"),
              HasSubstr("expected a column of runs.csv, found 'distance_to_other'"));
  EXPECT_THAT(Message("plot: {measures: [dcked]}\n"), HasSubstr("nearest is 'docked'"));
}

TEST_F(StudyFile, FaultsAreToldByPlaceAndPath) {
  EXPECT_EQ(Message("vary:\n  start.r_m: [2, ten]\n"),
            "scenarios/s.yaml:5:18: start.r_m: expected a number from 0.5 to 100, found 'ten'");
  EXPECT_EQ(Message("vary:\n  start.r_m: 3\n"),
            "scenarios/s.yaml:5:14: vary.start.r_m: expected a list of values, {from, to, step}, "
            "or labels with values");
  EXPECT_EQ(Message("vary:\n  start.rm: [2]\n"),
            "scenarios/s.yaml:5:14: start.rm: unknown key, did you mean 'r_m'?");
  EXPECT_EQ(Message("vary:\n  tip_angle_deg: [2]\n"),
            "scenarios/s.yaml:5:19: tip_angle_deg: expected it under the key of the system's own "
            "name");
  EXPECT_THAT(Message("plot: {x: start.r_m}\n"), HasSubstr("scenarios/s.yaml:4:"));
  EXPECT_THAT(Message("repeats2: 3\n"), HasSubstr("repeats"));
  EXPECT_EQ(
      Message("vary:\n  seed: [1, 2]\n"),
      "scenarios/s.yaml:5:3: vary.seed: expected none; seeds follow from the study's seed and "
      "repeats");
  EXPECT_THAT(Message("vary:\n  system: [toy, other]\n"), HasSubstr("points are of one system"));
}

}  // namespace
}  // namespace dockyard
