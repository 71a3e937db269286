#include "sim/app/check_file.h"

#include <gmock/gmock.h>

#include "sim/app/systems.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

FileCheck Check(const std::string& name) { return CheckFile(SourceFile(name), Systems()); }

TEST(CheckFile, NamesTheKindOfEveryFileHere) {
  const auto kind = [](const std::string& name) { return Check(name).kind; };
  EXPECT_EQ(kind("models/axel/axel.yaml"), "rover");
  EXPECT_EQ(kind("models/axel/axel.urdf"), "urdf");
  EXPECT_EQ(kind("models/axel/meshes/wheel.obj"), "mesh");
  EXPECT_EQ(kind("models/axel/station/station.yaml"), "station");
  EXPECT_EQ(kind("models/axel/station/station.urdf"), "urdf");
  EXPECT_EQ(kind("models/soils/loose_sand.yaml"), "soil");
  EXPECT_EQ(kind("models/soils/compact_gravel.yaml"), "soil");
  EXPECT_EQ(kind("models/wheels/axel.yaml"), "wheel");
  EXPECT_EQ(kind("models/cameras/navcam.yaml"), "rig");
  EXPECT_EQ(kind("models/rovers/rocky7.yaml"), "rover on wheels");
  EXPECT_EQ(kind("models/rocky7/rocky7.yaml"), "rover on wheels with cameras");
  EXPECT_EQ(kind("examples/obstacles.yaml"), "obstacles");
  EXPECT_EQ(kind("tests/models/data/m2020_cameras.json"), "camera");
  EXPECT_EQ(kind("scenarios/axel_typical.yaml"), "scenario");
  EXPECT_EQ(kind("scenarios/mars_yard_40.yaml"), "campaign");
  EXPECT_EQ(kind("scenarios/ci_4.yaml"), "campaign");
  EXPECT_EQ(kind("scenarios/mars_yard_40.csv"), "campaign table");
  EXPECT_EQ(kind("scenarios/studies/reel_alpha.yaml"), "campaign");
}

TEST(CheckFile, SaysInALineWhatIsInside) {
  EXPECT_EQ(Check("models/rovers/rocky7.yaml").summary,
            "rocky7: 6 wheels, 2 of them steered, 16.01 kg");
  EXPECT_EQ(Check("models/rovers/steered_six.yaml").summary,
            "steered_six: 6 wheels, 6 of them steered, 15.6 kg");
  EXPECT_EQ(Check("models/axel/axel.yaml").summary, "axel: 40 kg, arm 1 m, stereo baseline 0.35 m");
  EXPECT_EQ(Check("scenarios/mars_yard_40.yaml").summary,
            "mars_yard_40: 40 runs by day, region, soil, light, start.r_m, start.alpha_deg, "
            "start.heading_deg; seed 1");
  EXPECT_EQ(Check("scenarios/mars_yard_40.csv").summary,
            "40 runs; checked: light, start.r_m, start.alpha_deg, start.heading_deg; left to the "
            "campaign's file: day, region, soil");
  EXPECT_EQ(Check("scenarios/studies/reel_alpha.yaml").summary,
            "reel_alpha: 90 runs by point, soil, start.r_m, start.alpha_deg; seed 1");
}

TEST(CheckFile, ScenarioIsCheckedByItsSystem) {
  const ScratchFolder folder;
  for (const char* model : {"axel", "soils"}) folder.CopyModel(model);
  const std::string text = Slurp(SourceFile("scenarios/axel_typical.yaml"));
  const auto message = [&](const std::string& lines) {
    const std::string file = folder.Write("scenarios/s.yaml", text + lines);
    return MessageOf([&] { CheckFile(file, Systems()); }, folder);
  };
  EXPECT_EQ(message(""), "(no error)");
  EXPECT_THAT(message("changes: {station: {feet: {friction: x}}}\n"),
              HasSubstr("feet.friction: expected a number >= 0, found 'x'"));
}

TEST(CheckFile, SaysWhatOfAUrdfIsWeldedAndLeftOut) {
  const ScratchFolder folder;
  const std::string file = folder.Write(
      "m.urdf",
      "<robot name=\"m\"><gazebo/><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" "
      "type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint></robot>");
  EXPECT_EQ(
      CheckFile(file, Systems()).summary,
      "m: 2 links, 1 joint, 0 kg; welded: b into a; left out: 1 <gazebo>; a run takes it only "
      "through a robot's or target's YAML file, with the links and joints of that system");
}

TEST(CheckFile, RefusesWhatIsOfNoKnownKind) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& name, const std::string& text) {
    const std::string file = folder.Write(name, text);
    return MessageOf([&] { CheckFile(file, Systems()); }, folder);
  };
  EXPECT_EQ(message("a.yaml", "colour: red\n"),
            "a.yaml:1:1: expected the keys of a scenario, campaign, published experiment, board, "
            "soil, floor, wheel, camera, rig, rover on wheels, obstacles or of a system's own "
            "model, found "
            "none of them");
  EXPECT_EQ(
      message("a.txt", "x"),
      "a.txt: expected a file .yaml, .yml, .json, .xml, .csv, .urdf, .xacro, .stl, .obj, .dae, "
      ".gltf or .glb, found extension '.txt'");
  EXPECT_EQ(message("a.csv", "run" + std::string(200, ',') + "\n"),
            "a.csv:1:204: expected at most 200 columns, found 201");
  EXPECT_EQ(message("a.csv", "run,start.r_m\n1,2\nten,3\n"),
            "a.csv:3:1: run: expected a whole number from 0 to 2000000000, found 'ten'");
  EXPECT_EQ(message("b.yaml", "campaign: ../up\nbase: x.yaml\n"),
            "b.yaml:1:11: campaign: expected a name that its results folder can have: up to 100 "
            "bytes, no '/', found '../up'");
  EXPECT_THAT(MessageOf([&] { CheckFile(folder.path().string(), Systems()); }, folder),
              HasSubstr("expected a file, found a folder"));
}

}  // namespace
}  // namespace dockyard
