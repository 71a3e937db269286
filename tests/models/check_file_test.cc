#include "models/check_file.h"

#include <gmock/gmock.h>

#include "bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

TEST(CheckFile, TellsTheKindOfEveryFileHere) {
  const auto kind = [](const std::string& name) { return CheckFile(SourceFile(name)).kind; };
  EXPECT_EQ(kind("models/axel/axel.yaml"), "rover");
  EXPECT_EQ(kind("models/axel/axel.urdf"), "urdf");
  EXPECT_EQ(kind("models/axel/meshes/wheel.obj"), "mesh");
  EXPECT_EQ(kind("models/station/station.yaml"), "station");
  EXPECT_EQ(kind("models/station/station.urdf"), "urdf");
  EXPECT_EQ(kind("models/soils/loose_sand.yaml"), "soil");
  EXPECT_EQ(kind("models/soils/compact_gravel.yaml"), "soil");
  EXPECT_EQ(kind("models/cameras/navcam.yaml"), "rig");
  EXPECT_EQ(kind("tests/models/data/m2020_cameras.json"), "camera");
  EXPECT_EQ(kind("scenarios/axel_typical.yaml"), "scenario");
  EXPECT_EQ(kind("scenarios/mars_yard_40.yaml"), "campaign");
  EXPECT_EQ(kind("scenarios/ci_4.yaml"), "campaign");
  EXPECT_EQ(kind("scenarios/mars_yard_40.csv"), "campaign table");
}

TEST(CheckFile, SaysInALineWhatIsInside) {
  EXPECT_EQ(CheckFile(SourceFile("models/axel/axel.yaml")).summary,
            "axel: 40 kg, arm 1 m, stereo baseline 0.35 m");
  EXPECT_EQ(CheckFile(SourceFile("scenarios/mars_yard_40.yaml")).summary,
            "mars_yard_40: 40 runs on 2 soils, seed 1");
  EXPECT_EQ(CheckFile(SourceFile("scenarios/mars_yard_40.csv")).summary, "40 runs");
}

TEST(CheckFile, RefusesWhatIsOfNoKnownKind) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& name, const std::string& text) {
    const std::string file = folder.Write(name, text);
    return MessageOf([&] { CheckFile(file); }, folder);
  };
  EXPECT_EQ(
      message("a.yaml", "colour: red\n"),
      "a.yaml:1:1: expected the keys of a rover, station, board, soil, wheel, camera, rig, scenario, "
      "campaign or study, found none of them");
  EXPECT_EQ(message("a.txt", "x"),
            "a.txt: expected a file .yaml, .yml, .json, .csv, .urdf, .stl, .obj, .dae, .gltf or "
            ".glb, found "
            "extension "
            "'.txt'");
  EXPECT_EQ(message("a.csv", "run,day\n1,ten\n").rfind("a.csv:2:", 0), 0u);
  EXPECT_EQ(message("b.yaml", "campaign: ../up\nbase: x.yaml\n"),
            "b.yaml:1:11: campaign: expected a name that its results folder can have: up to 100 "
            "bytes, no '/', found '../up'");
  EXPECT_THAT(MessageOf([&] { CheckFile(folder.path().string()); }, folder),
              HasSubstr("expected a file, found a folder"));
}

}  // namespace
}  // namespace dockyard
