#include <gmock/gmock.h>

#include "scenario/toy_system.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/load_scenario.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ScenarioFile : public testing::Test {
 protected:
  Scenario Load(const std::vector<std::string>& overrides) const {
    return LoadScenario(folder_.scenario, overrides, ToySystems());
  }
  std::string SetMessage(const std::string& assignment) const {
    return MessageOf([&] { Load({assignment}); }, folder_);
  }
  std::string Changed(const std::string& from, const std::string& to) const {
    return folder_.ScenarioMessage(folder_.With(from, to));
  }
  std::string Added(const std::string& lines) const {
    return folder_.ScenarioMessage(folder_.And(lines));
  }

  ToyFolder folder_;
};

TEST_F(ScenarioFile, IsReadWithItsDefaults) {
  const Scenario s = Load({});
  EXPECT_EQ(s.system, "toy");
  EXPECT_EQ(s.controller, "wave");
  EXPECT_EQ(s.start.on_plane().r, 4.0);
  EXPECT_EQ(s.start.on_plane().alpha, Radians(15.0));
  EXPECT_EQ(s.start.on_plane().h, 0.0);
  EXPECT_EQ(s.time_limit_s, 600.0);
  EXPECT_EQ(s.image_width, 0);
  EXPECT_EQ(s.changes.kind, YamlNode::Kind::kNull);
}

TEST_F(ScenarioFile, ControllerIsTheSystemsFirstUnlessTheFileSays) {
  EXPECT_EQ(LoadScenario(folder_.With("controller: wave\n", ""), {}, ToySystems()).controller,
            "straight");
}

TEST_F(ScenarioFile, ControllerMayBeAProgram) {
  const Scenario s = Load({"controller={command: [python3, my_controller.py]}"});
  EXPECT_EQ(s.controller, "command");
  EXPECT_THAT(s.command, ElementsAre("python3", "my_controller.py"));
  EXPECT_EQ(SetMessage("controller={command: []}"),
            "--set controller={command: []}: controller.command: expected a list of 1 to 64, found "
            "a list of 0");
  EXPECT_THAT(SetMessage("controller={program: x}"), HasSubstr("unknown key"));
}

TEST_F(ScenarioFile, FilesOfAProgramMustBeThere) {
  const std::string file =
      folder_.With("controller: wave\n", "controller: {command: [x], files: [no_such.py]}\n");
  try {
    LoadScenario(file, {}, ToySystems());
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr(": controller.files: expected a file, found none at '"));
    EXPECT_THAT(error.what(), HasSubstr("no_such.py"));
  }
}

TEST_F(ScenarioFile, AProgramRunsInTheFolderOfItsFileUnlessThatNamesAnother) {
  const std::string command = "controller: {command: [x]";
  const std::string file = folder_.With("controller: wave\n", command + "}\n");
  const std::filesystem::path own = std::filesystem::path(file).parent_path();
  const std::string by_default = LoadScenario(file, {}, ToySystems()).command_folder;
  EXPECT_TRUE(std::filesystem::equivalent(by_default, own)) << by_default;
  EXPECT_TRUE(std::filesystem::path(by_default).is_absolute());

  const std::string up = folder_.With("controller: wave\n", command + ", folder: ..}\n");
  const std::string named = LoadScenario(up, {}, ToySystems()).command_folder;
  EXPECT_TRUE(std::filesystem::equivalent(named, own.parent_path())) << named;
  EXPECT_THAT(SetMessage("controller={command: [x], folder: no_such}"),
              HasSubstr("controller.folder: expected a folder, found none at 'no_such'"));
}

TEST_F(ScenarioFile, KeepsTheSystemsMappingChangesAndScriptAsTheyAre) {
  const Scenario s = Load({"changes.robot.mass_kg=3", "script=[{for_s: 1}, {for_s: 2}]"});
  EXPECT_EQ(s.of_system.Find("colour")->scalar, "red");
  EXPECT_EQ(FindPath(s.changes, "robot.mass_kg")->scalar, "3");
  EXPECT_EQ(s.script.items.size(), 2u);
}

