#include "controller/axel/righting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/phases.h"

namespace dockyard::axel {
namespace {

constexpr double kDown = Radians(15.0);  // of an arm whose tip lies on the ground

/// Body and arm about an axle that stands: the tip lies on the ground, or the motor turns the arm
/// over the top; braked wheels hold the body.
struct Lying {
  double pitch_rad = 0.0, arm_rad = 0.0;
  double stuck_rad_s = 1.0;  // largest speed of the arm's motor
  double lowest_rad = 0.0;   // the furthest that the motor pressed the tip into the ground

  double ArmDown() const { return pitch_rad + arm_rad; }

  SensorFrame Sense(const Nominal& nominal, Tick tick) const {
    SensorFrame frame = StillFrame();
    frame.tick = tick;
    const RollPitchYaw rpy = ToRollPitchYaw(RotY(pitch_rad));
    frame.imu.roll_rad = rpy.roll;
    frame.imu.pitch_rad = rpy.pitch;
    frame.imu.yaw_rad = rpy.yaw;
    const auto arm = static_cast<std::size_t>(Motor::kArm);
    frame.motors[arm].encoder_counts =
        std::llround((arm_rad - nominal.arm_at_zero_rad) / nominal.motors[arm].rad_per_count);
    return frame;
  }

  void Obey(const Nominal& nominal, const Commands& commands, double seconds) {
    const MotorCommand& arm = commands.motors[static_cast<std::size_t>(Motor::kArm)];
    const double speed = std::min(arm.speed_limit_rad_s, stuck_rad_s);
    const double left = arm.target + nominal.arm_at_zero_rad - arm_rad;
    const double turn = std::clamp(left, -speed * seconds, speed * seconds);
    arm_rad += turn;
    if (commands.motors[0].mode == MotorMode::kFree) pitch_rad -= turn;
    // Gravity lays it down, ahead or behind.
    const double down = ArmDown() - 2.0 * kPi * std::floor(ArmDown() / (2.0 * kPi));
    if (down > kDown && down < kPi - kDown) {
      const double rest = down < 0.5 * kPi ? kDown : kPi - kDown;
      lowest_rad = std::max(lowest_rad, std::abs(down - rest));
      pitch_rad += rest - down;
    }
  }
};

TEST(Righting, EndsUprightWithTheArmAheadFromAnyLie) {
  const Nominal nominal = TestNominal();
  for (const double arm_down : {kDown, kPi - kDown}) {
    for (double pitch_deg = -180.0; pitch_deg < 180.0; pitch_deg += 22.5) {
      Lying rover{Radians(pitch_deg), WrapPi(arm_down - Radians(pitch_deg))};
      Senses senses(nominal, AxelOptions{});
      Righting righting(nominal, RightingOptions{});
      Righting::Status status = Righting::Status::kUnderWay;
      Tick tick = 0;
      for (; tick < 120'000 && status == Righting::Status::kUnderWay; tick += kControlPeriod) {
        senses.Update(rover.Sense(nominal, tick));
        if (tick == 0) righting.Begin(senses);
        Commands commands = BrakedCommands();
        status = righting.Step(senses, &commands);
        rover.Obey(nominal, commands, kTickSeconds * kControlPeriod);
      }
      EXPECT_EQ(status, Righting::Status::kDone) << arm_down << ", " << pitch_deg;
      EXPECT_LT(std::abs(Degrees(WrapPi(rover.pitch_rad))), 50.0) << arm_down << ", " << pitch_deg;
      EXPECT_GT(std::cos(rover.ArmDown()), 0.0) << arm_down << ", " << pitch_deg;
      EXPECT_LT(rover.lowest_rad, Radians(0.5)) << arm_down << ", " << pitch_deg;
      EXPECT_LT(tick, 70'000) << arm_down << ", " << pitch_deg;
      // The arm ends in the turn in which it began: no tether stays wound up.
      EXPECT_LT(std::abs(rover.arm_rad), kPi) << arm_down << ", " << pitch_deg;
    }
  }
}

TEST(Righting, FailsWhereTheArmDoesNotTurn) {
  const Nominal nominal = TestNominal();
  Lying rover{0.0, kPi - kDown, 0.0};
  Senses senses(nominal, AxelOptions{});
  Righting righting(nominal, RightingOptions{});
  Righting::Status status = Righting::Status::kUnderWay;
  for (Tick tick = 0; tick < 900'000 && status == Righting::Status::kUnderWay;
       tick += kControlPeriod) {
    senses.Update(rover.Sense(nominal, tick));
    if (tick == 0) righting.Begin(senses);
    Commands commands = BrakedCommands();
    status = righting.Step(senses, &commands);
    rover.Obey(nominal, commands, kTickSeconds * kControlPeriod);
  }
  EXPECT_EQ(status, Righting::Status::kFailed);
}

TEST(Righting, IsReachedFromEveryPhaseAndLeadsBackToTheTether) {
  for (int p = 0; p < kPhaseCount; ++p) {
    const Phase phase = static_cast<Phase>(p);
    if (phase == Phase::kDocked || phase == Phase::kGivenUp) continue;
    EXPECT_EQ(Next(phase, Event::kTurnedOver), Phase::kRight) << Name(phase);
  }
  EXPECT_EQ(Next(Phase::kRight, Event::kArrived), Phase::kTighten);
}

}  // namespace
}  // namespace dockyard::axel
