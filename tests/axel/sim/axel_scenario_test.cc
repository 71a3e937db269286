// The keys under `axel` and `changes` reach the models, or are refused with their place.
#include "sim/axel/load_models.h"

#include <gmock/gmock.h>

#include "models/read/config_error.h"
#include "sim/axel/build_run.h"
#include "sim/axel/nominal_json.h"
#include "sim/scenario/keys.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

const std::vector<KnownSystem>& Known() {
  static const std::vector<KnownSystem> known{
      {.name = "axel", .controllers = {"dockyard", "reel_only"}, .file_keys = {"station"}}};
  return known;
}
Scenario Typical(const std::vector<std::string>& sets = {}) {
  return LoadScenario(SourceFile("scenarios/axel_typical.yaml"), sets, Known());
}
std::string SetMessage(const std::string& set) {
  const ScratchFolder folder;
  return MessageOf([&] { LoadModels(Typical({set})); }, folder);
}

TEST(TypicalScenario, NamesModelsThatLoadAndFitEachOther) {
  const AxelModels models = LoadModels(Typical());
  EXPECT_EQ(models.nominal.rover.name, "axel");
  EXPECT_EQ(models.nominal.station.tip_angle_rad, Radians(5.0));
  EXPECT_EQ(models.nominal.soil.name, "compact_gravel");
  EXPECT_EQ(models.nominal.rover.stereo.nominal.left.width, 1024);
}

TEST(AxelKeys, PageHasTheTableThatTheVisitorDocuments) {
  const std::string page = Slurp(SourceFile("docs/reference/scenarios.md"));
  const std::string begin = "tests/axel/sim/axel_scenario_test.cc -->\n";
  const std::size_t from = page.find(begin), to = page.find("<!-- end of keys of axel -->");
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  AxelKeys values;
  const std::string table =
      KeyTable(DocumentKeys([&](Keys& keys) { VisitAxelKeys(keys, values); }));
  EXPECT_EQ(page.substr(from + begin.size(), to - from - begin.size()), table);
}

TEST(AxelKeys, SoilMarksReachTheWorldAndAreRutsWithoutTheKey) {
  const auto Marks = [](const std::vector<std::string>& sets) {
    const Scenario scenario = Typical(sets);
    const WorldSetup world = BuildRun(scenario, LoadModels(scenario)).world;
    return std::pair(world.paddles_print, world.body_marks_soil);
  };
  EXPECT_EQ(Marks({}), std::pair(false, false));
  EXPECT_EQ(Marks({"axel.soil_marks=ruts"}), std::pair(false, false));
  EXPECT_EQ(Marks({"axel.soil_marks=prints"}), std::pair(true, false));
  EXPECT_EQ(Marks({"axel.soil_marks=all"}), std::pair(true, true));
  EXPECT_THAT(SetMessage("axel.soil_marks=none"), HasSubstr("axel.soil_marks"));
}

TEST(AxelKeys, AnExcursionIsToldToTheControllerAndStartsSeated) {
  const auto Built = [](const std::vector<std::string>& sets) {
    const Scenario scenario = Typical(sets);
    return BuildRun(scenario, LoadModels(scenario));
  };
  const BuiltRun out = Built({"axel.excursion_m=7"}), only = Built({});
  EXPECT_EQ(out.nominal.excursion_m, 7.0);
  EXPECT_EQ(NominalFromJson(ToJson(out.nominal)).excursion_m, 7.0);
  EXPECT_FALSE(ToJson(only.nominal).contains("excursion_m"));
  const double along_m = 1.0 - out.nominal.seat_depth_m;  // axle to mouth, an arm of 1 m
  EXPECT_NEAR(out.world.X_DR_start.x, along_m * std::cos(Radians(5.0)), 1e-9);
  EXPECT_EQ(out.world.slack_start_m, 0.0);
}