TEST_F(ScenarioFile, FilesOfTheSystemAndOfChangesBecomeAbsolute) {
  const Scenario s = LoadScenario(folder_.And("changes: {robot: {cameras: {file: "
                                              "../models/lens.yaml}}}"),
                                  {}, ToySystems());
  EXPECT_EQ(s.of_system.Find("flag")->scalar, (folder_.path() / "models/flag.yaml").string());
  EXPECT_EQ(FindPath(s.changes, "robot.cameras.file")->scalar,
            (folder_.path() / "models/lens.yaml").string());
  EXPECT_EQ(Changed("../models/flag.yaml", "../models/none.yaml"),
            "scenarios/s.yaml:9:13: toy.flag: expected a file, found none at 'models/none.yaml'");
}

TEST_F(ScenarioFile, BadValuesAreToldByPlaceAndPath) {
  EXPECT_EQ(Changed("r_m: 4,", "r_m: ten,"),
            "scenarios/s.yaml:6:14: start.r_m: expected a number from 0.1 to 100, found 'ten'");
  EXPECT_EQ(Changed("light: even", "light: dim"),
            "scenarios/s.yaml:7:8: light: expected one of even, speckled, hard_shadow, room, found "
            "'dim'");
  EXPECT_EQ(Changed("controller: wave", "controller: autopilot"),
            "scenarios/s.yaml:5:13: controller: expected one of straight, wave, found 'autopilot'");
  EXPECT_EQ(Changed("system: toy", "system: tow"),
            "scenarios/s.yaml:2:9: system: expected one of toy, other, found 'tow'; a robot of "
            "another kind needs a system of its own: docs/contributing.md tells how to add one, "
            "docs/reference/models.md what files can change");
  EXPECT_EQ(Changed("system: toy\n", ""), "scenarios/s.yaml:1:1: missing key 'system'");
  EXPECT_EQ(Changed("seed: 1", "seed: -1"),
            "scenarios/s.yaml:8:7: seed: expected a whole number from 0 to 18446744073709551615, "
            "found '-1'");
  EXPECT_EQ(Changed("start:", "strat:"),
            "scenarios/s.yaml:6:1: strat: unknown key, did you mean 'start'?");
  EXPECT_EQ(Added("script: {a: 1}"),
            "scenarios/s.yaml:10:9: script: expected a list, found a mapping");
  EXPECT_EQ(Added("changes: 3"),
            "scenarios/s.yaml:10:10: changes: expected a mapping (key: value), found '3'");
}

TEST_F(ScenarioFile, PhysicsStepAboveFiveMillisecondsIsRefused) {
  EXPECT_EQ(Load({"physics_step_s=5e-3"}).physics_step_s, 5e-3);
  EXPECT_THAT(SetMessage("physics_step_s=0.0051"), HasSubstr("from 1e-05 to 0.005"));
}

TEST_F(ScenarioFile, HalfAnImageSizeIsRefused) {
  EXPECT_EQ(Load({"camera={width_px: 640, height_px: 480}"}).image_height, 480);
  EXPECT_EQ(Added("camera: {width_px: 640}"),
            "scenarios/s.yaml:10:9: camera: expected both width_px and height_px, or neither, "
            "found a mapping");
}

TEST_F(ScenarioFile, FormerKeysSayWhereTheyAreNow) {
  EXPECT_EQ(Changed("robot:", "rover:"),
            "scenarios/s.yaml:3:1: rover: expected the key 'robot' instead");
  for (const std::string key : {"station", "vision", "tip_angle_deg", "board_dust"}) {
    EXPECT_EQ(Added(key + ": 3"), "scenarios/s.yaml:10:1: " + key +
                                      ": expected it under the key of the system's own name");
  }
}

