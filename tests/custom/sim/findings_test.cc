// What a check finds in robots and docks that can never dock, or that are odd.
#include "sim/custom/docked_findings.h"

#include <gmock/gmock.h>

#include <utility>

#include "custom/charger_rig.h"
#include "custom/wheeled_kinds.h"
#include "models/read/config_error.h"
#include "sim/base/files.h"
#include "support/bad_files.h"

namespace dockyard::custom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

using Changes = std::vector<std::pair<std::string, std::string>>;  // of a text: old, new

std::string Changed(const std::string& file, const Changes& changes) {
  std::string text = *ReadWhole(file);
  for (const auto& [old, now] : changes) text = Replaced(text, old, now);
  return text;
}

/// The charger's robot and dock with other texts in their files.
class Charger {
 public:
  explicit Charger(const Changes& dock_urdf = {}, const Changes& dock = {},
                   const Changes& robot = {}) {
    folder_.Write("dock.urdf", Changed(ChargerFile("dock/dock.urdf"), dock_urdf));
    folder_.Write("tag.yaml", *ReadWhole(ChargerFile("dock/tag.yaml")));
    folder_.Write("robot.urdf", *ReadWhole(ChargerFile("robot/robot.urdf")));
    dock_ = folder_.Write("dock.yaml", Changed(ChargerFile("dock/dock.yaml"), dock));
    robot_ = folder_.Write("robot.yaml", Changed(ChargerFile("robot/robot.yaml"), robot));
  }

