// What a scenario says of dock and judge, at its root or under `custom`, and what is refused.
#include "sim/custom/custom_keys.h"

#include <gmock/gmock.h>

#include "custom/charger_rig.h"
#include "models/read/config_error.h"
#include "sim/base/files.h"
#include "sim/plant/renderer.h"
#include "support/bad_files.h"

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

TEST(CustomKeys, ATrialThatTriesNothingIsRefused) {
  EXPECT_THAT(Refusal({"judge.trial.push_n=0"}),
              HasSubstr("expected a push_n, shake_n or drive_m_s above zero"));
}

TEST(CustomKeys, APinThatNeverClosesIsRefused) {
  EXPECT_THAT(
      Refusal({"changes={dock: {contact_pins: [{contact: charge, pole: plus, link: dock, tip_m: "
               "[0, 0, 0.06], stroke_m: 0.004, first_n: 0.8, last_n: 2, closes_n: 3}]}}"}),
      HasSubstr("contact_pins[0].closes_n: expected less than last_n"));
}

std::string RefusedStart(const std::vector<std::string>& overrides) {
  try {
    CustomSystem({}).make_ready(ChargerScenario(overrides));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(CustomKeys, AStartInTheDockIsRefused) {
  EXPECT_THAT(RefusedStart({"start={r_m: 0.12, alpha_deg: 0, heading_deg: 0}"}),
              HasSubstr("expected a start at which robot and dock are apart"));
}

TEST(CustomKeys, ADockThatDoesNotRestIsRefused) {
  EXPECT_EQ(RefusedStart({}), "");
  const ScratchFolder folder;
  const auto with_dock = [&](const std::string& old, const std::string& now) {
    std::string urdf = *ReadWhole(ChargerFile("dock/dock.urdf"));
    for (std::size_t at = urdf.find(old); at != urdf.npos; at = urdf.find(old, at + now.size()))
      urdf.replace(at, old.size(), now);
    folder.Write("dock.urdf", urdf);
    return RefusedStart({"dock={urdf: " + (folder.path() / "dock.urdf").string() +
                         ", file: " + ChargerFile("dock/dock.yaml") + "}"});
  };
  // Its box 5 cm in the floor, 5 cm over it, and its weight before its feet.
  const std::string at_rest = "expected a dock that is at rest on the floor";
  EXPECT_THAT(with_dock("-0.06 0 0.055", "-0.06 0 0.005"), HasSubstr(at_rest));
  EXPECT_THAT(with_dock("-0.06 0 0.055", "-0.06 0 0.105"), HasSubstr(at_rest));
  EXPECT_THAT(with_dock("-0.065 0 0.05\"", "0.15 0 0.05\""), HasSubstr(at_rest));
}

}  // namespace
}  // namespace dockyard::custom
