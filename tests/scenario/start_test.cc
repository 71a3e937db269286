// A system whose starts have numbers of their own.
#include "sim/scenario/start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/read/config_error.h"
#include "sim/scenario/load_scenario.h"
#include "sim/scenario/scenario_keys.h"
#include "sim/scenario/scenario_schema.h"

namespace dockyard {
namespace {

using testing::HasSubstr;

std::vector<KnownSystem> Divers() {
  KnownSystem diver{"diver", {"sinking"}, {}};
  diver.start =
      Start({{"range_m", "m", Between(1.0, 50.0), "from the cage"},
             {"bearing_deg", "deg", Between(-90.0, 90.0), "about the cage"},
             {"up_m", "m", Between(-10.0, 10.0), "above the cage"}},
            [](const Start& start) { return RobotPose(start.Value("range_m"), 0.0, 0.0); });
  return {{"rover", {"rolling"}, {}}, diver};
}

Scenario Read(const std::string& start) {
  return ReadScenario(ParseYaml("name: dive\nsystem: diver\nstart: " + start + "\n", "s.yaml"),
                      Divers());
}

std::string Refused(const std::string& start) {
  try {
    Read(start);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Start, OfASystemsOwnIsReadAndWritten) {
  const Scenario scenario = Read("{up_m: -2.5, range_m: 12, bearing_deg: 30}");
  EXPECT_EQ(scenario.start.Value("range_m"), 12.0);
  EXPECT_EQ(scenario.start.Value("bearing_deg"), Radians(30.0));
  EXPECT_EQ(scenario.start.Value("up_m"), -2.5);
  EXPECT_FALSE(scenario.start.IsOnPlane());
  EXPECT_EQ(scenario.start.pose().x, 12.0);
  EXPECT_EQ(scenario.start_place, "s.yaml:3:30: start");
  const std::string text = ResolvedYaml(scenario);
  EXPECT_THAT(text, HasSubstr("start:\n  range_m: 12\n  bearing_deg: 30\n  up_m: -2.5\n"));
  EXPECT_EQ(ResolvedYaml(ReadScenario(ParseYaml(text, "again.yaml"), Divers())), text);
}

TEST(Start, OfASystemsOwnRefusesWhatTheSystemDoesNotName) {
  EXPECT_EQ(Refused("{range_m: 5, bearing_deg: 0, up: 1}"),
            "s.yaml:3:37: start.up: unknown key, known are: range_m, bearing_deg, up_m");
  EXPECT_THAT(Refused("{r_m: 5, alpha_deg: 0, heading_deg: 0}"), HasSubstr("start.r_m: unknown"));
  EXPECT_EQ(Refused("{range_m: 5, up_m: 1}"), "s.yaml:3:8: start: missing key 'bearing_deg'");
  EXPECT_EQ(Refused("{range_m: 51, bearing_deg: 0, up_m: 1}"),
            "s.yaml:3:18: start.range_m: expected a number from 1 to 50, found '51'");
}

TEST(Start, OfEachSystemIsInTheSchema) {
  std::vector<SystemKeys> systems;
  for (const KnownSystem& known : Divers()) systems.push_back({known, {}});
  const Json schema = ScenarioSchema(systems, true);
  EXPECT_EQ(schema["properties"]["start"]["anyOf"].size(), 2u);
  const Json& rule = schema["allOf"][1]["then"]["properties"]["start"];
  EXPECT_EQ(rule["properties"]["range_m"]["maximum"], 50.0);
  EXPECT_EQ(rule["required"].dump(), R"(["range_m","bearing_deg","up_m"])");
  EXPECT_FALSE(rule["properties"].contains("r_m"));
}

}  // namespace
}  // namespace dockyard
