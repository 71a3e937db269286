#include <gmock/gmock.h>

#include "bad_files.h"
#include "models/load_scenario.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const char kTypical[] = "scenarios/axel_typical.yaml";

std::string SetMessage(const std::string& assignment) {
  const ScratchFolder folder;
  return MessageOf([&] { LoadScenario(SourceFile(kTypical), {assignment}); }, folder);
}

/// The typical scenario with one line changed, in a file of its own.
std::string MessageOfChanged(const std::string& from, const std::string& to) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  folder.CopyModel("station");
  folder.CopyModel("soils");
  const std::string file =
      folder.Write("scenarios/s.yaml", Replaced(Slurp(SourceFile(kTypical)), from, to));
  return MessageOf([&] { LoadScenario(file); }, folder);
}

TEST(TypicalScenario, IsTheOneOfFigure10) {
  const Scenario s = LoadScenario(SourceFile(kTypical));
  EXPECT_EQ(s.start.r_m, 4.0);
  EXPECT_EQ(s.start.alpha_rad, Radians(15.0));
  EXPECT_EQ(s.start.heading_rad, 0.0);
  EXPECT_EQ(s.controller, "axel");
  EXPECT_LT(s.tip_angle_rad, 0.0);
}

TEST(TypicalScenario, NamesModelsThatLoadAndFitEachOther) {
  const ScenarioModels models = LoadModels(LoadScenario(SourceFile(kTypical)));
  EXPECT_EQ(models.rover.name, "axel");
  EXPECT_EQ(models.station.tip_angle_rad, Radians(5.0));
  EXPECT_EQ(models.soil.name, "compact_gravel");
  EXPECT_EQ(models.rover.stereo.nominal.left.width, 1024);
}

TEST(Scenario, TipAngleAndImageSizeReachTheModels) {
  const ScenarioModels models = LoadModels(LoadScenario(
      SourceFile(kTypical), {"tip_angle_deg=0", "camera.width_px=640", "camera.height_px=480"}));
  EXPECT_EQ(models.station.tip_angle_rad, 0.0);
  EXPECT_EQ(models.rover.stereo.nominal.right.width, 640);
  EXPECT_NEAR(models.rover.stereo.nominal.right.focal_px().x(), 640 / (kPi / 2), 1e-9);
}

TEST(Scenario, BadValuesAreToldByPlaceAndPath) {
  EXPECT_EQ(MessageOfChanged("r_m: 4,", "r_m: ten,"),
            "scenarios/s.yaml:8:14: start.r_m: expected a number from 0.5 to 100, found 'ten'");
  EXPECT_EQ(
      MessageOfChanged("light: even", "light: dim"),
      "scenarios/s.yaml:9:8: light: expected one of even, speckled, hard_shadow, found 'dim'");
  EXPECT_EQ(
      MessageOfChanged("controller: axel", "controller: autopilot"),
      "scenarios/s.yaml:7:13: controller: expected one of axel, reel_only, found 'autopilot'");
  EXPECT_EQ(MessageOfChanged("seed: 1", "seed: -1"),
            "scenarios/s.yaml:10:7: seed: expected a whole number from 0 to 18446744073709551615, "
            "found '-1'");
  EXPECT_EQ(MessageOfChanged("start:", "strat:"),
            "scenarios/s.yaml:8:1: strat: unknown key, did you mean 'start'?");
}

TEST(Scenario, FilesThatAreNotThereAreToldWithThePathThatWasTried) {
  EXPECT_EQ(MessageOfChanged("soils/compact_gravel.yaml", "soils/mud.yaml"),
            "scenarios/s.yaml:6:7: soil: expected a file, found none at 'models/soils/mud.yaml'");
}

TEST(Scenario, StartMustLieInTheYard) {
  EXPECT_EQ(
      MessageOfChanged("r_m: 4,", "r_m: 12,"),
      "scenarios/s.yaml:8:14: start.r_m: expected a start inside the yard (x up to 9.5 m, y up "
      "to +-5 m), found '12'");
}

TEST(Scenario, YardOfTooManyCellsIsRefused) {
  EXPECT_THAT(SetMessage("yard={length_m: 200, width_m: 200, cell_m: 0.002}"),
              HasSubstr("yard: expected at most 4 million cells"));
}

TEST(Scenario, IsNotACampaign) {
  const ScratchFolder folder;
  EXPECT_THAT(MessageOf([] { LoadScenario(SourceFile("scenarios/mars_yard_40.yaml")); }, folder),
              HasSubstr("expected one scenario, found a campaign"));
}

TEST(SetOption, ChangesOneValueAndLeavesTheRest) {
  const Scenario s = LoadScenario(SourceFile(kTypical), {"start.r_m=5", "seed=7"});
  EXPECT_EQ(s.start.r_m, 5.0);
  EXPECT_EQ(s.start.alpha_rad, Radians(15.0));
  EXPECT_EQ(s.seed, 7u);
}

TEST(SetOption, TheLaterOneHolds) {
  EXPECT_EQ(LoadScenario(SourceFile(kTypical), {"seed=7", "seed=8"}).seed, 8u);
}

TEST(SetOption, UnknownKeyNamesTheNearestInFull) {
  EXPECT_EQ(SetMessage("start.rm=5"),
            "--set start.rm=5: unknown key 'start.rm', did you mean 'start.r_m'?");
}

TEST(SetOption, BadValueIsToldWithTheOption) {
  EXPECT_EQ(SetMessage("start.r_m=ten"),
            "--set start.r_m=ten: start.r_m: expected a number from 0.5 to 100, found 'ten'");
  EXPECT_EQ(SetMessage("start.r_m="),
            "--set start.r_m=: start.r_m: expected a number from 0.5 to 100, found nothing");
  EXPECT_EQ(SetMessage("start=5"),
            "--set start=5: start: expected a mapping (key: value), found '5'");
  EXPECT_EQ(SetMessage("start.r_m.x=5"),
            "--set start.r_m.x=5: start.r_m: expected a number from 0.5 to 100, found a mapping");
  EXPECT_THAT(SetMessage("start=[1, 2"), StartsWith("--set start=[1, 2:"));
}

TEST(SetOption, WithoutKeyOrEqualsSignIsRefused) {
  for (const char* bad : {"", "=", "=5", "start.r_m", ".r_m=5", "start.=5", "a..b=1"}) {
    EXPECT_EQ(SetMessage(bad),
              std::string("--set ") + bad + ": expected key=value such as start.r_m=5");
  }
}

TEST(SetOption, OfImpossibleDepthIsRefused) {
  std::string path = "a";
  for (int i = 0; i < 1000; ++i) path += ".a";
  EXPECT_THAT(SetMessage(path + "=1"), HasSubstr("nested too deep"));
}

TEST(ScenarioModels, ThroatNarrowerThanTheArmsTipIsRefused) {
  const ScratchFolder folder;
  for (const char* model : {"axel", "station", "soils"}) folder.CopyModel(model);
  const std::string station = "models/station/station.yaml";
  folder.Write(station, Replaced(Slurp(SourceFile(station)), "throat_radius_m: 0.0320",
                                 "throat_radius_m: 0.0295"));
  const std::string file = folder.Write("scenarios/s.yaml", Slurp(SourceFile(kTypical)));
  EXPECT_EQ(MessageOf([&] { LoadModels(LoadScenario(file)); }, folder),
            "models/station/station.yaml: cone.throat_radius_m: expected more than the 0.0312 m of "
            "the arm's tip in models/axel/axel.yaml, found '0.0295'");
}

}  // namespace
}  // namespace dockyard
