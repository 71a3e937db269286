// What a scenario says of dock and judge, at its root or under `custom`, and what is refused.
#include "sim/custom/custom_keys.h"

#include <gmock/gmock.h>

#include "custom/charger_rig.h"
#include "models/read/config_error.h"
#include "sim/plant/renderer.h"

namespace dockyard::custom {
namespace {

using ::testing::HasSubstr;

std::string Refusal(const std::vector<std::string>& overrides) {
  try {
    LoadModels(ChargerScenario(overrides));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(CustomKeys, OfTheJudgeAreReadAtTheRoot) {
  const JudgeKeys judge = ReadCustomKeys(ChargerScenario()).judge;
  EXPECT_EQ(judge.hold_s, 2.0);
  EXPECT_EQ(judge.docked.pose.robot, "contacts");
  EXPECT_EQ(judge.docked.pose.dock, "seat");
  EXPECT_DOUBLE_EQ(judge.docked.pose.yaw_rad, Radians(4.0));
  EXPECT_TRUE(std::isnan(judge.docked.pose.z_m));
  EXPECT_EQ(judge.docked.contact.pins, "charge");
  EXPECT_EQ(judge.docked.most_n, 80.0);
  EXPECT_EQ(judge.trial.push_n, 2.0);
}

TEST(CustomKeys, AreRefusedWithTheNearestName) {
  EXPECT_THAT(Refusal({"judge.docked.pose.robot=contact"}), HasSubstr("did you mean 'contacts'"));
  EXPECT_THAT(Refusal({"judge.docked.pose.dock=seta"}), HasSubstr("did you mean 'seat'"));
  EXPECT_THAT(Refusal({"judge.docked.contact.pins=chrage"}), HasSubstr("did you mean 'charge'"));
  EXPECT_THAT(Refusal({"judge.docked.pose.y_mm=3"}),
              HasSubstr("did you mean 'custom.judge.docked.pose.y_m'"));
}

TEST(CustomKeys, NameADockByTwoFiles) {
  const std::string dock = ChargerFile("dock/dock.yaml"), urdf = ChargerFile("dock/dock.urdf");
  const Scenario scenario = ChargerScenario({"dock={urdf: " + urdf + ", file: " + dock + "}"});
  EXPECT_EQ(LoadModels(scenario).nominal.dock.name, "flat charger");
}

TEST(CustomKeys, APinWithoutAPadIsRefused) {
  EXPECT_THAT(Refusal({"changes={robot: {contact_pads: [{contact: charge, pole: plus, link: "
                       "contacts, middle_m: [0, 0, 0], width_m: 0.01, height_m: 0.01}]}}"}),
              HasSubstr("expected a pad of contact 'charge' and pole 'minus' on Porter"));
}

TEST(CustomKeys, AStartInTheDockIsRefused) {
  const Scenario scenario = ChargerScenario({"start={r_m: 0.12, alpha_deg: 0, heading_deg: 0}"});
  const System system = CustomSystem({});
  try {
    system.make_ready(scenario);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("expected a start at which robot and dock are apart"));
  }
}

}  // namespace
}  // namespace dockyard::custom
