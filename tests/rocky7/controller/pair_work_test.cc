// The time of a slow processor for an image pair.
#include "controller/rocky7/pair_work.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/rocky7/dockyard.h"
#include "rocky7/controller/ideal_rover.h"

namespace dockyard::rocky7 {
namespace {

SensorFrame FrameAt(Tick tick) {
  SensorFrame frame;
  frame.tick = tick;
  frame.motors.resize(15);
  return frame;
}

TEST(PairWork, GivesTheFrameBackOnceItsTimeIsOver) {
  PairWork work(2.5);
  EXPECT_FALSE(work.Done(0));
  SensorFrame frame = FrameAt(100);
  frame.imu.yaw_rad = 0.25;
  work.Begin(frame);
  EXPECT_TRUE(work.busy());
  EXPECT_FALSE(work.Done(2599));
  EXPECT_TRUE(work.busy());
  EXPECT_EQ(work.Done(2600).value().imu.yaw_rad, 0.25);
  EXPECT_FALSE(work.busy());
  EXPECT_FALSE(work.Done(9999));
}

TEST(PairWork, WithoutTimeTheFrameIsBackAtOnce) {
  PairWork work(0.0);
  work.Begin(FrameAt(40));
  EXPECT_TRUE(work.Done(40).has_value());
}

// Longer than the cameras' patience in all: 5 asks, 3 s each.
TEST(PairWork, TheRoverRestsWithoutAnotherPairUntilItKnowsWhatTheFirstShows) {
  for (const double compute_s : {0.0, 20.0}) {
    Nominal nominal = NominalRover();
    nominal.compute_s = compute_s;
    const auto controller = MakeDockyardController(nominal);
    EXPECT_FALSE(controller->Step(FrameAt(0)).take_images.empty());
    SensorFrame frame = FrameAt(kControlPeriod);
    const GrayImage blank{640, 480, std::vector<std::uint8_t>(640 * 480, 90)};
    frame.images = {{kFrontLeft, blank, 0}, {kFrontRight, blank, 0}};
    Commands commands = controller->Step(frame);
    while (commands.verdict == Verdict::kUnderWay && frame.tick < 60000) {
      EXPECT_TRUE(commands.take_images.empty());
      for (const MotorCommand& motor : commands.motors) {
        ASSERT_EQ(motor.mode, MotorMode::kBrake);
      }
      frame = FrameAt(frame.tick + kControlPeriod);
      commands = controller->Step(frame);
    }
    EXPECT_EQ(commands.verdict, Verdict::kGivenUp);
    const Tick after = frame.tick - kControlPeriod;
    EXPECT_GE(after, std::llround(1e3 * compute_s));
    EXPECT_LT(after, std::llround(1e3 * compute_s) + kControlPeriod);
  }
}

struct Placed {
  Verdict verdict = Verdict::kUnderWay;
  Tick tick = 0;
  double pairs = 0.0;
  Pose2 X_WR;
};

Placed PlaceWith(double compute_s) {
  IdealRover rover;
  rover.nominal.task = Task::kPlace;
  rover.nominal.compute_s = compute_s;
  rover.scene.p_W = {2.8, 0.4, 0.4};
  rover.scene.normal_W = NormalOf(25.0, 20.0);
  rover.Click();
  const auto controller = MakeDockyardController(rover.nominal);
  Placed placed;
  while (placed.verdict == Verdict::kUnderWay && rover.tick < 2000000) {
    const Commands commands = controller->Step(rover.Frame());
    placed.verdict = commands.verdict;
    rover.Turn(commands);
  }
  placed.tick = rover.tick;
  placed.pairs = ValueOf(controller->belief(), "looks", 0.0);
  placed.X_WR = rover.X_WR;
  return placed;
}

// A multiple of the control period, so that nothing is rounded.
TEST(PairWork, APlacementGoesAsItDoesWithoutAndTakesItsTimeForEachPairLonger) {
  const double compute_s = 400.0 * kControlPeriod * kTickSeconds;
  const Placed fast = PlaceWith(0.0), slow = PlaceWith(compute_s);
  EXPECT_EQ(fast.verdict, Verdict::kDone);
  EXPECT_EQ(slow.verdict, Verdict::kDone);
  EXPECT_GE(fast.pairs, 4.0);
  EXPECT_EQ(slow.pairs, fast.pairs);
  EXPECT_EQ(slow.tick - fast.tick,
            static_cast<Tick>(fast.pairs) * std::llround(compute_s / kTickSeconds));
  EXPECT_EQ(slow.X_WR.x, fast.X_WR.x);
  EXPECT_EQ(slow.X_WR.heading, fast.X_WR.heading);
}

}  // namespace
}  // namespace dockyard::rocky7
