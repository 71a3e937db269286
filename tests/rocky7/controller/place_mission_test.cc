#include "controller/rocky7/place_mission.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "controller/rocky7/dockyard.h"
#include "rocky7/controller/ideal_rover.h"

namespace dockyard::rocky7 {
namespace {

// Up to 15 minutes; says what it does when the variable PLACE_TRACE is set.
Verdict Drive(
    IdealRover& rover, Controller& controller,
    const std::function<void(const Belief&)>& watch = [](const Belief&) {}) {
  std::string last;
  while (rover.tick < 900000) {
    const Commands commands = controller.Step(rover.Frame());
    const Belief& belief = controller.belief();
    const std::string now = belief.phase + ": " + belief.note;
    if (std::getenv("PLACE_TRACE") != nullptr && now != last) {
      std::printf("%6.1f s  %.3f %.3f %.1f  %s off %.2f\n", 1e-3 * static_cast<double>(rover.tick),
                  rover.X_WR.x, rover.X_WR.y, Degrees(rover.X_WR.heading), now.c_str(),
                  ValueOf(belief, "tool_off_deg", 0.0));
    }
    last = now;
    watch(belief);
    if (commands.verdict != Verdict::kUnderWay) return commands.verdict;
    rover.Turn(commands);
  }
  return Verdict::kUnderWay;
}

IdealRover BeforeAFace(double x_m) {
  IdealRover rover;
  rover.nominal.task = Task::kPlace;
  rover.scene.p_W = {x_m, 0.4, 0.4};
  rover.scene.normal_W = NormalOf(25.0, 20.0);
  rover.Click();
  return rover;
}

TEST(PlaceMission, PlacesTheInstrumentOnAFaceFromFiveMetres) {
  IdealRover rover = BeforeAFace(5.5);
  const auto controller = MakeDockyardController(rover.nominal);
  EXPECT_EQ(Drive(rover, *controller), Verdict::kDone) << controller->belief().note;
  const Eigen::Vector3d off = rover.touched_W - rover.scene.p_W;
  const double off_rad = AngleBetween(rover.tool_W, -rover.scene.normal_W);
  std::printf("off by %.1f mm, %.1f deg, %.1f N, %.0f looks\n", 1e3 * off.norm(), Degrees(off_rad),
              rover.most_n, ValueOf(controller->belief(), "looks", 0.0));
  EXPECT_LT(off.norm(), 0.012);
  EXPECT_LT(Degrees(off_rad), 3.0);
  EXPECT_LT(rover.most_n, 10.0);
  EXPECT_GT(rover.nearest_wheel_m, 0.05);
}

// Forty of a hundred metres that the wheels turn are lost; the images teach that.
TEST(PlaceMission, OnLooseSoilTheRoverDrivesAsFarAsItPlans) {
  IdealRover rover = BeforeAFace(5.5);
  rover.slip = 0.4;
  const auto controller = MakeDockyardController(rover.nominal);
  std::vector<double> shares;  // of the planned length, of each drive
  Pose2 X_WR_start;
  double planned_m = 0.0;
  Drive(rover, *controller, [&](const Belief& belief) {
    const bool drives = belief.phase == "drive";
    if (drives && planned_m == 0.0) {
      X_WR_start = rover.X_WR;
      for (const auto& arc : belief.plan) planned_m += arc.length_m;
    }
    if (drives || planned_m == 0.0) return;
    const Pose2 moved = Inverse(X_WR_start) * rover.X_WR;
    if (planned_m > 0.25) shares.push_back(std::hypot(moved.x, moved.y) / planned_m);
    planned_m = 0.0;
  });
  ASSERT_GE(shares.size(), 5u);
  // As the slip is taken at first: a tenth.
  EXPECT_NEAR(shares.front(), 0.6 / 0.9, 0.02);
  EXPECT_NEAR(shares.back(), 1.0, 0.06);
}

// "Within one meter" it plans two arcs, and places from where they end (N, IV-B).
TEST(PlaceMission, ThePapersSearchesNoMoreAfterItsTwoArcs) {
  IdealRover rover = BeforeAFace(2.8);
  const auto controller = MakeNesnas2000Placement(rover.nominal);
  std::vector<std::string> phases;
  std::size_t planned = 0;
  Drive(rover, *controller, [&](const Belief& belief) {
    if (phases.empty() || phases.back() != belief.phase) phases.push_back(belief.phase);
    planned = std::max(planned, belief.plan.size());
  });
  EXPECT_EQ(planned, 2u);
  const auto unfold = std::ranges::find(phases, "unfold");
  ASSERT_NE(unfold, phases.end()) << controller->belief().note;
  EXPECT_EQ(*std::prev(unfold), "there");
}

// The user has clicked in a picture from where the cameras stand: another place would show the
// target at another pixel.
TEST(PlaceMission, TheMastStaysBrakedUntilItsFirstPicture) {
  IdealRover rover = BeforeAFace(5.5);
  const auto controller = MakeDockyardController(rover.nominal);
  bool asked = false, moved = false;
  while (!moved && rover.tick < 60000) {
    const Commands commands = controller->Step(rover.Frame());
    asked = asked || !commands.take_images.empty();
    for (const MotorCommand& motor : commands.motors) {
      moved = moved || motor.mode != MotorMode::kBrake;
    }
    ASSERT_TRUE(asked || !moved);
    rover.Turn(commands);
  }
  EXPECT_TRUE(asked);
  EXPECT_TRUE(moved);
}

TEST(PlaceMission, GivesUpWhenTheMastsCamerasDoNotAnswer) {
  IdealRover rover;
  rover.nominal.task = Task::kPlace;
  const auto controller = MakeDockyardController(rover.nominal);
  int asks = 0;
  Verdict verdict = Verdict::kUnderWay;
  while (verdict == Verdict::kUnderWay && rover.tick < 60000) {
    const Commands commands = controller->Step(rover.Frame());
    asks += !commands.take_images.empty();
    verdict = commands.verdict;
    rover.Turn(commands);
    rover.asked.clear();
  }
  EXPECT_EQ(verdict, Verdict::kGivenUp);
  EXPECT_EQ(asks, 5);
}

TEST(PlaceMission, SaysThatNothingIsSeenWhereTheUserClicked) {
  IdealRover rover;
  rover.nominal.task = Task::kPlace;
  rover.nominal.target_px = {320.0, 5.0};  // the sky
  const auto controller = MakeDockyardController(rover.nominal);
  EXPECT_EQ(Drive(rover, *controller), Verdict::kGivenUp);
}

// A mast of 40 kg: the rover tips before the instrument reaches the face.
TEST(PlaceMission, GivesUpWhereTheMastWouldTipTheRover) {
  IdealRover rover;
  rover.nominal.task = Task::kPlace;
  rover.nominal.masses = {.rover_kg = 12.0, .p_RC = {0.17, 0.0, 0.06}};
  rover.nominal.masses.link2_kg = 40.0;
  rover.nominal.masses.link2_middle_m = 0.25;
  rover.scene.p_W = {2.8, 0.4, 0.4};
  rover.scene.normal_W = NormalOf(25.0, 20.0);
  rover.Click();
  const auto controller = MakeDockyardController(rover.nominal);
  Verdict verdict = Verdict::kUnderWay;
  while (verdict == Verdict::kUnderWay && rover.tick < 2000000) {
    const Commands commands = controller->Step(rover.Frame());
    verdict = commands.verdict;
    rover.Turn(commands);
  }
  EXPECT_EQ(verdict, Verdict::kGivenUp);
  EXPECT_EQ(controller->belief().note, "the rover would tip with its mast out");
  EXPECT_EQ(rover.most_n, 0.0);
}

}  // namespace
}  // namespace dockyard::rocky7