  Findings InDock() const { return FindInDock(LoadDock(dock_), dock_); }
  Findings InRobot() const { return FindInRobot(LoadRobot(robot_), robot_); }
  /// The message; empty: it is not refused.
  std::string Refusal(std::vector<std::string> overrides = {}) const {
    try {
      LoadModels(Scenery(std::move(overrides)));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  std::vector<std::string> Doubts() const { return CustomSystem({}).doubts(Scenery({})); }
  const std::string& dock() const { return dock_; }

 private:
  Scenario Scenery(std::vector<std::string> overrides) const {
    overrides.insert(overrides.end(), {"robot=" + robot_, "dock=" + dock_});
    return ChargerScenario(overrides);
  }

  ScratchFolder folder_;
  std::string robot_, dock_;
};

Changes SeatAt(const std::string& xyz) { return {{"0.004 0 0.065", xyz}}; }
Changes TagAt(const std::string& middle) { return {{"[-0.055, 0, 0.20]", middle}}; }

TEST(CustomFindings, AreNoneInTheExample) {
  const Charger charger;
  EXPECT_EQ(charger.Refusal(), "");
  EXPECT_THAT(charger.Doubts(), IsEmpty());
}

// The front plate's face lies on the seat, and the dock's box ends at x = 0.
TEST(CustomFindings, NameWhatOverlapsWhereTheRobotIsDocked) {
  EXPECT_THAT(Charger(SeatAt("-0.020 0 0.065")).Refusal(),
              AllOf(HasSubstr("judge.docked.pose: expected robot and dock apart where 'contacts' "
                              "lies on 'seat', found 'base_link' (plate) of the robot 20.0 mm in "
                              "'dock' (box) of the dock"),
                    HasSubstr("nowhere in the judge's box is it less than 16.0 mm")));
}

// 2 mm are more than 80 N press in, but the judge lets the robot stay 4 mm out.
TEST(CustomFindings, OfAnOverlapThatTheJudgesBoxAvoidsAreDoubts) {
  const Charger charger(SeatAt("-0.002 0 0.065"));
  EXPECT_EQ(charger.Refusal(), "");
  EXPECT_THAT(
      charger.Doubts(),
      ElementsAre(AllOf(HasSubstr("2.0 mm in 'dock' (box)"), HasSubstr("contacts yield by 0.8 mm"),
                        HasSubstr("the robot docks elsewhere in the judge's box")),
                  HasSubstr("'plus'"), HasSubstr("'minus'")));
}

TEST(CustomFindings, OfPinsThatMissTheirPadsAreDoubts) {
  // Pads of 16 mm, and tips 6 mm out of the box.
  EXPECT_THAT(
      Charger(SeatAt("0.004 0.010 0.065")).Doubts(),
      ElementsAre(AllOf(HasSubstr("the pin 'plus' of 'charge'"), HasSubstr("found it off its pad")),
                  HasSubstr("the pin 'minus' of 'charge'")));
  EXPECT_THAT(Charger(SeatAt("0.020 0 0.065")).Doubts(),
              ElementsAre(HasSubstr("found it 14.0 mm before what it is to press on"),
                          HasSubstr("14.0 mm")));
  EXPECT_THAT(
      Charger(SeatAt("0.001 0 0.065")).Doubts(),
      ElementsAre(HasSubstr("pressed in by more than its stroke of 4.0 mm"), HasSubstr("stroke")));
}

// The mast's front is at x = -0.061.
TEST(CustomFindings, OfABoardBehindItsPlateAreFaults) {
  const Charger behind({}, TagAt("[-0.063, 0, 0.20]"));
  const Findings findings = behind.InDock();
  ASSERT_EQ(findings.faults.size(), 1u);
  EXPECT_THAT(findings.faults[0],
              AllOf(StartsWith(behind.dock() + ":7:"),
                    HasSubstr("boards[0].middle_m: expected the board 'tag' before the dock's "
                              "parts, found all of its marks hidden by 'dock', 2.0 mm before it")));
  EXPECT_EQ(behind.Refusal(), findings.faults[0]);
  EXPECT_THAT(Charger({}, TagAt("[-0.0605, 0, 0.20]")).InDock().faults, IsEmpty());
}

// The box ends 110 mm over the floor, 55 mm before the tag.
TEST(CustomFindings, OfABoardWithSomeMarksHiddenAreDoubts) {
  const Findings findings = Charger({}, TagAt("[-0.055, 0, 0.13]")).InDock();
  EXPECT_THAT(findings.faults, IsEmpty());
  EXPECT_THAT(
      findings.doubts,
      ElementsAre(HasSubstr("found some of its marks hidden by 'dock', 55.0 mm before it")));
}

TEST(CustomFindings, OfAPinInItsOwnWallAreFaults) {
  EXPECT_THAT(Charger({}, {{"[0.006, -0.022, 0.065]", "[-0.002, -0.022, 0.065]"}}).InDock().faults,
              ElementsAre(HasSubstr("contact_pins[0].tip_m: expected a tip outside 'dock', "
                                    "found it covered: the wall ends 2.0 mm before it")));
}

TEST(CustomFindings, OfAPadOffItsSurfaceAreFaults) {
  const auto with_pad_at = [](const std::string& x) {
    return Charger({}, {}, {{"[0, 0.022, 0]", "[" + x + ", 0.022, 0]"}}).InRobot().faults;
  };
  EXPECT_THAT(with_pad_at("-0.001"), IsEmpty());
  EXPECT_THAT(with_pad_at("-0.003"),
              ElementsAre(AllOf(HasSubstr("contact_pads[0].middle_m"),
                                HasSubstr("found it 3.0 mm deep in it: pins do not reach it"))));
  EXPECT_THAT(with_pad_at("0.003"),
              ElementsAre(HasSubstr("found it 3.0 mm before it: pins go through")));
}

TEST(CustomFindings, OfAStagingPoseOutsideTheYardAreFaults) {
  EXPECT_THAT(Charger().Refusal({"graceful.staging_m=4"}),
              HasSubstr("graceful.staging_m: expected a staging pose inside the yard (x up to 3.50 "
                        "m, y up to +-2.00 m), found it at x = 4.18 m, y = 0.00 m"));
  EXPECT_EQ(Charger().Refusal({"graceful.staging_m=3"}), "");
}

Findings InWheels(const RobotText& text) {
  const ScratchFolder folder;
  folder.Write("robot.urdf", text.urdf);
  const std::string file = folder.Write("robot.yaml", text.yaml);
  return FindHangingWheels(LoadRobot(file), file);
}

RobotText With(RobotText text, const std::string& old, const std::string& now) {
  text.urdf = Replaced(text.urdf, old, now);
  return text;
}

TEST(CustomFindings, AreNoneOfWheelsOnLevelGround) {
  for (const auto kind :
       {TwoWheelsAndABall, TwoWheelsAndTwoCasters, FourFixedWheels, SixFixedWheels}) {
    const Findings findings = InWheels(kind());
    EXPECT_THAT(findings.faults, IsEmpty());
    EXPECT_THAT(findings.doubts, IsEmpty());
  }
}

TEST(CustomFindings, OfAWheelInTheAirAreDoubts) {
  const Findings findings = InWheels(With(SixFixedWheels(), "\"0 0.25 0\"", "\"0 0.25 0.012\""));
  EXPECT_THAT(findings.faults, IsEmpty());
  EXPECT_THAT(findings.doubts,
              ElementsAre(HasSubstr("wheels: expected 'mid_left' on level ground, found its tread "
                                    "12.0 mm above that")));
}

TEST(CustomFindings, OfARobotWhoseDrivenWheelsAllHangAreFaults) {
  RobotText text = With(SixFixedWheels(), "\"0 0.25 0\"", "\"0 0.25 0.012\"");
  text = With(text, "\"0 -0.25 0\"", "\"0 -0.25 0.012\"");
  text.yaml = RobotYaml({"mid_left", "mid_right"},
                        "  - links: [front_left, rear_left, front_right, rear_right]\n");
  EXPECT_THAT(InWheels(text).faults,
              ElementsAre(HasSubstr("'mid_left'"), HasSubstr("'mid_right'")));
}

// The ball is 80 mm behind the axle and 10 mm higher than it should be.
TEST(CustomFindings, OfARobotThatRestsTiltedAreDoubts) {
  EXPECT_THAT(InWheels(With(TwoWheelsAndABall(), "-0.08 0 -0.023", "-0.08 0 -0.013")).doubts,
              ElementsAre(HasSubstr("found the robot tilted by 7.1 deg")));
}

// Axle and ball are before the robot's weight.
TEST(CustomFindings, OfARobotWhoseWeightIsNotBetweenItsWheelsAreDoubts) {
  RobotText text = With(TwoWheelsAndABall(), "-0.08 0 -0.023", "0.08 0 -0.023");
  text = With(With(text, "\"0 0.08 0\"", "\"0.02 0.08 0\""), "\"0 -0.08 0\"", "\"0.02 -0.08 0\"");
  EXPECT_THAT(InWheels(text).doubts, ElementsAre(HasSubstr("it tips onto its body")));
}

}  // namespace
}  // namespace dockyard::custom
