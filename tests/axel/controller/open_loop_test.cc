#include "controller/axel/open_loop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/tether_length.h"
#include "controller/axel/tsai2013_plan.h"

namespace dockyard::axel {
namespace {

constexpr OpenLoopOptions kOptions{.speed_m_s = 0.03, .wheel_accel_rad_s2 = 0.1};

TEST(ArcMoves, TurnTheWheelsByTheArcsOfTheirTracks) {
  const Nominal nominal = TestNominal();
  const ArcMoves moves = MovesOf(nominal, kOptions, {1.2, 0.5}, 0.3);
  // Radius 2.4 m; the wheels run on circles half a track further in and out.
  EXPECT_NEAR(moves.left_rad * nominal.wheel_radius_m, 0.5 * (2.4 - 0.5 * nominal.track_m), 1e-12);
  EXPECT_NEAR(moves.right_rad * nominal.wheel_radius_m, 0.5 * (2.4 + 0.5 * nominal.track_m), 1e-12);
  EXPECT_NEAR(moves.spool_rad * nominal.drum_radius_m, 0.3, 1e-12);
}

// Area under a trapezoid: v (T - v / a); under a triangle: a T^2 / 4.
TEST(ArcMoves, LastAsLongAsTheFasterWheelsTrapezoid) {
  const Nominal nominal = TestNominal();
  const double v = kOptions.speed_m_s / nominal.wheel_radius_m, a = kOptions.wheel_accel_rad_s2;
  const ArcMoves far = MovesOf(nominal, kOptions, {1.2, 0.5}, 0.3);
  EXPECT_NEAR(v * (far.seconds - v / a), far.right_rad, 1e-12);
  const ArcMoves near = MovesOf(nominal, kOptions, {0.01, 0.0}, 0.0);
  EXPECT_LT(near.right_rad, v * v / a);
  EXPECT_NEAR(0.25 * a * near.seconds * near.seconds, near.right_rad, 1e-12);
}

TEST(OpenLoopArcs, CommandWheelsAndSpoolToBeginAndEndTogether) {
  const Nominal nominal = TestNominal();
  OpenLoopArcs arcs(nominal, kOptions, {{1.2, 0.5}}, {0.3});
  SensorFrame frame;
  frame.motors.resize(kMotorCount);
  Commands commands = BrakedCommands();
  EXPECT_FALSE(arcs.Drive(frame, &commands));
  const auto TimeOf = [&](Motor motor) {
    const MotorCommand& move = commands.motors[static_cast<std::size_t>(motor)];
    EXPECT_EQ(move.mode, MotorMode::kPosition);
    return std::abs(move.target) / move.speed_limit_rad_s +
           move.speed_limit_rad_s / move.accel_rad_s2;
  };
  const double seconds = MovesOf(nominal, kOptions, {1.2, 0.5}, 0.3).seconds;
  for (const Motor motor : {Motor::kLeftWheel, Motor::kRightWheel, Motor::kSpool}) {
    EXPECT_NEAR(TimeOf(motor), seconds, 1e-9);
  }
}

TEST(OpenLoopArcs, EndLateButEndWhereAWheelIsHeldBack) {
  const Nominal nominal = TestNominal();
  OpenLoopArcs arcs(nominal, kOptions, {{0.3, 0.0}}, {0.3});
  SensorFrame frame;
  frame.motors.resize(kMotorCount);  // no encoder ever counts
  Commands commands = BrakedCommands();
  const double seconds = MovesOf(nominal, kOptions, {0.3, 0.0}, 0.3).seconds;
  while (!arcs.Drive(frame, &commands)) frame.tick += kControlPeriod;
  EXPECT_NEAR(frame.tick * kTickSeconds, kOptions.patience * seconds + 1.0, 0.05);
}

// Eq. (1) at both ends of an arc: straight ahead it is the way itself.
TEST(TetherShortening, IsTheWayStraightTowardsTheStation) {
  const Pose2 start = FromDockingCoords({4.0, 0.0, 0.0});
  EXPECT_NEAR(TetherShortening(1.0, start, {{1.5, 0.0}})[0], 1.5, 1e-12);
}

TEST(TetherShortening, SumsToTheChangeOfTheCosineLaw) {
  const Pose2 start = FromDockingCoords({4.0, Radians(20.0), Radians(10.0)});
  const std::vector<Arc> arcs{{1.0, -0.4}, {0.8, 0.3}};
  const auto shorten = TetherShortening(1.0, start, arcs);
  const Pose2 end = Advance(start, arcs);
  EXPECT_NEAR(
      shorten[0] + shorten[1],
      CosineLawTether(1.0, ToDockingCoords(start)) - CosineLawTether(1.0, ToDockingCoords(end)),
      1e-12);
}

}  // namespace
}  // namespace dockyard::axel
