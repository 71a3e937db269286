// The arm all round the axle, open loop: put down, dragged behind, flipped over, driven upside
// down. What the ground and the motors bear then follows from the balance about the axle (see
// docs/reference/physics.md#turning-over).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "axel/sim/product.h"
#include "controller/geometry/axle_attitude.h"

namespace dockyard::axel {
namespace {

constexpr double kGravity = 9.81;
constexpr double kSlack_m = 3.0;  // the tether takes no part

/// The rover 6 m before the station, facing it, with the arm's tip on the ground.
WorldSetup Lying(const SoilModel& soil, bool trailing, double pitch_rad) {
  WorldSetup setup = TestSetup(soil, {6.0, 0.0, kPi});
  const double axle_m = 0.265 + 0.5 * 0.035;
  const double down = std::asin((axle_m - setup.rover.tip.radius_m) / setup.rover.arm_length_m);
  setup.pitch_start_rad = pitch_rad;
  setup.arm_start_rad = (trailing ? kPi - down : down) - pitch_rad;
  setup.slack_start_m = kSlack_m;
  return setup;
}

/// Motors that pass on what they give and nothing else.
void TakeFrictionAway(WorldSetup& setup) {
  for (MotorModel& motor : setup.rover.motors) {
    motor.gear_friction_nm = 0.0;
    motor.gear_efficiency = 1.0;
  }
}

double Pitch(const Truth& truth) { return ToAxleAttitude(truth.X_WR.R).pitch; }
/// The arm's turn from level ahead, downwards, -180 to 180 deg.
double ArmDown(const Truth& truth) { return ToAxleAttitude(truth.X_WA.R).pitch; }
bool Trails(const Truth& truth) { return std::abs(ArmDown(truth)) > 0.5 * kPi; }

/// Of a link's weight about the axle, nose-down, turned by this from level [N m].
double MomentOf(const LinkModel& link, double turn) {
  const Eigen::Vector3d& com = link.p_LoCom_L;
  return kGravity * link.mass_kg * (com.x() * std::cos(turn) + com.z() * std::sin(turn));
}
double WeightMoment(const RoverModel& rover, double pitch, double arm_down) {
  return MomentOf(rover.body, pitch) + MomentOf(rover.arm, arm_down);
}

/// Where the tip's lower edge is from the axle: ahead and below [m].
struct Touch {
  double ahead_m = 0.0, below_m = 0.0;
};
Touch TipTouch(const RoverModel& rover, double arm_down) {
  const double c = std::cos(arm_down), s = std::sin(arm_down), L = rover.arm_length_m;
  return {L * c - rover.tip.radius_m * s * (c < 0.0 ? -1.0 : 1.0),
          L * s + rover.tip.radius_m * std::abs(c)};
}

TEST(ArmRound, RestsAsItIsPutDownAtAnyTurn) {
  for (const SoilModel& soil : {LooseSand(), CompactGravel()}) {
    for (const bool trailing : {false, true}) {
      for (const double pitch_deg : {0.0, 60.0, 120.0, 180.0, -120.0, -60.0}) {
        World world(Lying(soil, trailing, Radians(pitch_deg)));
        const Truth start = world.truth();
        EXPECT_EQ(Trails(start), trailing) << soil.name << pitch_deg;
        // Paddles and soil give way a little.
        EXPECT_NEAR(WrapPi(Pitch(start) - Radians(pitch_deg)), 0.0, Radians(6.0))
            << soil.name << pitch_deg;
        EXPECT_NEAR(start.X_DR.p.x(), 6.0, 0.02) << soil.name << pitch_deg;
        Play(world, AllBraked(), 1.0);
        EXPECT_LT((world.truth().X_WA.p - start.X_WA.p).norm(), 3e-3) << soil.name << pitch_deg;
      }
    }
  }
}

TEST(ArmRound, TipBearsWhatTheBodyLeavesOfTheArmsWeight) {
  for (const bool trailing : {false, true}) {
    for (const double pitch_deg : {0.0, 90.0, 180.0, -90.0}) {
      WorldSetup setup = Lying(LooseSand(), trailing, Radians(pitch_deg));
      TakeFrictionAway(setup);
      setup.rover.tip.ground_friction = 0.0;  // at rest it may point either way
      World world(setup);
      MotorCommands commands = AllBraked();
      At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
      Play(world, commands, 4.0);
      const Truth truth = world.truth();
      const double expected_n = WeightMoment(setup.rover, Pitch(truth), ArmDown(truth)) /
                                TipTouch(setup.rover, ArmDown(truth)).ahead_m;
      std::printf("%s, body at %4.0f deg: tip bears %.2f N, by the balance %.2f N\n",
                  trailing ? "trailing" : "leading ", Degrees(Pitch(truth)),
                  truth.tip_ground_force_n, expected_n);
      EXPECT_NEAR(truth.tip_ground_force_n, expected_n, 0.03 * expected_n);
    }
  }
}

// mechanics: driving away from a trailing arm, the wheels' reaction presses its tip down.
TEST(ArmRound, TrailingArmIsPressedDownByTheWheels) {
  for (const SoilModel& soil : {LooseSand(), CompactGravel()}) {
    WorldSetup setup = Lying(soil, true, 0.0);
    TakeFrictionAway(setup);
    World world(setup);
    const MotorCommands commands = Drive(0.05 / 0.3, 0.0);
    Play(world, commands, 4.0);
    const double mu = setup.rover.tip.ground_friction;
    const double from_m = world.truth().X_DR.p.x();
    double bears_n = 0.0, expected_n = 0.0, wheels_nm = 0.0;
    constexpr int kSamples = 6000;
    for (int i = 0; i < kSamples; ++i) {
      world.Step(commands);
      const Truth truth = world.truth();
      const double torque = truth.motor_torque_nm[0] + truth.motor_torque_nm[1];
      const Touch tip = TipTouch(setup.rover, ArmDown(truth));
      // About the axle, nose-down: weight, wheels' reaction, the tip's load and its drag.
      const double load = (WeightMoment(setup.rover, Pitch(truth), ArmDown(truth)) - torque) /
                          (tip.ahead_m - mu * tip.below_m);
      bears_n += truth.tip_ground_force_n / std::hypot(1.0, mu) / kSamples;
      expected_n += load / kSamples;
      wheels_nm += torque / kSamples;
    }
    const double way_m = from_m - world.truth().X_DR.p.x();
    std::printf("%s: wheels %.1f N m, tip bears %.1f N, by the balance %.1f N; %.2f m in 6 s\n",
                soil.name.c_str(), wheels_nm, bears_n, expected_n, way_m);
    EXPECT_NEAR(bears_n, expected_n, 0.05 * expected_n) << soil.name;
    EXPECT_GT(way_m, 0.2) << soil.name;
    EXPECT_TRUE(Trails(world.truth())) << soil.name;
  }
}

// With the wheels free and the tip on the ground the arm's motor turns the body over, against no
// more than the body's own weight.
TEST(ArmRound, ArmsMotorTurnsTheBodyOverAgainstItsWeight) {
  WorldSetup setup = Lying(CompactGravel(), false, 0.0);
  TakeFrictionAway(setup);
  World world(setup);
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
  At(commands, Motor::kArm) = Position(-kPi, Radians(10.0), 2.2);
  double worst_nm = 0.0, highest_nm = 0.0;
  Play(world, commands, 2.0);
  for (int i = 0; i < 150; ++i) {
    Play(world, commands, 0.1);
    const Truth truth = world.truth();
    const double weight_nm = MomentOf(setup.rover.body, Pitch(truth));
    worst_nm = std::max(worst_nm, std::abs(truth.motor_torque_nm[2] - weight_nm));
    highest_nm = std::max(highest_nm, std::abs(weight_nm));
  }
  std::printf("arm's motor: %.2f N m at most off the body's weight, which is up to %.1f N m\n",
              worst_nm, highest_nm);
  EXPECT_LT(worst_nm, 0.05 * highest_nm);
  Play(world, commands, 4.0);
  EXPECT_NEAR(std::abs(Pitch(world.truth())), kPi, Radians(3.0));
  EXPECT_FALSE(Trails(world.truth()));
}

TEST(ArmRound, FullTurnOfTheBodyWindsItsDrumsCircumference) {
  World world(Lying(LooseSand(), false, 0.0));
  const Truth before = world.truth();
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
  At(commands, Motor::kArm) = Position(-2.0 * kPi, Radians(15.0), 2.2);
  Play(world, commands, 27.0);
  const Truth after = world.truth();
  EXPECT_NEAR(after.motor_angle_rad[2], -2.0 * kPi, 1e-3);
  EXPECT_NEAR(WrapPi(Pitch(after) - Pitch(before)), 0.0, Radians(1.0));
  EXPECT_NEAR(after.motor_angle_rad[3], 0.0, 1e-6);
  EXPECT_NEAR(before.tether_free_m - after.tether_free_m, 2.0 * kPi * 0.06, 1e-3);
}

/// With a slack tether the wheels turn body and arm over the top: over loose sand they roll only
/// with more torque than these weigh.
struct Flip {
  double at_s = 0.0;      // the arm stands upright
  double worst_nm = 0.0;  // wheels' torque against the weight's moment on the way up
  Truth end;
};
Flip DriveOver(World& world, const RoverModel& rover, const MotorCommands& commands,
               double step_s) {
  Flip flip;
  const bool trailed = Trails(world.truth());
  for (int i = 0; i < 240 && Trails(world.truth()) == trailed; ++i) {
    Play(world, commands, 0.1, step_s);
    flip.at_s += 0.1;
    const Truth truth = world.truth();
    const double up = std::abs(std::sin(ArmDown(truth)));
    if (ArmDown(truth) > 0.0 || up < 0.3 || up > 0.9) continue;
    const double torque = truth.motor_torque_nm[0] + truth.motor_torque_nm[1];
    const double weight = WeightMoment(rover, Pitch(truth), ArmDown(truth));
    flip.worst_nm = std::max(flip.worst_nm, std::abs(torque - weight));
  }
  Play(world, commands, 12.0, step_s);  // the wheels let it down as slowly
  flip.end = world.truth();
  return flip;
}

TEST(ArmRound, WheelsTurnItOverTheTopAgainstItsWeight) {
  WorldSetup setup = Lying(LooseSand(), false, 0.0);
  TakeFrictionAway(setup);
  World world(setup);
  const Flip over = DriveOver(world, setup.rover, Drive(0.05 / 0.3, 0.0), 1e-3);
  std::printf(
      "over the top after %.1f s, wheels' torque within %.2f N m of the weight's; axle "
      "%.2f m on, body at %.0f deg\n",
      over.at_s, over.worst_nm, 6.0 - over.end.X_DR.p.x(), Degrees(Pitch(over.end)));
  EXPECT_LT(over.worst_nm, 0.2);  // of 3 to 10 N m
  EXPECT_TRUE(Trails(over.end));
  EXPECT_GT(std::abs(Degrees(Pitch(over.end))), 160.0);
  EXPECT_LT(std::abs(6.0 - over.end.X_DR.p.x()), 0.1);
  // Arm and body turned as one: no tether was wound.
  EXPECT_NEAR(over.end.motor_angle_rad[2], 0.0, 0.02);
}

/// Way of the axle towards the station in this time [m].
double WayAhead(World& world, const MotorCommands& commands, double seconds) {
  const double from_m = world.truth().X_DR.p.x();
  Play(world, commands, seconds);
  return from_m - world.truth().X_DR.p.x();
}

TEST(ArmRound, DrivesUpsideDownAndTurnsBackUpright) {
  struct Case {
    const char* name;
    SoilModel soil;
    bool heads = true;  // they stand 0.24 m from the axle
    double least_m = 0.0;
  };
  // On sand the wheels sink by 6 cm as they turn the body over, and its heads plough the ground.
  const Case cases[] = {{"gravel", CompactGravel(), true, 0.4},
                        {"sand, no heads", LooseSand(), false, 0.4},
                        {"sand", LooseSand(), true, 0.1}};
  const MotorCommands ahead = Drive(0.05 / 0.3, 0.0), back = Drive(-0.05 / 0.3, 0.0);
  for (const Case& at : cases) {
    WorldSetup setup = Lying(at.soil, false, 0.0);
    if (!at.heads) {
      std::erase_if(setup.rover.body.collisions,
                    [](const Collision& part) { return part.name != "housing"; });
    }
    World world(setup);
    DriveOver(world, setup.rover, ahead, 1e-3);
    EXPECT_TRUE(Trails(world.truth())) << at.name;
    const double upside_down_m = WayAhead(world, ahead, 10.0);
    const Truth turned = world.truth();
    EXPECT_GT(std::abs(Degrees(Pitch(turned))), 140.0) << at.name;
    const Flip upright = DriveOver(world, setup.rover, back, 1e-3);
    EXPECT_FALSE(Trails(upright.end)) << at.name;
    EXPECT_LT(std::abs(Degrees(Pitch(upright.end))), 30.0) << at.name;
    const double upright_m = -WayAhead(world, back, 10.0);
    std::printf(
        "%s, 0.5 m of wheel: %.2f m ahead upside down, arm behind (%.1f N on the tip, "
        "wheels %.0f mm deep), %.2f m back upright\n",
        at.name, upside_down_m, turned.tip_ground_force_n, 1e3 * turned.left_sinkage_m, upright_m);
    EXPECT_GT(upside_down_m, at.least_m) << at.name;
    EXPECT_GT(upright_m, 0.3) << at.name;
  }
}

TEST(ArmRound, FlipDoesNotDependOnTheStep) {
  std::array<Flip, 2> flips;
  for (int i = 0; i < 2; ++i) {
    WorldSetup setup = Lying(LooseSand(), false, 0.0);
    setup.step_s = i == 0 ? 1e-3 : 0.5e-3;
    World world(setup);
    flips[i] = DriveOver(world, setup.rover, Drive(0.05 / 0.3, 0.0), setup.step_s);
  }
  EXPECT_NEAR(flips[0].at_s, flips[1].at_s, 0.11);
  EXPECT_NEAR(flips[0].end.X_DR.p.x(), flips[1].end.X_DR.p.x(), 0.01);
  EXPECT_NEAR(Pitch(flips[0].end), Pitch(flips[1].end), Radians(1.0));
  EXPECT_NEAR(flips[0].end.tip_ground_force_n, flips[1].end.tip_ground_force_n, 1.0);
}

TEST(ArmRound, MirroredFlipIsTheMirrorImage) {
  WorldSetup setup = Lying(LooseSand(), false, 0.0), mirrored = setup;
  setup.X_DR_start = {6.0, 0.4, 3.0};
  mirrored.X_DR_start = {6.0, -0.4, -3.0};
  std::swap(mirrored.rover.left_wheel_soil.phase_rad, mirrored.rover.right_wheel_soil.phase_rad);
  mirrored.add_right_side_first = true;
  World a(setup), b(mirrored);
  MotorCommands commands = Drive(0.05 / 0.3, 0.0), swapped = commands;
  At(commands, Motor::kLeftWheel) = Velocity(0.8 * 0.05 / 0.3, 2.8);
  At(swapped, Motor::kRightWheel) = Velocity(0.8 * 0.05 / 0.3, 2.8);
  for (int i = 0; i < 24; ++i) {
    Play(a, commands, 1.0);
    Play(b, swapped, 1.0);
  }
  const Truth left = a.truth(), right = b.truth();
  EXPECT_TRUE(Trails(left));
  EXPECT_NEAR(left.X_DR.p.x(), right.X_DR.p.x(), 1e-6);
  EXPECT_NEAR(left.X_DR.p.y(), -right.X_DR.p.y(), 1e-6);
  EXPECT_NEAR(AxleOnGround(left.X_DR).heading, -AxleOnGround(right.X_DR).heading, 1e-6);
  EXPECT_NEAR(Pitch(left), Pitch(right), 1e-6);
  EXPECT_GT(std::abs(AxleOnGround(left.X_DR).heading - 3.0), 0.05);
}

}  // namespace
}  // namespace dockyard::axel
