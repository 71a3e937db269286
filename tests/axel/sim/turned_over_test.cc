// Dockings that begin with the arm behind or the body upside down, in closed loop.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "axel/sim/scenarios.h"
#include "support/bad_files.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

struct Start {
  const char* name;
  std::vector<std::string> keys;
};
const Start kStarts[] = {
    {"trailing", {"axel.start.arm=trailing"}},
    {"upside down", {"axel.start.body_pitch_deg=180"}},
    {"trailing, upside down", {"axel.start={arm: trailing, body_pitch_deg: 180}"}},
};

class TurnedOver : public testing::TestWithParam<std::string> {};

TEST_P(TurnedOver, RoverRightsItselfAndDocks) {
  for (const Start& start : kStarts) {
    std::vector<std::string> keys{"start.r_m=2.5", "start.alpha_deg=5", GetParam()};
    keys.insert(keys.end(), start.keys.begin(), start.keys.end());
    const RunRecord record = SimulateTypical(keys);
    EXPECT_TRUE(record.result.success)
        << start.name << ": " << record.result.outcome << ", " << record.failure_note;
    EXPECT_EQ(MeasureOf(record, "rightings"), 1.0) << start.name;
    EXPECT_EQ(MeasureOf(record, "flips"), 0.0) << start.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Soils, TurnedOver,
                         testing::Values("soil=" + SourceFile("models/soils/loose_sand.yaml"),
                                         "soil=" + SourceFile("models/soils/compact_gravel.yaml")));

// A script drives over a slack tether until the arm has gone over the top.
TEST(TurnedOverByScript, FlipIsCountedAndNamesTheRun) {
  const RunRecord record =
      SimulateTypical({"soil=" + SourceFile("models/soils/loose_sand.yaml"), "start.alpha_deg=0",
                       "script=[{for_s: 20, reel_m_s: -0.1}, {for_s: 25, speed_m_s: 0.05}]"});
  EXPECT_EQ(record.result.outcome, "tipped_over");
  EXPECT_EQ(MeasureOf(record, "flips"), 1.0);
  EXPECT_GT(MeasureOf(record, "arm_up_peak_deg"), 88.0);
}

TEST(TurnedOverByScript, ArmTurnsTheBodyAndIsTold) {
  const RunRecord record =
      SimulateTypical({"axel.start.arm=trailing",
                       "script=[{for_s: 25, free_wheels: true, arm_deg: 0, arm_deg_s: 10}]"});
  const auto& channels = record.channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const double end = record.history.back().channels[i];
    if (channels[i].name == "arm_deg") {
      EXPECT_NEAR(end, 0.0, 0.5);
    }
    // Upside down but for the arm's tilt.
    if (channels[i].name == "pitch_deg") {
      EXPECT_NEAR(end, 164.0, 4.0);
    }
  }
}

TEST(TurnedOverStart, IsRefusedWhereItsAnglesContradict) {
  const ScratchFolder folder;
  EXPECT_THAT(
      MessageOf(
          [] { LoadModels(TypicalScenario({"axel.start={body_pitch_deg: 0, arm_deg: 10}"})); },
          folder),
      HasSubstr("axel.start.arm_deg: expected none beside body_pitch_deg"));
}

TEST(TurnedOverStart, IsRefusedForAnArmThatDoesNotReachTheGround) {
  const ScratchFolder folder;
  EXPECT_THAT(
      MessageOf([] { Build(TypicalScenario({"changes.robot.arm.offset_m=-0.8"})); }, folder),
      HasSubstr("arm.length_m: expected more than 0.25"));
}

TEST(TurnedOverStart, OneAngleGivesTheOther) {
  const BuiltRun by_arm = Build(TypicalScenario({"axel.start.arm_deg=-150"}));
  const BuiltRun level = Build(TypicalScenario());
  const double down = level.world.arm_start_rad;
  EXPECT_EQ(level.world.pitch_start_rad, 0.0);
  EXPECT_NEAR(by_arm.world.arm_start_rad, Radians(-150.0), 1e-12);
  EXPECT_NEAR(WrapPi(by_arm.world.arm_start_rad + by_arm.world.pitch_start_rad), down, 1e-12);
  EXPECT_NEAR(by_arm.nominal.arm_at_zero_rad, Radians(-150.0), 1e-12);
  const BuiltRun behind = Build(TypicalScenario({"axel.start.arm=trailing"}));
  EXPECT_NEAR(behind.world.arm_start_rad, kPi - down, 1e-12);
}

}  // namespace
}  // namespace dockyard::axel
