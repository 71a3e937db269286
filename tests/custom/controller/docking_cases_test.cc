#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "custom/controller/kinematic_world.h"
#include "custom/controller/test_robot.h"

namespace dockyard::custom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(DockingCases, GivesUpWhereTheDockStopsTheRobotBeforeItsContact) {
  for (const bool stalls : {false, true}) {
    KinematicWorld world;
    world.stop_m = -0.03;
    world.stalls = stalls;
    const KinematicRun run = RunKinematic(NominalOf(), world);
    EXPECT_EQ(run.verdict, Verdict::kGivenUp);
    EXPECT_LT(run.time_s, 150.0);
    EXPECT_THAT(run.belief.note, HasSubstr("after 3 retries"));
  }
}

TEST(DockingCases, KeepsSpeedsAndAccelerationsOfTheOptions) {
  const Nominal nominal = NominalOf();
  const KinematicRun run = RunKinematic(nominal, {});
  EXPECT_EQ(run.verdict, Verdict::kDone);
  Twist last{};
  for (const Twist& twist : run.twists) {
    EXPECT_LE(std::abs(twist.speed_m_s), nominal.docking.most_m_s + 1e-9);
    EXPECT_LE(std::abs(twist.turn_rad_s), nominal.docking.most_rad_s + 1e-9);
    EXPECT_LE(std::abs(twist.speed_m_s - last.speed_m_s), nominal.docking.accel_m_s2 * 0.02 + 1e-9);
    last = twist;
  }
}

TEST(DockingCases, TouchesAtThePressingSpeed) {
  const KinematicRun run = RunKinematic(NominalOf(), {});
  ASSERT_EQ(run.verdict, Verdict::kDone);
  // Since the robot last drove it was slower and slower.
  double last = 0.0;
  for (const Twist& twist : run.twists) {
    if (twist.speed_m_s > 0.0) last = twist.speed_m_s;
  }
  EXPECT_LT(last, 0.05);
}

TEST(DockingCases, SearchesForADockBehindTheRobot) {
  KinematicWorld world;
  world.X_DR_start = {1.5, 0.2, 0.1};
  const KinematicRun run = RunKinematic(NominalOf(), world);
  EXPECT_EQ(run.verdict, Verdict::kDone);
  EXPECT_THAT(run.phases, Contains("search"));
}

TEST(DockingCases, GivesUpInTimeWhereSightingsAreTooRare) {
  KinematicWorld world;
  world.marks_show = [](double time_s, double) { return std::fmod(time_s, 6.0) < 0.1; };
  const KinematicRun run = RunKinematic(NominalOf(), world);
  EXPECT_EQ(run.verdict, Verdict::kGivenUp);
  EXPECT_LT(run.time_s, 120.0);
  EXPECT_FALSE(run.belief.note.empty());
}

TEST(DockingCases, GivesUpInTimeWithAReasonWithoutADock) {
  KinematicWorld world;
  world.farthest_m = 0.0;
  const KinematicRun run = RunKinematic(NominalOf(), world);
  EXPECT_EQ(run.verdict, Verdict::kGivenUp);
  EXPECT_LT(run.time_s, 60.0);
  EXPECT_THAT(run.belief.note, HasSubstr("no dock detected"));
}

TEST(DockingCases, GivesUpInTimeWithAReasonWhereNoCameraAnswers) {
  KinematicWorld world;
  world.camera_answers = false;
  const KinematicRun run = RunKinematic(NominalOf(), world);
  EXPECT_EQ(run.verdict, Verdict::kGivenUp);
  EXPECT_LT(run.time_s, 10.0);
  EXPECT_THAT(run.belief.note, HasSubstr("no camera gives an image"));
}

TEST(DockingCases, TriesAgainWhereMarksAreLostOnTheApproachAndComeBack) {
  Nominal nominal = NominalOf();
  nominal.docking.most_m_s = 0.12;  // so that it notices before it is there
  KinematicWorld world;
  world.marks_show = [lost_s = 0.0](double time_s, double range_m) mutable {
    if (lost_s == 0.0 && range_m < 0.85) lost_s = time_s;
    return lost_s == 0.0 || time_s > lost_s + 8.0;
  };
  const KinematicRun run = RunKinematic(nominal, world);
  EXPECT_EQ(run.verdict, Verdict::kDone) << run.belief.note;
  EXPECT_THAT(run.phases, Contains("back_off"));
  EXPECT_EQ(ValueOf(run.belief, "retries", 0.0), 1.0);
}