TEST(AxelKeys, AStartBehindTheStationIsRefused) {
  const auto Build = [](const char* alpha) {
    const Scenario scenario = Typical({alpha});
    return BuildRun(scenario, LoadModels(scenario));
  };
  EXPECT_NO_THROW(Build("start.alpha_deg=90"));
  EXPECT_THROW(Build("start.alpha_deg=91"), ConfigError);
}

TEST(AxelKeys, AnExcursionThatCannotBeMadeIsRefused) {
  const ScratchFolder folder;
  const auto Message = [&](const std::vector<std::string>& sets) {
    return MessageOf([&] { LoadModels(Typical(sets)); }, folder);
  };
  EXPECT_THAT(Message({"axel.excursion_m=5", "controller=reel_only"}),
              HasSubstr("axel.excursion_m: expected the controller dockyard"));
  EXPECT_THAT(Message({"axel.excursion_m=5", "axel.start.arm=trailing"}),
              HasSubstr("axel.start: expected none beside excursion_m"));
  EXPECT_THAT(Message({"axel.excursion_m=8"}), HasSubstr("expected at most 7.5 in a yard"));
}

TEST(AxelKeys, WhatOnlyDockyardUsesIsRefusedBesideAnotherBuiltInController) {
  const ScratchFolder folder;
  for (const std::string key : {"vision.while_driving", "rock_map.made"}) {
    const auto Load = [&](const std::string& controller) {
      LoadModels(Typical({"axel." + key + "=true", "controller=" + controller}));
    };
    EXPECT_NO_THROW(Load("dockyard"));
    EXPECT_THAT(MessageOf([&] { Load("reel_only"); }, folder),
                HasSubstr("axel." + key.substr(0, key.find(".made")) +
                          ": expected the controller dockyard"));
  }
}

TEST(AxelKeys, TipAngleAndImageSizeReachTheModels) {
  const AxelModels models =
      LoadModels(Typical({"axel.tip_angle_deg=0", "camera.width_px=640", "camera.height_px=480"}));
  EXPECT_EQ(models.nominal.station.tip_angle_rad, 0.0);
  EXPECT_EQ(models.nominal.rover.stereo.nominal.right.width, 640);
  EXPECT_NEAR(models.nominal.rover.stereo.nominal.right.focal_px().x(), 640 / (kPi / 2), 1e-9);
}

TEST(AxelKeys, DustIsAShareUpToItsLimit) {
  EXPECT_EQ(LoadModels(Typical({"axel.board_dust=0.25"})).keys.board_dust, 0.25);
  EXPECT_EQ(LoadModels(Typical()).keys.board_dust, 0.0);
  EXPECT_EQ(SetMessage("axel.board_dust=0.7"),
            "--set axel.board_dust=0.7: axel.board_dust: expected a number >= 0 and <= 0.6, found "
            "'0.7'");
  EXPECT_EQ(SetMessage("axel.board_dust=much"),
            "--set axel.board_dust=much: axel.board_dust: expected a number >= 0, found 'much'");
}

TEST(AxelKeys, WhatThePaperLeavesOpenReachesTheController) {
  const Scenario scenario =
      Typical({"axel.tsai2013.first=largest", "axel.tsai2013.agreeing_points=6",
               "axel.tsai2013.heading_deg=7", "axel.tsai2013.reel_in_m=0.3"});
  const Nominal nominal = NominalFromJson(ToJson(BuildRun(scenario, LoadModels(scenario)).nominal));
  EXPECT_EQ(nominal.vision.tsai2013.first, Tsai2013First::kLargest);
  EXPECT_EQ(nominal.vision.tsai2013.agreeing_points, 6);
  EXPECT_EQ(nominal.tsai2013.heading_rad, Radians(7.0));
  EXPECT_EQ(nominal.tsai2013.reel_in_m, 0.3);
  EXPECT_EQ(nominal.tsai2013.drive_m_s, Tsai2013Options{}.drive_m_s);
}

