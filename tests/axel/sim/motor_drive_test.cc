#include "sim/drives/motor_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "axel/sim/product.h"

namespace dockyard::axel {
namespace {

constexpr double kDt = 1e-3;

/// Axel's wheel motor, quicker than the file has it (0.5 rad/s and rad/s^2), so that the moves are
/// short, and with gears without losses; other tests cover the losses.
const MotorModel& WheelMotor() {
  static const MotorModel motor = [] {
    MotorModel wheel = Axel().motors[static_cast<std::size_t>(Motor::kLeftWheel)];
    wheel.max_speed_rad_s = 1.0;
    wheel.max_accel_rad_s2 = 2.0;
    wheel.gear_efficiency = 1.0;
    return wheel;
  }();
  return motor;
}

/// A shaft with its drive and nothing else.
struct Shaft {
  explicit Shaft(double inertia, const MotorModel& motor = WheelMotor())
      : drive(motor, inertia), inertia(inertia) {}
  void Turn(const MotorCommand& command, double load_nm, double seconds) {
    for (long i = 0; i < std::lround(seconds / kDt); ++i) {
      out = drive.Step(command, angle, speed, kDt);
      speed += (out.torque_nm() + load_nm) / inertia * kDt;
      angle += speed * kDt;
      time += kDt;
    }
  }
  MotorDrive drive;
  double inertia, angle = 0.0, speed = 0.0, time = 0.0;
  DriveOutput out;
};

TEST(Profile, IsATrapezoidThatTakesDistanceBySpeedPlusSpeedBySlope) {
  const MotorCommand command{MotorMode::kPosition, 2.0, 0.5, 1.0, 2.0};
  ProfileState at;
  int steps = 0;
  double fastest = 0.0;
  while (at.angle_rad < 2.0 - 1e-9 && steps < 10000) {
    at = AdvanceProfile(at, command, WheelMotor(), kDt);
    fastest = std::max(fastest, at.speed_rad_s);
    ++steps;
  }
  EXPECT_NEAR(steps * kDt, 2.0 / 0.5 + 0.5 / 1.0, 3 * kDt);
  EXPECT_DOUBLE_EQ(fastest, 0.5);
}

TEST(Profile, ShortMoveIsATriangle) {
  const MotorCommand command{MotorMode::kPosition, 0.04, 0.5, 1.0, 2.0};
  ProfileState at;
  int steps = 0;
  while (at.angle_rad < 0.04 - 1e-9 && steps < 10000) {
    at = AdvanceProfile(at, command, WheelMotor(), kDt);
    ++steps;
  }
  EXPECT_NEAR(steps * kDt, 2.0 * std::sqrt(0.04 / 1.0), 3 * kDt);
}

TEST(Profile, NeverPassesItsTargetAndStaysThere) {
  const MotorCommand command{MotorMode::kPosition, -0.3, 0.7, 1.7, 2.0};
  ProfileState at;
  for (int i = 0; i < 5000; ++i) {
    at = AdvanceProfile(at, command, WheelMotor(), kDt);
    ASSERT_GE(at.angle_rad, -0.3 - 1e-6);
  }
  EXPECT_NEAR(at.angle_rad, -0.3, 1e-9);
  EXPECT_NEAR(at.speed_rad_s, 0.0, 1e-6);
}

TEST(Profile, AChangedCommandGoesOnFromThePresentSpeed) {
  ProfileState at{0.0, 0.5};
  const MotorCommand back{MotorMode::kVelocity, -0.5, 0.0, 1.0, 2.0};
  const ProfileState next = AdvanceProfile(at, back, WheelMotor(), kDt);
  EXPECT_NEAR(next.speed_rad_s, 0.5 - 1.0 * kDt, 1e-12);
}

/// Follows a spline to its end and notes its peaks.
struct SplinePeaks {
  double speed = 0.0, accel = 0.0, jump = 0.0;  // largest change of acceleration in a step
  ProfileState end;
};
SplinePeaks Follow(const SplineMove& move) {
  SplinePeaks peaks;
  double last = move.At(0.0).accel_rad_s2;
  for (double t = 0.0; t < move.duration_s() + 0.01; t += kDt) {
    peaks.end = move.At(t);
    peaks.speed = std::max(peaks.speed, std::abs(peaks.end.speed_rad_s));
    peaks.accel = std::max(peaks.accel, std::abs(peaks.end.accel_rad_s2));
    peaks.jump = std::max(peaks.jump, std::abs(peaks.end.accel_rad_s2 - last));
    last = peaks.end.accel_rad_s2;
  }
  return peaks;
}

TEST(Spline, FromRestToRestPeaksAtFifteenEighthsOfTheMeanSpeed) {
  // Long: the speed limit rules, and T = 15/8 D / v. Short: T = sqrt(10 / sqrt(3) D / a).
  const SplineMove far({}, {MotorMode::kPosition, 3.0, 0.5, 2.0, 2.0}, WheelMotor());
  EXPECT_NEAR(far.duration_s(), 1.875 * 3.0 / 0.5, 1e-9);
  EXPECT_NEAR(Follow(far).speed, 0.5, 1e-6);
  const SplineMove near({}, {MotorMode::kPosition, 0.01, 0.5, 1.0, 2.0}, WheelMotor());
  EXPECT_NEAR(near.duration_s(), std::sqrt(10.0 / std::sqrt(3.0) * 0.01), 1e-9);
  EXPECT_NEAR(Follow(near).accel, 1.0, 1e-3);
}

TEST(Spline, EndsAtRestOnItsTargetWithoutAJumpOfAcceleration) {
  const SplineMove move({0.2, -0.3, 0.4}, {MotorMode::kPosition, 1.0, 0.5, 1.0, 2.0}, WheelMotor());
  EXPECT_NEAR(move.At(0.0).speed_rad_s, -0.3, 1e-12);
  EXPECT_NEAR(move.At(0.0).accel_rad_s2, 0.4, 1e-12);
  const SplinePeaks peaks = Follow(move);
  EXPECT_NEAR(peaks.end.angle_rad, 1.0, 1e-12);
  EXPECT_NEAR(peaks.end.speed_rad_s, 0.0, 1e-12);
  EXPECT_NEAR(peaks.end.accel_rad_s2, 0.0, 1e-9);
  EXPECT_LE(peaks.speed, 0.5 * (1 + 1e-6));
  EXPECT_LE(peaks.accel, 1.0 * (1 + 1e-3));
  EXPECT_LT(peaks.jump, 0.02);  // a trapezoid's is the acceleration itself
}

TEST(Spline, RunsUpToASpeedAndOnAtIt) {
  const SplineMove move({0.0, 0.1}, {MotorMode::kVelocity, 0.4, 0.0, 0.5, 2.0}, WheelMotor());
  EXPECT_NEAR(move.duration_s(), 1.5 * 0.3 / 0.5, 1e-9);
  EXPECT_NEAR(Follow(move).accel, 0.5, 1e-5);
  const ProfileState at = move.At(move.duration_s() + 2.0);
  EXPECT_NEAR(at.speed_rad_s, 0.4, 1e-12);
  EXPECT_NEAR(at.angle_rad - move.At(move.duration_s()).angle_rad, 0.8, 1e-12);
}

TEST(Drive, FollowsASplineToItsAngleAgainstALoad) {
  MotorModel motor = WheelMotor();
  motor.profile = ProfileShape::kSpline;
  Shaft shaft(1.0, motor);
  shaft.Turn(Position(0.8, 0.5, 2.8), -10.0, 6.0);
  EXPECT_NEAR(shaft.angle, 0.8, 2e-3);
  shaft.Turn(Position(-0.4, 0.5, 2.8), -10.0, 1.0);
  shaft.Turn(Position(0.3, 0.5, 2.8), -10.0, 8.0);  // turned round on the way
  EXPECT_NEAR(shaft.angle, 0.3, 2e-3);
}

/// Current drawn while the shaft turns steadily at this speed under this load.
double SteadyCurrent(double efficiency, double speed, double load) {
  MotorModel motor = WheelMotor();
  motor.gear_efficiency = efficiency;
  Shaft shaft(1.0, motor);
  shaft.Turn(Velocity(speed, 2.8), load, 5.0);
  EXPECT_NEAR(shaft.speed, speed, 1e-6);
  return shaft.out.current_a;
}

TEST(Drive, GearsThatLoseTakeLessCurrentToLetALoadDownThanToRaiseIt) {
  // Raising 10 Nm against 1.5 Nm of friction: (10 + 1.5) / 15 A beyond no load, whatever e is.
  // Letting it down the friction and (1 - e) k i help: 10 - 1.5 = (2 - e) k i, k = 15 / e.
  EXPECT_NEAR(SteadyCurrent(1.0, 0.3, -10.0), 0.2 + 11.5 / 15.0, 1e-6);
  EXPECT_NEAR(SteadyCurrent(0.75, 0.3, -10.0), 0.2 + 11.5 / 15.0, 1e-6);
  EXPECT_NEAR(SteadyCurrent(1.0, -0.3, -10.0), 0.2 + 8.5 / 15.0, 1e-6);
  EXPECT_NEAR(SteadyCurrent(0.75, -0.3, -10.0), 0.2 + 8.5 / 1.25 / (15.0 / 0.75), 1e-6);
}

TEST(Drive, GearsThatLoseHoldAShaftAtRestBetweenRaisingAndLettingDown) {
  // At 1.2 A: raises up to 15 - 1.5 Nm, is overpowered from 1.25 x 20 + 1.5 Nm.
  MotorModel motor = WheelMotor();
  motor.gear_efficiency = 0.75;
  for (double load : {14.0, 20.0, 26.0}) {
    Shaft shaft(1.0, motor);
    const MotorCommand hold = Position(0.0, 0.5, 1.2);
    shaft.Turn(hold, -load, 2.0);
    const double angle = shaft.angle;
    shaft.Turn(hold, -load, 5.0);
    EXPECT_NEAR(shaft.angle, angle, 1e-6) << load;
  }
  Shaft dragged(1.0, motor);
  dragged.Turn(Position(0.0, 0.5, 1.2), -27.5, 2.0);
  const double speed = dragged.speed;
  dragged.Turn(Position(0.0, 0.5, 1.2), -27.5, 1.0);
  EXPECT_NEAR(dragged.speed - speed, -(27.5 - 26.5), 1e-6);
}

TEST(Drive, StallTorqueIsTorquePerAmpTimesCurrentBeyondNoLoad) {
  // In front of the gears: those of the file's wheel lose a quarter of it.
  MotorModel losing = WheelMotor();
  losing.gear_efficiency = 0.75;
  for (const MotorModel& motor : {WheelMotor(), losing}) {
    MotorDrive drive(motor, 0.5);
    DriveOutput out;
    for (int i = 0; i < 3000; ++i) out = drive.Step(Velocity(1.0, 1.2), 0.0, 0.0, kDt);
    EXPECT_DOUBLE_EQ(out.motor_torque_nm * motor.gear_efficiency, 15.0 * (1.2 - 0.2));
    EXPECT_NEAR(out.current_a, 1.2, 1e-12);
  }
}

TEST(Drive, NoCurrentBeyondNoLoadIsNoTorque) {
  MotorDrive drive(WheelMotor(), 0.5);
  DriveOutput out;
  for (int i = 0; i < 1000; ++i) out = drive.Step(Velocity(1.0, 0.15), 0.0, 0.0, kDt);
  EXPECT_EQ(out.motor_torque_nm, 0.0);
}

TEST(Drive, ReachesAnAngleAgainstALoad) {
  Shaft shaft(1.0);
  shaft.Turn(Position(0.8, 0.5, 2.8), -10.0, 6.0);
  EXPECT_NEAR(shaft.angle, 0.8, 2e-3);
  EXPECT_NEAR(shaft.speed, 0.0, 1e-6);
}

TEST(Drive, OverpoweredShaftIsDraggedAtTheLimitAndDoesNotWindUp) {
  Shaft shaft(1.0);
  const MotorCommand hold = Position(0.0, 0.5, 0.6);  // 6 Nm and 1.5 Nm of gears
  shaft.Turn(hold, -20.0, 0.5);
  EXPECT_NEAR(shaft.out.motor_torque_nm, 6.0, 1e-9);
  EXPECT_LT(shaft.angle, -1.0);
  shaft.Turn(hold, 0.0, 20.0);
  EXPECT_NEAR(shaft.angle, 0.0, 2e-3);  // comes back at its profile's pace
}

TEST(Drive, FreeShaftDrawsNothingAndKeepsItsGearFriction) {
  Shaft shaft(1.0);
  shaft.speed = 2.0;
  shaft.Turn(FreeWheel(), 0.0, 0.5);
  EXPECT_NEAR(shaft.speed, 2.0 - 1.5 * 0.5, 1e-2);
  EXPECT_EQ(shaft.out.current_a, 0.0);
  shaft.Turn(FreeWheel(), 0.0, 3.0);
  EXPECT_NEAR(shaft.speed, 0.0, 1e-9);
}

TEST(Drive, GearsHoldALoadBelowTheirFrictionWithoutCreep) {
  Shaft shaft(1.0);
  shaft.Turn(FreeWheel(), 1.4, 2.0);
  const double angle = shaft.angle;
  shaft.Turn(FreeWheel(), 1.4, 10.0);
  EXPECT_NEAR(shaft.angle, angle, 1e-9);
}

TEST(Drive, GearsGiveWayAboveTheirFriction) {
  Shaft shaft(1.0);
  shaft.Turn(FreeWheel(), 1.6, 1.0);
  const double speed = shaft.speed;
  shaft.Turn(FreeWheel(), 1.6, 2.0);
  EXPECT_NEAR(shaft.speed - speed, (1.6 - 1.5) * 2.0, 1e-9);
}

TEST(Drive, BrakeHoldsUpToItsTorqueAndSlipsBeyond) {
  Shaft held(1.0), slipping(1.0);
  held.Turn(MotorCommand{}, 61.0, 2.0);  // 60 Nm brake, 1.5 Nm gears
  EXPECT_NEAR(held.speed, 0.0, 1e-6);
  slipping.Turn(MotorCommand{}, 63.0, 1.0);
  const double speed = slipping.speed;
  slipping.Turn(MotorCommand{}, 63.0, 2.0);
  EXPECT_NEAR(slipping.speed - speed, (63.0 - 61.5) * 2.0, 1e-9);
}

TEST(Drive, RefusesACommandThatIsNoNumber) {
  MotorDrive drive(WheelMotor(), 0.5);
  const MotorCommand bad = Velocity(std::numeric_limits<double>::quiet_NaN(), 1.0);
  EXPECT_DEATH(drive.Step(bad, 0.0, 0.0, kDt), "check failed");
}

}  // namespace
}  // namespace dockyard::axel
