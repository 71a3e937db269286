#include "sim/app/identity.h"

#include <gtest/gtest.h>

#include "models/read/yaml_tree.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

/// Two runs of models in folders of their own.
class Identity : public testing::Test {
 protected:
  void SetUp() override {
    system_.file_keys = {"target"};
    for (const char* name : {"robot/robot.yaml", "station/station.yaml", "soil/soil.yaml",
                             "far/camera.yaml", "far/rig.yaml", "urdf/a.urdf", "urdf/a.stl"}) {
      folder_.Write(name, "name: as it was\n");
    }
    campaign_.runs.resize(2);
    for (CampaignRun& run : campaign_.runs) {
      run.scenario.robot_file = At("robot/robot.yaml");
      run.scenario.of_system =
          ParseYaml("target: " + At("station/station.yaml") + "\n", At("x.yaml"));
      run.scenario.soil_file = At("soil/soil.yaml");
    }
  }

  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }
  Scenario& LastScenario() { return campaign_.runs.back().scenario; }

  bool SeesAChangeOf(const std::string& name) const {
    const std::string before = IdentityText(campaign_, system_), text = Slurp(At(name));
    folder_.Write(name, text + "# changed\n");
    const bool differs = IdentityText(campaign_, system_) != before;
    folder_.Write(name, text);
    EXPECT_EQ(IdentityText(campaign_, system_), before);
    return differs;
  }

  Campaign campaign_;
  System system_;
  ScratchFolder folder_;
};

TEST_F(Identity, ChangesWithEachModelOfARun) {
  for (const char* name : {"robot/robot.yaml", "station/station.yaml", "soil/soil.yaml"}) {
    EXPECT_TRUE(SeesAChangeOf(name)) << name;
  }
}

TEST_F(Identity, ChangesWithTheCameraFileOfAScenario) {
  EXPECT_FALSE(SeesAChangeOf("far/camera.yaml"));
  LastScenario().camera_file = At("far/camera.yaml");
  EXPECT_TRUE(SeesAChangeOf("far/camera.yaml"));
}

TEST_F(Identity, ChangesWithFilesThatAModelNamesInOtherFolders) {
  folder_.Write("robot/robot.yaml", "urdf: ../urdf/a.urdf\ncameras: {file: ../far/rig.yaml}\n");
  for (const char* name : {"urdf/a.urdf", "urdf/a.stl", "far/rig.yaml"}) {
    EXPECT_TRUE(SeesAChangeOf(name)) << name;
  }
}

TEST_F(Identity, ChangesWithFilesThatTheChangesOfAScenarioName) {
  LastScenario().changes = ParseYaml("robot: {cameras: {file: far/rig.yaml}}", At("x.yaml"));
  EXPECT_TRUE(SeesAChangeOf("far/rig.yaml"));
}

}  // namespace
}  // namespace dockyard