// The place's: rover and station weigh in it, and it is a nominal parameter (gravity_test.cc).
TEST(Changes, OfTheSoilsGravityAreThoseOfTheWorld) {
  const AxelModels models = LoadModels(Typical({"changes.soil.gravity_m_s2=1.62"}));
  EXPECT_EQ(models.nominal.soil.gravity_m_s2, 1.62);
  EXPECT_EQ(models.built.soil.gravity_m_s2, 1.62);
  EXPECT_THAT(SetMessage("changes.soil.gravity_m_s2=0"), HasSubstr("gravity_m_s2: expected"));
}

TEST(AxelKeys, UnknownKeyNamesTheNearest) {
  EXPECT_THAT(SetMessage("axel.board_dst=0.1"), HasSubstr("did you mean 'axel.board_dust'?"));
}

TEST(Changes, ReachTheModelsOfAScenario) {
  const AxelModels models =
      LoadModels(Typical({"changes.station.feet.friction=0.3", "changes.station.mass_kg=70",
                          "changes.station.mouth_height_m=0.4", "changes.robot.mass_scale=1.5",
                          "changes.robot.body_com_x_m=-0.02", "changes.soil.cohesion_pa=123"}));
  EXPECT_EQ(models.nominal.station.foot_friction, 0.3);
  EXPECT_EQ(models.nominal.station.module.mass_kg, 70.0);
  EXPECT_NEAR(models.nominal.station.module.I_LCom_L(1, 1), 2.0 * 3.23203125, 1e-9);
  EXPECT_EQ(models.nominal.station.mouth_height_m, 0.4);
  EXPECT_NEAR(models.nominal.rover.mass_kg(), 60.0, 1e-9);
  EXPECT_EQ(models.nominal.rover.body.p_LoCom_L.x(), -0.02);
  EXPECT_EQ(models.nominal.soil.cohesion_pa, 123.0);
}

TEST(Changes, AreWrittenOutAndReadBack) {
  const Scenario s =
      Typical({"changes.station.feet.friction=0.3", "changes.robot.name='a \"b\" \\ c'",
               "changes.soil.rgb=[0.1, 0.2, 0.3]"});
  const ScratchFolder folder;
  const Scenario back = LoadScenario(folder.Write("r.yaml", ResolvedYaml(s)), {}, Known());
  EXPECT_EQ(FlowText(back.changes), FlowText(s.changes));
  EXPECT_EQ(LoadModels(back).nominal.rover.name, "a \"b\" \\ c");
  EXPECT_EQ(LoadModels(back).nominal.soil.rgb.y(), 0.2);
}

TEST(Changes, UnknownKeysAndValuesAreRefusedWithTheirPlace) {
  EXPECT_THAT(SetMessage("changes.staton.mass_kg=3"), HasSubstr("station"));
  EXPECT_THAT(SetMessage("changes.rover.mass_scale=3"), HasSubstr("robot"));
  EXPECT_THAT(SetMessage("changes.station.feet.frction=3"), HasSubstr("--set"));
  EXPECT_EQ(SetMessage("changes.station.feet.friction=x"),
            "--set changes.station.feet.friction=x: feet.friction: expected a number >= 0, found "
            "'x'");
}

TEST(ScenarioModels, ThroatNarrowerThanTheArmsTipIsRefused) {
  const ScratchFolder folder;
  for (const char* model : {"axel", "soils"}) folder.CopyModel(model);
  const std::string station = "models/axel/station/station.yaml";
  folder.Write(station, Replaced(Slurp(SourceFile(station)), "throat_radius_m: 0.0320",
                                 "throat_radius_m: 0.0295"));
  const std::string file =
      folder.Write("scenarios/s.yaml", Slurp(SourceFile("scenarios/axel_typical.yaml")));
  EXPECT_EQ(MessageOf([&] { LoadModels(LoadScenario(file, {}, Known())); }, folder),
            "models/axel/station/station.yaml: cone.throat_radius_m: expected more than the 0.0312 "
            "m of the arm's tip in models/axel/axel.yaml, found '0.0295'");
}

}  // namespace
}  // namespace dockyard::axel
