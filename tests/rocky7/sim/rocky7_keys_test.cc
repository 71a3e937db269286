#include "sim/rocky7/rocky7_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/read/config_error.h"
#include "models/read/yaml_tree.h"
#include "sim/rocky7/rocky7_system.h"
#include "support/bad_files.h"

namespace dockyard::rocky7 {
namespace {

using testing::HasSubstr;

Scenario SampleScenario() {
  Scenario scenario;
  scenario.name = "test";
  scenario.system = "rocky7";
  scenario.robot_file = SourceFile("models/rocky7/rocky7.yaml");
  scenario.soil_file = SourceFile("models/soils/compact_gravel.yaml");
  scenario.start = {1.5, 0.0, 0.0};
  scenario.start_place = "test.yaml:5:3: start";
  scenario.yard_place = "test.yaml:6:3";
  scenario.yard.length_m = scenario.yard.width_m = 5.0;
  scenario.yard.cell_m = 0.01;
  return scenario;
}

std::string ErrorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(Rocky7Keys, PageHasTheTableThatTheVisitorDocuments) {
  const std::string page = Slurp(SourceFile("docs/reference/scenarios.md"));
  const std::string begin = "tests/rocky7/sim/rocky7_keys_test.cc -->\n";
  const std::size_t from = page.find(begin), to = page.find("<!-- end of keys of rocky7");
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  Rocky7Keys values;
  EXPECT_EQ(page.substr(from + begin.size(), to - from - begin.size()),
            KeyTable(DocumentKeys([&](Keys& keys) { VisitRocky7Keys(keys, values); })));
}

TEST(Rocky7Scenario, ChecksWhatItNames) {
  const System system = Rocky7System({});
  EXPECT_THAT(system.check(SampleScenario()),
              HasSubstr("rocky7 from 1.5 m to a stone of 40 mm on compact_gravel"));
}

TEST(Rocky7Scenario, RefusesWhatItCannotSimulate) {
  const System system = Rocky7System({});
  const auto error = [&](const std::function<void(Scenario&)>& spoil) {
    Scenario scenario = SampleScenario();
    spoil(scenario);
    return ErrorOf([&] { system.make_ready(scenario); });
  };
  EXPECT_THAT(error([](Scenario& s) { s.yard.cell_m = 0.02; }),
              HasSubstr("test.yaml:6:3: expected yard.cell_m of at most 0.01 m"));
  EXPECT_THAT(error([](Scenario& s) { s.start.SetInFile("heading_deg", 120.0); }),
              HasSubstr("test.yaml:5:3: start: expected a start from where the front cameras see"));
  const auto set_step = [](Scenario& s) {
    s.physics_step_s = 0.0021;
    s.step_place = "test.yaml:7:17: physics_step_s";
  };
  EXPECT_THAT(error(set_step),
              HasSubstr("test.yaml:7:17: physics_step_s: expected at most 0.002 s"));
  EXPECT_THAT(error([](Scenario& s) { s.soil_file.clear(); }), HasSubstr("a soil's file"));
  EXPECT_THAT(error([](Scenario& s) { s.image_width = 320; }), HasSubstr("cameras.width_px"));
  const auto rounded_with_rim = [](Scenario& s) {
    s.of_system = ParseYaml("{task: place, boulder: rounded, rim_m: 0.1}", "test.yaml");
  };
  EXPECT_THAT(error(rounded_with_rim), HasSubstr("which has no edge"));
  const auto face_of_a_summit = [](Scenario& s) {
    s.of_system = ParseYaml("{task: place, face_up_deg: 85}", "test.yaml");
  };
  EXPECT_THAT(error(face_of_a_summit), HasSubstr(">= 0 and <= 80"));
}

TEST(Rocky7Robot, NeedsFixedWheelsAndRockers) {
  const System system = Rocky7System({});
  EXPECT_FALSE(system.files.check(SourceFile("models/rovers/rocky7.yaml")));
  EXPECT_THAT(system.files.check(SourceFile("models/rocky7/rocky7.yaml"))->summary,
              HasSubstr("front pair of 0.1 m"));
}

}  // namespace
}  // namespace dockyard::rocky7
