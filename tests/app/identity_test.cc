#include "sim/app/identity.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "models/read/config_error.h"
#include "models/read/urdf.h"
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

TEST_F(Identity, HoldsOfAProgramWhatTheScenarioNames) {
  for (const char* name : {"far/a.py", "far/b.py", "far/c.py", "weights.bin"}) {
    folder_.Write(name, "pass\n");
  }
  Set("controller", "{command: [python3, a.py], folder: far, files: [b.py, ../weights.bin]}");
  for (const char* name : {"far/a.py", "far/b.py", "weights.bin"}) {
    EXPECT_TRUE(SeesAChangeOf(name)) << name;
  }
  EXPECT_EQ(Text().find("c.py"), std::string::npos);
  const auto said = UnnamedFilesOf(WithAbsolutePaths(campaign_, {}), {});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].rfind("controller.files: c.py lies next to the program", 0), 0u) << said[0];
}

TEST_F(Identity, HoldsNoFileToWhichALinkLeadsOutOfAProgramsFolder) {
  folder_.Write("secret", "private\n");
  folder_.Write("far/a.py", "pass\n");
  std::filesystem::create_symlink("../secret", At("far/b.py"));
  Set("controller", "{command: [python3, a.py, b.py], folder: far}");
  EXPECT_FALSE(SeesAChangeOf("secret"));
  EXPECT_TRUE(SeesAChangeOf("far/a.py"));
}

TEST_F(Identity, RefusesAFileThatNoReaderOfTheResultsTakes) {
  folder_.Write("far/a.py", "");
  std::filesystem::resize_file(At("far/a.py"), std::uintmax_t{300} << 20);  // sparse
  Set("controller", "{command: [python3, a.py], folder: far}");
  EXPECT_THROW(Text(), ConfigError);
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

// A campaign's folder holds copies, which later commands read in place of the files.
TEST_F(Identity, HoldsTheMeshesOfPackagesSoThatTheCopiesLoad) {
  constexpr char kTriangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto named = [](const std::string& mesh) {
    return "<visual><geometry><mesh filename=\"" + mesh + "\"/></geometry></visual>";
  };
  folder_.Write("src/arm/package.xml", "<package><name>arm</name></package>");
  folder_.Write("src/arm/urdf/arm.urdf", "<robot name=\"m\"><link name=\"a\">" +
                                             named("package://arm/meshes/a.obj") +
                                             named("../meshes/b%20c.obj") +
                                             named("model://hand/d.obj") + "</link></robot>\n");
  for (const char* mesh : {"arm/meshes/a.obj", "arm/meshes/b c.obj", "hand/d.obj"}) {
    folder_.Write(std::string("src/") + mesh, kTriangle);
  }
  folder_.Write("src/hand/model.config", "<model/>");
  folder_.Write("robot/robot.yaml", "urdf: ../src/arm/urdf/arm.urdf\n");
  for (const char* mesh : {"arm/meshes/a.obj", "arm/meshes/b c.obj", "hand/d.obj"}) {
    EXPECT_TRUE(SeesAChangeOf(std::string("src/") + mesh)) << mesh;
  }
  const std::vector<KnownSystem> systems{{"toy", {}, {"target"}, {}}};
  const ScratchFolder results;
  std::string urdf;
  for (const auto& [copy, original] :
       IdentityOf(WithAbsolutePaths(campaign_, systems), systems).files) {
    const std::string file = results.Write(copy, Slurp(original));
    if (original.extension() == ".urdf") urdf = file;
  }
  std::filesystem::remove_all(folder_.path() / "src");
  EXPECT_EQ(LoadUrdf(urdf).links.at(0).visuals.size(), 3u);
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