TEST(DockingCases, GivesUpInTimeWhereMarksAreLostForGood) {
  Nominal nominal = NominalOf();
  nominal.docking.most_m_s = 0.12;
  KinematicWorld world;
  world.marks_show = [lost = false](double, double range_m) mutable {
    lost = lost || range_m < 0.85;
    return !lost;
  };
  const KinematicRun run = RunKinematic(nominal, world);
  EXPECT_EQ(run.verdict, Verdict::kGivenUp);
  EXPECT_LT(run.time_s, 120.0);
  EXPECT_THAT(run.belief.note, HasSubstr("no dock detected"));
}

TEST(DockingCases, ReturnsToWhereItDetectedADockThatItNoLongerSees) {
  KinematicWorld world;
  world.X_DR_start = {2.0, 0.5, kPi};
  // Marks show until the robot is near, and again once it has been back.
  world.marks_show = [lost_s = 0.0, back = false](double time_s, double range_m) mutable {
    if (lost_s == 0.0 && range_m < 1.3) lost_s = time_s;
    back = back || (lost_s > 0.0 && time_s > lost_s + 10.0 && range_m > 1.25);
    return lost_s == 0.0 || back;
  };
  const KinematicRun run = RunKinematic(NominalOf(), world);
  EXPECT_EQ(run.verdict, Verdict::kDone) << run.belief.note;
  EXPECT_THAT(run.phases, Contains("search"));
  EXPECT_TRUE(run.closed);
}

TEST(DockingCases, DrivesTheLastPartByDeadReckoning) {
  KinematicWorld world;
  world.left_scale = world.right_scale = 1.02;
  world.latency_s = 0.12;
  world.marks_show = [](double, double range_m) { return range_m > 0.45; };
  const KinematicRun run = RunKinematic(NominalOf(), world);
  EXPECT_EQ(run.verdict, Verdict::kDone) << run.belief.note;
  EXPECT_TRUE(run.closed);
}

TEST(DockingCases, WigglesForAContactThatNeedsIt) {
  KinematicWorld world;
  world.wiggle_rad = 0.03;
  const KinematicRun run = RunKinematic(NominalOf(), world);
  EXPECT_EQ(run.verdict, Verdict::kDone) << run.belief.note;
  EXPECT_THAT(run.phases, Contains("wiggle"));
  EXPECT_TRUE(run.closed);
}

TEST(DockingCases, RetriesAsOftenAsAllowedAndClaimsNoOpenContact) {
  KinematicWorld world;
  world.contact_m = 0.0;  // it never closes
  const Nominal nominal = NominalOf();
  const KinematicRun run = RunKinematic(nominal, world);
  EXPECT_EQ(run.verdict, Verdict::kGivenUp);
  EXPECT_EQ(ValueOf(run.belief, "retries", 0.0), nominal.docking.retries);
  EXPECT_GE(std::count(run.phases.begin(), run.phases.end(), "back_off"), nominal.docking.retries);
  EXPECT_THAT(run.belief.note, HasSubstr("the contact stays open, after 3 retries"));
}

TEST(DockingCases, BacksOffBeforeItTouchesWhileItIsNotAlignedButNotForEver) {
  Nominal nominal = NominalOf();
  nominal.docking.aligned_m = 1e-6;
  const KinematicRun run = RunKinematic(nominal, {});
  EXPECT_EQ(run.verdict, Verdict::kDone) << run.belief.note;
  EXPECT_EQ(std::count(run.phases.begin(), run.phases.end(), "back_off"), 2);
  EXPECT_EQ(std::count(run.phases.begin(), run.phases.end(), "wait_for_charge"), 1);
  EXPECT_EQ(ValueOf(run.belief, "retries", 0.0), 0.0);
}

TEST(DockingCases, AimsToEitherSideWhereTheBoardIsOffItsDrawing) {
  for (const double board_aside_m : {-0.0105, 0.0105}) {
    int docked = 0, at_once = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      KinematicWorld world;
      world.seed = seed;
      world.board_aside_m = board_aside_m;  // the contact closes within 8 mm
      const KinematicRun run = RunKinematic(NominalOf(), world);
      docked += run.verdict == Verdict::kDone && run.closed;
      at_once += ValueOf(run.belief, "retries", 0.0) == 0.0;
    }
    EXPECT_GE(docked, 18) << board_aside_m;
    EXPECT_LE(at_once, 10) << board_aside_m;
  }
}

TEST(DockingCases, StaysWithoutACommandOnceDocked) {
  const KinematicRun run = RunKinematic(NominalOf(), {});
  EXPECT_EQ(run.phases.back(), "docked");
  EXPECT_THAT(run.phases, Not(Contains("back_off")));
}

}  // namespace
}  // namespace dockyard::custom