TEST_F(ScenarioFile, KeysOfAnotherSystemAreRefused) {
  EXPECT_EQ(Added("other: {a: 1}"),
            "scenarios/s.yaml:10:1: other: expected no keys of another system than 'toy'");
}

TEST_F(ScenarioFile, WithoutTheSystemsMappingSaysWhereItWouldBe) {
  const std::string file = folder_.With("toy: {flag: ../models/flag.yaml, colour: red}\n", "");
  const Scenario s = LoadScenario(file, {}, ToySystems());
  EXPECT_EQ(s.of_system.kind, YamlNode::Kind::kNull);
  EXPECT_EQ(s.of_system.place.Text(), file + ":1:1");
}

TEST_F(ScenarioFile, FilesThatAreNotThereAreToldWithThePathThatWasTried) {
  EXPECT_EQ(Changed("sand.yaml", "mud.yaml"),
            "scenarios/s.yaml:4:7: soil: expected a file, found none at 'models/mud.yaml'");
}

TEST_F(ScenarioFile, StartMustLieInTheYard) {
  EXPECT_EQ(Changed("r_m: 4,", "r_m: 12,"),
            "scenarios/s.yaml:6:14: start.r_m: expected a start inside the yard (x up to 9.5 m, y "
            "up to +-5 m), found '12'");
}

TEST_F(ScenarioFile, YardOfTooManyCellsIsRefused) {
  EXPECT_THAT(SetMessage("yard={length_m: 200, width_m: 200, cell_m: 0.002}"),
              HasSubstr("yard: expected at most 4 million cells, found 10000.0 million"));
}

TEST_F(ScenarioFile, IsNoCampaign) {
  EXPECT_THAT(Changed("name: toy", "campaign: c"), HasSubstr("one scenario, found a campaign"));
}

TEST_F(ScenarioFile, SetChangesOneValueAndLeavesTheRest) {
  EXPECT_THAT(DifferingKeys(Load({}), Load({"start.r_m=5", "seed=7"})),
              ElementsAre("start.r_m", "seed"));
}

TEST_F(ScenarioFile, TheLaterSetHolds) { EXPECT_EQ(Load({"seed=7", "seed=8"}).seed, 8u); }

TEST_F(ScenarioFile, SetOfAnUnknownKeyNamesTheNearestInFull) {
  EXPECT_EQ(SetMessage("start.rm=5"),
            "--set start.rm=5: unknown key 'start.rm', did you mean 'start.r_m'?");
}

TEST_F(ScenarioFile, SetOfABadValueIsToldWithTheOption) {
  EXPECT_EQ(SetMessage("start.r_m=ten"),
            "--set start.r_m=ten: start.r_m: expected a number from 0.1 to 100, found 'ten'");
  EXPECT_EQ(SetMessage("start.r_m="),
            "--set start.r_m=: start.r_m: expected a number from 0.1 to 100, found nothing");
  EXPECT_EQ(SetMessage("start=5"),
            "--set start=5: start: expected a mapping (key: value), found '5'");
  EXPECT_EQ(SetMessage("start.r_m.x=5"),
            "--set start.r_m.x=5: start.r_m: expected a number from 0.1 to 100, found a mapping");
  EXPECT_THAT(SetMessage("start=[1, 2"), StartsWith("--set start=[1, 2:"));
}

TEST_F(ScenarioFile, SetWithoutKeyOrEqualsSignIsRefused) {
  for (const char* bad : {"", "=", "=5", "start.r_m", ".r_m=5", "start.=5", "a..b=1"}) {
    EXPECT_EQ(SetMessage(bad),
              std::string("--set ") + bad + ": expected key=value such as start.r_m=5");
  }
}

TEST_F(ScenarioFile, SetOfImpossibleDepthIsRefused) {
  std::string path = "a";
  for (int i = 0; i < 1000; ++i) path += ".a";
  EXPECT_THAT(SetMessage(path + "=1"), HasSubstr("nested too deep"));
}

}  // namespace
}  // namespace dockyard
