#include "controller/axel/drive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/leg.h"
#include "controller/axel/odometry.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"

namespace dockyard::axel {
namespace {

using testing::DoubleNear;

// Perfect wheels along a path from a start beside it.
Pose2 FollowToTheEnd(const std::vector<Arc>& arcs, Pose2 at) {
  PathFollower follower({}, arcs);
  for (int i = 0; i < 100'000 && !follower.done(); ++i) {
    const Twist twist = follower.Follow(at, 0.05, {.settle_m = 0.5, .max_turn_rad_s = 0.2});
    at = Advance(at, Arc{twist.speed_m_s * 0.02, twist.turn_rad_s * 0.02});
  }
  return at;
}

TEST(PathFollower, EndsWhereThePathEnds) {
  const std::vector<Arc> arcs{{1.2, 0.6}, {0.9, -0.9}};
  const Pose2 end = FollowToTheEnd(arcs, {});
  const Pose2 goal = Advance({}, arcs);
  EXPECT_LT(std::hypot(end.x - goal.x, end.y - goal.y), 0.02);
  EXPECT_THAT(end.heading, DoubleNear(goal.heading, 0.02));
}

TEST(PathFollower, SteersBackForwards) {
  const Pose2 end = FollowToTheEnd({{3.0, 0.0}}, {0.0, 0.1, 0.1});
  EXPECT_THAT(end.y, DoubleNear(0.0, 0.005));
}

TEST(PathFollower, SteersBackBackwards) {
  const Pose2 end = FollowToTheEnd({{-3.0, 0.0}}, {0.0, 0.1, 0.1});
  EXPECT_THAT(end.x, DoubleNear(-3.0, 0.01));
  EXPECT_THAT(end.y, DoubleNear(0.0, 0.005));
}

// Drives 3 m of a straight path while it drifts to its left by this share of the way; how far it is
// then beside the path.
double BesideAfterDrifting(double length_m, double drift, double told_drift) {
  PathFollower follower({}, {{length_m, 0.0}});
  Pose2 at{};
  for (int i = 0; i < 100'000 && !follower.done(); ++i) {
    const Twist twist =
        follower.Follow(at, 0.05, {.settle_m = 0.5, .max_turn_rad_s = 0.2}, told_drift);
    const double way_m = twist.speed_m_s * 0.02;
    at =
        Advance(at, Arc{way_m, twist.turn_rad_s * 0.02}) * Pose2{0.0, drift * std::abs(way_m), 0.0};
  }
  return at.y;
}

TEST(PathFollower, KeepsToThePathWhileItDriftsAsToldForwardsAndBackwards) {
  for (const double length_m : {3.0, -3.0}) {
    EXPECT_THAT(BesideAfterDrifting(length_m, 0.1, 0.1), DoubleNear(0.0, 0.005));
    // Untold, the heading that holds the drift costs an offset of 2 s d.
    const double untold_m = BesideAfterDrifting(length_m, 0.1, 0.0);
    EXPECT_THAT(untold_m, DoubleNear(2.0 * 0.5 * 0.1, 0.01));
  }
}

TEST(PathFollower, GoesForwardsThenBackwards) {
  const Pose2 end = FollowToTheEnd({{1.0, 0.5}, {-0.7, 0.3}}, {});
  const Pose2 goal = Advance({}, std::vector<Arc>{{1.0, 0.5}, {-0.7, 0.3}});
  EXPECT_LT(std::hypot(end.x - goal.x, end.y - goal.y), 0.03);
}

TEST(Wheels, TurnAgainstEachOtherByTheTrack) {
  const Nominal nominal = TestNominal();
  Commands commands = BrakedCommands();
  CommandWheels(nominal, {0.03, 0.1}, 0.3, &commands);
  EXPECT_THAT(commands.motors[0].target, DoubleNear((0.03 - 0.0425) / 0.3, 1e-12));
  EXPECT_THAT(commands.motors[1].target, DoubleNear((0.03 + 0.0425) / 0.3, 1e-12));
}

TEST(Wheels, KeepTheCurvatureAtTheSpeedLimit) {
  const Nominal nominal = TestNominal();
  Commands commands = BrakedCommands();
  CommandWheels(nominal, {1.0, 1.0}, 0.3, &commands);
  EXPECT_DOUBLE_EQ(commands.motors[1].target, 1.0);
  EXPECT_THAT(commands.motors[0].target, DoubleNear(0.575 / 1.425, 1e-12));
}

TEST(Spool, TensionAndCurrentAreInverse) {
  const Nominal nominal = TestNominal();
  // 50 N on a drum of 6 cm is 3 Nm: 0.3 A beyond the 0.2 A without load.
  EXPECT_DOUBLE_EQ(CurrentForTension(nominal, 50.0), 0.5);
  EXPECT_DOUBLE_EQ(TensionFromCurrent(nominal, 0.5), 50.0);
}

SensorFrame Frame(double left_rad, double right_rad, double pitch_rad, double yaw_rad) {
  SensorFrame frame = StillFrame();
  frame.motors[0].encoder_counts = std::llround(left_rad * 1e3);
  frame.motors[1].encoder_counts = std::llround(right_rad * 1e3);
  frame.imu.pitch_rad = pitch_rad;
  frame.imu.yaw_rad = yaw_rad;
  return frame;
}

Motion Read(Odometer* odometer, const SensorFrame& frame) {
  return odometer->Read(frame, GroundSlope{}, 0.0);
}

TEST(Odometer, RollsItsRadiusTimesTheAngle) {
  Odometer odometer(TestNominal());
  Read(&odometer, Frame(0, 0, 0, 0));
  const Motion motion = Read(&odometer, Frame(1.0, 2.0, 0, 0.3));
  EXPECT_THAT(motion.length_m, DoubleNear(0.45, 1e-12));
  EXPECT_THAT(motion.turn_rad, DoubleNear(0.3, 1e-12));
}

TEST(Odometer, MovesSidewaysByItsHeightTimesTheRoll) {
  const Nominal nominal = TestNominal();
  Odometer odometer(nominal);
  SensorFrame frame = StillFrame();
  odometer.Read(frame, {}, 0.0);
  frame.imu.roll_rad = 0.01;  // left side up: the axle moves to the right
  EXPECT_THAT(odometer.Read(frame, {}, 0.0).lean_m, DoubleNear(-0.003, 1e-9));
}

TEST(Odometer, StandsStillWhenOnlyTheBodyPitches) {
  Odometer odometer(TestNominal());
  Read(&odometer, Frame(0, 0, 0, 0));
  // Nose down by 0.4: the encoders see the wheels turn back against the body.
  EXPECT_THAT(Read(&odometer, Frame(-0.4, -0.4, 0.4, 0)).length_m, DoubleNear(0.0, 1e-12));
}

TEST(Odometer, CrossesTheHalfTurnOfYaw) {
  Odometer odometer(TestNominal());
  Read(&odometer, Frame(0, 0, 0, 3.1));
  EXPECT_THAT(Read(&odometer, Frame(0, 0, 0, -3.1)).turn_rad, DoubleNear(2 * kPi - 6.2, 1e-12));
}

TEST(Arm, IsLevelWhenItsAngleUndoesThePitch) {
  Nominal nominal = TestNominal();
  nominal.arm_at_zero_rad = 0.1;
  SensorFrame frame = StillFrame();
  frame.imu.pitch_rad = -0.3;
  frame.motors[2].encoder_counts = 2000;  // 0.2 rad further down
  Senses senses(nominal, AxelOptions{});
  senses.Update(frame);
  EXPECT_THAT(senses.elevation_rad(), DoubleNear(0.0, 1e-12));
}

// An arm that has gone round the axle is levelled where it is, not turned back.
TEST(Arm, IsLevelledInTheTurnInWhichItIs) {
  const Nominal nominal = TestNominal();
  for (const double turn_rad : {0.0, 2.0 * kPi, -4.0 * kPi}) {
    SensorFrame frame = StillFrame();
    frame.imu.pitch_rad = 0.2;
    frame.motors[2].encoder_counts =
        std::llround((0.1 + turn_rad) / nominal.motors[2].rad_per_count);
    const AxelOptions options;
    Senses senses(nominal, options);
    ArmLevel arm(nominal, options.arm);
    for (int i = 0; i < 100; ++i) {
      frame.tick += kControlPeriod;
      senses.Update(frame);
      arm.Level(senses);
    }
    // 2 s at the largest rate that the pitch asks for.
    const double rate = std::min(options.arm.level_gain_per_s * 0.2, options.arm.level_rate_rad_s);
    EXPECT_THAT(arm.Hold(senses).target, DoubleNear(turn_rad + 0.1 + 1.98 * rate, 2e-3))
        << turn_rad;
  }
}

// Commands of a leg of 1 m straight on. The rover stands 3 m before the tip's way to the mouth,
// which lies this far to the right of the arm, and its wheels turn it by slip_rad_s more than its
// gyro says.
Commands DrivenBeside(double aside_rad, double slip_rad_s) {
  const Nominal nominal = TestNominal();
  const AxelOptions options;
  Senses senses(nominal, options);
  SensorFrame frame = StillFrame();
  senses.Update(frame);
  const TetherGeometry geometry = TetherGeometryOf(nominal);
  const double heading = WrapPi(kPi + aside_rad);
  const Pose2 X_DR{geometry.p_DQ.x() + 3.0 - geometry.arm_m * std::cos(heading),
                   geometry.p_DQ.y() - geometry.arm_m * std::sin(heading), heading};
  const double dx = nominal.X_DB.p.x() - X_DR.x, dy = nominal.X_DB.p.y() - X_DR.y;
  senses.filter().Restart(
      {std::hypot(dx, dy), WrapPi(std::atan2(dy, dx) - heading), heading, {1e-6, 1e-6, 1e-6}});
  LegDriver leg(nominal, options, X_DR, {{1.0, 0.0}}, {}, 0);
  const double wheel_rad_s = 0.5 * slip_rad_s * nominal.track_m / nominal.wheel_radius_m;
  for (int i = 0; i < 500; ++i) {
    frame.tick += kControlPeriod;
    const double turned_rad = wheel_rad_s * kTickSeconds * static_cast<double>(frame.tick);
    frame.motors[0].encoder_counts = std::llround(-turned_rad / nominal.motors[0].rad_per_count);
    frame.motors[1].encoder_counts = std::llround(turned_rad / nominal.motors[1].rad_per_count);
    senses.Update(frame);
  }
  Commands commands = BrakedCommands();
  leg.Drive(&senses, &commands);
  return commands;
}

TEST(Leg, SpoolPullsLessTheFartherAsideTheTetherIs) {
  const Nominal nominal = TestNominal();
  const TetherOptions options;
  const auto tension_n = [&](double aside_rad) {
    const MotorCommand spool =
        DrivenBeside(aside_rad, 0.0).motors[static_cast<std::size_t>(Motor::kSpool)];
    return TensionFromCurrent(nominal, spool.current_limit_a) - nominal.spool_friction_n;
  };
  EXPECT_THAT(tension_n(0.0), DoubleNear(options.drive_tension_n, 1e-6));
  EXPECT_THAT(tension_n(Radians(60.0)), DoubleNear(options.aside_tension_n, 1e-6));
  EXPECT_THAT(tension_n(Radians(-60.0)), DoubleNear(options.aside_tension_n, 1e-6));
  const double half = 0.5 * (options.ahead_rad + options.aside_rad);
  const double mean_n = 0.5 * (options.drive_tension_n + options.aside_tension_n);
  EXPECT_THAT(tension_n(half), DoubleNear(mean_n, 0.5));
}

TEST(Leg, WheelsTurnByWhatSlipTakesWithinALimit) {
  const Nominal nominal = TestNominal();
  const auto turn_rad_s = [&](double slip_rad_s) {
    const Commands commands = DrivenBeside(0.0, slip_rad_s);
    return (commands.motors[1].target - commands.motors[0].target) * nominal.wheel_radius_m /
           nominal.track_m;
  };
  const double none = turn_rad_s(0.0);
  EXPECT_THAT(turn_rad_s(0.04) - none, DoubleNear(0.04, 0.002));
  EXPECT_THAT(turn_rad_s(-0.04) - none, DoubleNear(-0.04, 0.002));
  EXPECT_THAT(turn_rad_s(0.2) - none, DoubleNear(DriveOptions{}.yaw_slip_rad_s, 0.002));
}

// The rover does not turn, whatever its wheels do, as with its body on a rock.
TEST(Leg, BothWheelsTurnAlikeOnceOneSpins) {
  const Nominal nominal = TestNominal();
  const AxelOptions options;
  Senses senses(nominal, options);
  SensorFrame frame = StillFrame();
  senses.Update(frame);
  const Pose2 X_DR{3.0, 0.5, kPi};
  const double dx = nominal.X_DB.p.x() - X_DR.x, dy = nominal.X_DB.p.y() - X_DR.y;
  senses.filter().Restart({std::hypot(dx, dy),
                           WrapPi(std::atan2(dy, dx) - X_DR.heading),
                           X_DR.heading,
                           {1e-6, 1e-6, 1e-6}});
  LegDriver leg(nominal, options, X_DR, {{1.0, 0.0}}, {}, 0);
  const auto drive_s = [&](double seconds, double spin_rad_s) {
    Commands commands = BrakedCommands();
    const Tick end = frame.tick + static_cast<Tick>(seconds / kTickSeconds);
    while (frame.tick < end) {
      frame.tick += kControlPeriod;
      const double step_rad = spin_rad_s * kTickSeconds * static_cast<double>(kControlPeriod);
      frame.motors[0].encoder_counts += std::llround(step_rad / nominal.motors[0].rad_per_count);
      senses.Update(frame);
      commands = BrakedCommands();
      leg.Drive(&senses, &commands);
    }
    return commands.motors[0].target - commands.motors[1].target;
  };
  // The left wheel alone turns the rover by this without slip.
  const double spin_rad_s =
      3.0 * options.drive.yaw_slip_rad_s * nominal.track_m / nominal.wheel_radius_m;
  EXPECT_GT(std::abs(drive_s(1.5, spin_rad_s)), 0.05);
  EXPECT_EQ(drive_s(4.0, spin_rad_s), 0.0);
  drive_s(8.0, 0.0);
  EXPECT_NE(drive_s(2.0, 0.0), 0.0);
}

}  // namespace
}  // namespace dockyard::axel
