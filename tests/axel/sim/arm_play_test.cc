// Backlash and bend between the encoders and what Axel's motors turn.
#include <gtest/gtest.h>

#include <cmath>

#include "axel/sim/product.h"
#include "models/parts/gravity.h"

namespace dockyard::axel {
namespace {

constexpr double kPlay_rad = Radians(0.6), kBend_nm_per_rad = 2000.0;

WorldSetup WithPlay(Motor motor, double play_rad, double bend_nm_per_rad) {
  WorldSetup setup = TestSetup(CompactGravel(), {3.0, 0.0, kPi});
  setup.slack_start_m = 0.5;  // nothing pulls
  MotorModel& model = setup.rover.motors[static_cast<std::size_t>(motor)];
  model.backlash_rad = play_rad;
  model.bend_nm_per_rad = bend_nm_per_rad;
  return setup;
}

double LeadOf(const Truth& truth, Motor motor) {
  return truth.motor_lead_rad[static_cast<std::size_t>(motor)];
}

/// Moment of the arm's weight about the axle, tip-down positive, by its mass and its place alone.
double WeightMoment_nm(const RoverModel& rover, const Truth& truth) {
  const Eigen::Vector3d arm_W = truth.X_WA.R * rover.arm.p_LoCom_L;
  const Eigen::Vector3d force_W(0.0, 0.0, -rover.arm.mass_kg * kEarthGravity_m_s2);
  return arm_W.cross(force_W).dot(truth.X_WA.R.col(1));
}

/// The arm held free of the ground so far from where it lay, tip-up negative.
Truth HeldAt(World& world, double rad, double seconds) {
  MotorCommands commands = AllBraked();
  At(commands, Motor::kArm) = Position(rad, 0.3, 2.2);
  Play(world, commands, seconds);
  return world.truth();
}

/// What the teeth give under the arm's weight: half the play, and torque over stiffness.
double Expected_rad(double moment_nm, double play_rad, double bend_nm_per_rad) {
  return -std::copysign(0.5 * play_rad + std::abs(moment_nm) / bend_nm_per_rad, moment_nm);
}

// Ahead of the axle the weight turns the tip down: the arm is below what the encoder says.
TEST(ArmPlay, LiftedArmHangsBelowItsEncoderByHalfThePlayAndTheBend) {
  for (const double play_rad : {0.0, kPlay_rad}) {
    for (const double bend : {kBend_nm_per_rad, 4.0 * kBend_nm_per_rad}) {
      const WorldSetup setup = WithPlay(Motor::kArm, play_rad, bend);
      World world(setup);
      const Truth truth = HeldAt(world, -0.5, 6.0);
      const double moment_nm = WeightMoment_nm(setup.rover, truth);
      ASSERT_GT(moment_nm, 5.0);
      const double expected_rad = Expected_rad(moment_nm, play_rad, bend);
      EXPECT_NEAR(LeadOf(truth, Motor::kArm), expected_rad, 0.01 * std::abs(expected_rad));
      EXPECT_LT(expected_rad, 0.0);
    }
  }
}

TEST(ArmPlay, EncoderStaysOnTargetWhileTheArmIsOff) {
  const WorldSetup setup = WithPlay(Motor::kArm, kPlay_rad, kBend_nm_per_rad);
  World world(setup);
  const Truth truth = HeldAt(world, -0.5, 6.0);
  const std::size_t arm = static_cast<std::size_t>(Motor::kArm);
  const double read_rad = truth.motor_angle_rad[arm] + truth.motor_lead_rad[arm];
  EXPECT_NEAR(read_rad, -0.5, 2e-3);  // what the servo itself gives
  EXPECT_GT(truth.motor_angle_rad[arm] + 0.5, 0.5 * kPlay_rad);
}

TEST(ArmPlay, IsNoneUnlessAskedFor) {
  World world(WithPlay(Motor::kArm, 0.0, 0.0));
  EXPECT_EQ(LeadOf(HeldAt(world, -0.5, 2.0), Motor::kArm), 0.0);
}

// Forward the wheels hold the body, whose nose is heavy. Backward, once the tip is on the ground,
// the soil and the tip resist them: the gears then bear on their other flank.
TEST(WheelPlay, IsLostAsTheWheelsTurnRound) {
  WorldSetup setup = WithPlay(Motor::kLeftWheel, kPlay_rad, 0.0);
  setup.soil = LooseSand();
  World world(setup);
  const auto lead = [&](double rad_s, double seconds) {
    Play(world, Drive(rad_s, 0.0), seconds);
    return LeadOf(world.truth(), Motor::kLeftWheel);
  };
  EXPECT_NEAR(lead(0.15, 3.0), 0.5 * kPlay_rad, 0.02 * kPlay_rad);
  EXPECT_NEAR(lead(-0.15, 11.0), -0.5 * kPlay_rad, 0.02 * kPlay_rad);
}

}  // namespace
}  // namespace dockyard::axel
