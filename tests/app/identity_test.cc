#include "sim/app/identity.h"

#include <gtest/gtest.h>

#include "models/read/yaml_tree.h"
#include "sim/plan/file_keys.h"
#include "sim/scenario/key_path.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

/// A campaign of models in folders of their own.
class Identity : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"robot/robot.yaml", "station/station.yaml", "soil/soil.yaml",
                             "far/camera.yaml", "far/rig.yaml", "urdf/a.urdf", "urdf/a.stl"}) {
      folder_.Write(name, "name: as it was\n");
    }
    campaign_.base = ParseYaml(
        "{robot: robot/robot.yaml, soil: soil/soil.yaml, toy: {target: station/station.yaml}}",
        At("x.yaml"));
  }

  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }
  void Set(const std::string& key, const std::string& text) {
    PutPath(campaign_.base, key, {}, ParseYaml(text, At("x.yaml")));
  }
  std::string Text() const {
    const std::vector<KnownSystem> systems{{"toy", {}, {"target"}, {"robot.cameras.file"}}};
    const Campaign campaign = WithAbsolutePaths(campaign_, systems);
    return MakeManifest(IdentityOf(campaign, systems), {}).dump();
  }
  bool SeesAChangeOf(const std::string& name) const {
    const std::string before = Text(), text = Slurp(At(name));
    folder_.Write(name, text + "\n");
    const bool differs = Text() != before;
    folder_.Write(name, text);
    EXPECT_EQ(Text(), before);
    return differs;
  }

  Campaign campaign_;
  ScratchFolder folder_;
};

TEST_F(Identity, ChangesWithEachModelOfARun) {
  for (const char* name : {"robot/robot.yaml", "station/station.yaml", "soil/soil.yaml"}) {
    EXPECT_TRUE(SeesAChangeOf(name)) << name;
  }
}

TEST_F(Identity, HasNothingOfFilesThatNobodyNames) {
  EXPECT_FALSE(SeesAChangeOf("urdf/a.stl"));
  folder_.Write("robot/diary.txt", "private");
  EXPECT_EQ(Text().find("diary"), std::string::npos);
}

TEST_F(Identity, IsTheSameWhereverTheFilesLieTogether) {
  const std::string here = Text();
  EXPECT_EQ(here.find(folder_.path().string()), std::string::npos);
  const ScratchFolder elsewhere;
  for (const char* name : {"robot/robot.yaml", "station/station.yaml", "soil/soil.yaml"}) {
    elsewhere.Write(name, Slurp(At(name)));
  }
  campaign_.base = ParseYaml(
      "{robot: robot/robot.yaml, soil: soil/soil.yaml, toy: {target: station/station.yaml}}",
      (elsewhere.path() / "x.yaml").string());
  EXPECT_EQ(Text(), here);
}

TEST_F(Identity, ChangesWithTheCameraFileOfAScenario) {
  EXPECT_FALSE(SeesAChangeOf("far/camera.yaml"));
  Set("camera.file", "far/camera.yaml");
  EXPECT_TRUE(SeesAChangeOf("far/camera.yaml"));
}

TEST_F(Identity, ChangesWithFilesThatAModelNamesInOtherFolders) {
  folder_.Write("urdf/a.urdf", "<robot><mesh filename='a.stl'/></robot>\n");
  folder_.Write("robot/robot.yaml", "urdf: ../urdf/a.urdf\ncameras: {file: ../far/rig.yaml}\n");
  for (const char* name : {"urdf/a.urdf", "urdf/a.stl", "far/rig.yaml"}) {
    EXPECT_TRUE(SeesAChangeOf(name)) << name;
  }
}

TEST_F(Identity, ChangesWithAFileOfAnyArmPointOrDraw) {
  campaign_.grid = {ReadFactor({"soil", {}}, ParseYaml("[far/camera.yaml]", At("x.yaml")), "soil")};
  EXPECT_TRUE(SeesAChangeOf("far/camera.yaml"));
  campaign_.arms = {{"other", {{{"robot", {}}, ParseYaml("far/rig.yaml", At("x.yaml"))}}}};
  EXPECT_TRUE(SeesAChangeOf("far/rig.yaml"));
}

TEST_F(Identity, ChangesWithFilesThatTheChangesOfAScenarioName) {
  Set("changes.robot.cameras.file", "far/rig.yaml");
  EXPECT_TRUE(SeesAChangeOf("far/rig.yaml"));
}

}  // namespace
}  // namespace dockyard
