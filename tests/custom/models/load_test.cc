// Robots and docks from files: what is taken from the URDF, and what is refused.
#include <gmock/gmock.h>

#include "custom/charger_rig.h"
#include "models/custom/make_nominal.h"
#include "models/read/config_error.h"

namespace dockyard::custom {
namespace {

using ::testing::HasSubstr;

std::string Refusal(const std::string& changes) {
  const YamlNode drawn = ParseYaml(changes, "changes.yaml");
  try {
    LoadRobot(ChargerFile("robot/robot.yaml"), {&drawn, nullptr});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(LoadRobot, TakesRadiusAndWidthOfAWheelFromItsCollision) {
  const RobotModel robot = LoadRobot(ChargerFile("robot/robot.yaml"));
  ASSERT_EQ(robot.wheels.size(), 4u);
  EXPECT_DOUBLE_EQ(robot.wheels[0].tyre.radius_m, 0.035);
  EXPECT_DOUBLE_EQ(robot.wheels[0].tyre.width_m, 0.018);
  EXPECT_DOUBLE_EQ(robot.wheels[2].tyre.radius_m, 0.014);
  EXPECT_TRUE(robot.wheels[0].axle_L.isApprox(Eigen::Vector3d::UnitY()));
}

TEST(LoadRobot, TellsTheControllerWhichWheelsAreDrivenAndWhichSwivel) {
  const Nominal nominal = MakeNominal(LoadRobot(ChargerFile("robot/robot.yaml")),
                                      LoadDock(ChargerFile("dock/dock.yaml")));
  ASSERT_EQ(nominal.wheels.size(), 4u);
  EXPECT_EQ(nominal.wheels[0].drive, 0);
  EXPECT_EQ(nominal.wheels[1].drive, 1);
  EXPECT_FALSE(nominal.wheels[0].swivels);
  EXPECT_TRUE(nominal.wheels[2].swivels);
  EXPECT_EQ(nominal.wheels[2].drive, -1);
  EXPECT_TRUE(nominal.wheels[2].p_RS.isApprox(Eigen::Vector3d(0.125, 0.0, -0.010)));
  EXPECT_DOUBLE_EQ(nominal.height_m, 0.035);
  // The tag faces x of D; its x axis is to the right of its viewer.
  ASSERT_EQ(nominal.boards.size(), 1u);
  EXPECT_TRUE(nominal.boards[0].X_DB.R.col(2).isApprox(-Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(nominal.boards[0].X_DB.R.col(0).isApprox(Eigen::Vector3d::UnitY()));
}

TEST(LoadRobot, RefusesNamesThatTheUrdfDoesNotHave) {
  EXPECT_THAT(Refusal("wheels: [{links: [left_weel]}]"), HasSubstr("did you mean 'left_wheel'"));
  EXPECT_THAT(Refusal("wheels: [{links: [camera_link]}]"),
              HasSubstr("expected a link on a joint that turns"));
  EXPECT_THAT(Refusal("wheels: [{links: [left_wheel, left_wheel]}]"),
              HasSubstr("expected each wheel once"));
  EXPECT_THAT(Refusal("switches: [{name: bumper, joint: bumper}]"),
              HasSubstr("expected a joint of the URDF file that moves"));
  EXPECT_THAT(Refusal("contact_pads: [{contact: c, pole: p, link: contcts, middle_m: [0, 0, 0], "
                      "width_m: 0.01, height_m: 0.01}]"),
              HasSubstr("did you mean 'contacts'"));
}

TEST(LoadRobot, RefusesADocksFileAndLoadDockARobots) {
  const auto refusal = [](const auto& load) -> std::string {
    try {
      load();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal([] { LoadRobot(ChargerFile("dock/dock.yaml")); }),
              HasSubstr("expected a robot's file, found a dock's"));
  EXPECT_THAT(refusal([] { LoadDock(ChargerFile("robot/robot.yaml")); }),
              HasSubstr("expected a dock's file, found a robot's"));
}

TEST(LoadRobot, NamesAllItsLinksWhereNoneIsNear) {
  EXPECT_THAT(Refusal("contact_pads: [{contact: c, pole: p, link: xyz, middle_m: [0, 0, 0], "
                      "width_m: 0.01, height_m: 0.01}]"),
              HasSubstr("'contacts'"));
  EXPECT_THAT(Refusal("tow_hook: 1"), HasSubstr("docs/reference/custom.md"));
}

TEST(LoadRobot, RefusesTwoSensorsOfOneName) {
  EXPECT_THAT(Refusal("range_finders: [{name: a, link: contacts, most_m: 2}, "
                      "{name: a, link: contacts, most_m: 3}]"),
              HasSubstr("range_finders[1].name: expected a name of its own, found a second 'a'"));
}

std::string DockRefusal(const std::string& built_text) {
  const YamlNode built = ParseYaml(built_text, "built.yaml");
  try {
    LoadDock(ChargerFile("dock/dock.yaml"), {nullptr, &built});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(LoadDock, BendsWhatIsBuiltAndTellsTheControllerOfAFlatBoard) {
  const YamlNode built =
      ParseYaml("boards_as_built: {flatness_m: {plus: -0.002}, bow_deg: 90}", "built.yaml");
  const DockModel drawn = LoadDock(ChargerFile("dock/dock.yaml"));
  const DockModel dock = LoadDock(ChargerFile("dock/dock.yaml"), {nullptr, &built});
  EXPECT_EQ(drawn.boards[0].flatness_m, 0.0);
  EXPECT_DOUBLE_EQ(dock.boards[0].flatness_m, -0.002);
  EXPECT_DOUBLE_EQ(dock.boards[0].bow_rad, Radians(90.0));
  const RobotModel robot = LoadRobot(ChargerFile("robot/robot.yaml"));
  const DockBoard flat = MakeNominal(robot, drawn).boards[0],
                  bent = MakeNominal(robot, dock).boards[0];
  EXPECT_EQ(flat.X_DB.p, bent.X_DB.p);
  EXPECT_EQ(flat.X_DB.R, bent.X_DB.R);
  EXPECT_EQ(flat.board.tags[0].size_m, bent.board.tags[0].size_m);
}

// A tenth of the 160 mm of its board.
TEST(LoadDock, RefusesABowBeyondATenthOfTheBoard) {
  EXPECT_EQ(DockRefusal("boards_as_built: {flatness_m: -0.016}"), "");
  EXPECT_THAT(DockRefusal("{boards_as_built: {flatness_m: -0.017}}"),
              HasSubstr("built.yaml:1:32: boards_as_built.flatness_m: expected at most 0.016 m to "
                        "either side, a tenth of the smaller side of board 'tag', found '-0.017'"));
}

TEST(LoadDock, ScalesPrintAndMass) {
  const YamlNode built = ParseYaml(
      "{mass_scale: {times: 1.5}, boards: [{name: tag, file: " + ChargerFile("dock/tag.yaml") +
          ", link: dock, middle_m: [-0.06, 0, 0.2], print_scale: 0.98}]}",
      "built.yaml");
  const DockModel drawn = LoadDock(ChargerFile("dock/dock.yaml"));
  const DockModel dock = LoadDock(ChargerFile("dock/dock.yaml"), {nullptr, &built});
  EXPECT_DOUBLE_EQ(dock.tree.mass_kg(), 1.5 * drawn.tree.mass_kg());
  ASSERT_FALSE(dock.boards[0].board.tags.empty());
  EXPECT_DOUBLE_EQ(dock.boards[0].board.tags[0].size_m, 0.098);
}

}  // namespace
}  // namespace dockyard::custom
