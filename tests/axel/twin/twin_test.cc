// Our world against the same rover in MuJoCo.
//
// Afloat the two engines differ only in where they take the speed of the step, so they come
// together with the step, and in the joints' and the body's turning to the last bits. On the ground
// they differ as their contacts do. Ours is the soil's, at its hardest: it gives 0.33 mm under a
// wheel, is divided into strips of 2.5 deg, over which a wheel rolls as a polygon of 144 sides, and
// presses over an area; it bends a little before it slides. MuJoCo's is a row of points on an edge,
// and holds at rest only up to a slow creep. So the pitch of the rover, which swings like a
// pendulum in the taut tether, gradually falls out of step, and with it the axle, by the wheel's
// radius times the pitch; tension, distance and heading stay together.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "axel/sim/product.h"
#include "axel/twin/mujoco_twin.h"
#include "sim/axel/rover_body.h"
#include "sim/soil/soil_laws.h"

namespace dockyard::axel {
namespace {

/// Both rovers afloat, driven by torques on their joints alone for a second.
struct Afloat {
  double tip_apart_m = 0.0, turn_apart_rad = 0.0, joints_apart_rad = 0.0;
};

Afloat CompareAfloat(double step_s) {
  WorldSetup setup = TestSetup(CompactGravel(), {});
  setup.step_s = step_s;
  RoverModel& model = setup.rover;
  model.body.I_LCom_L(0, 2) = model.body.I_LCom_L(2, 0) = 0.2;  // no axis of symmetry
  const Pose3 X_GR = Pose3::Translation(50.0, 0.0, 0.0);
  RigidWorld world(Eigen::Vector3d::Zero());
  RoverBody rover(world, model, X_GR, 0.3, false);
  MujocoTwin twin(setup, 0.5, 0.0);
  twin.SetPose(X_GR, 0.3);
  const std::array<double, 3> torque = {3.0, -2.0, 4.0};
  for (long i = 0; i < std::lround(1.0 / step_s); ++i) {
    rover.AddJointTorque(RoverLink::kLeftWheel, torque[0]);
    rover.AddJointTorque(RoverLink::kRightWheel, torque[1]);
    rover.AddJointTorque(RoverLink::kArm, torque[2]);
    world.Step(step_s);
    twin.StepUnder(torque);
  }
  const Pose3 ours = rover.motion(RoverLink::kBody).X_GL, theirs = twin.X_GR();
  const Eigen::Vector3d tip = rover.motion(RoverLink::kArm).X_GL * Eigen::Vector3d(1, 0, 0);
  Afloat apart;
  apart.tip_apart_m = (tip - twin.TipInG()).norm();
  apart.turn_apart_rad = Eigen::AngleAxisd(ours.R.transpose() * theirs.R).angle();
  for (int i = 0; i < 3; ++i) {
    const double ours_rad = rover.joint_rad(static_cast<RoverLink>(i + 1));
    apart.joints_apart_rad =
        std::max(apart.joints_apart_rad, std::abs(ours_rad - twin.joint_rad(i)));
  }
  std::printf("afloat, step %.2f ms: tip %.2e m, body %.2e rad, joints %.2e rad apart\n",
              1e3 * step_s, apart.tip_apart_m, apart.turn_apart_rad, apart.joints_apart_rad);
  return apart;
}

TEST(Twin, MovesTheSameAfloatUpToTheStepsFirstOrderError) {
  const Afloat coarse = CompareAfloat(1e-3), fine = CompareAfloat(0.5e-3);
  EXPECT_LT(coarse.tip_apart_m, 1e-4);
  EXPECT_NEAR(coarse.tip_apart_m / fine.tip_apart_m, 2.0, 0.1);
  EXPECT_LT(coarse.joints_apart_rad, 1e-12);
  EXPECT_LT(coarse.turn_apart_rad, 1e-7);  // an angle near 0 from an arc cosine
}

/// Elastic ground that does not yield, and smooth wheels: as near to a rigid plane as our soil
/// comes at steps of 1 ms. The wheels press it in by a third of a millimetre.
constexpr double kGroundFriction = 0.5;  // of metal on the ground, in both worlds

SoilModel HardGround() {
  SoilModel soil;
  soil.name = "hard";
  soil.n = 1.0;
  soil.k_phi = 1e13;
  soil.cohesion_pa = 0.0;
  soil.friction_angle_rad = std::atan(kGroundFriction) / kWallFriction;
  soil.shear_modulus_m = 5e-4;
  soil.shear_depth_m = kLeastDepth_m;
  soil.density_kg_m3 = 1700.0;
  soil.unloading_stiffness_pa_per_m = 2e8;
  soil.damping_pa_s_per_m = 3e5;
  return soil;
}

WorldSetup HardSetup(const Pose2& X_DR) {
  WorldSetup setup = TestSetup(HardGround(), X_DR);
  for (WheelModel* wheel : {&setup.rover.left_wheel_soil, &setup.rover.right_wheel_soil}) {
    wheel->paddle_count = 0;
    wheel->paddle_height_m = 0.0;
    wheel->rim_radius_m = 0.3;
  }
  // Body and arm balance on the axle, so that the tip stays clear of the ground, on which the twin
  // has no contact for it.
  setup.rover.body.p_LoCom_L.x() = -4.0 * 0.5 / 24.0;
  setup.station.tip_angle_rad = 0.0;      // the way to the anchor is straight
  setup.station.module.mass_kg = 2000.0;  // and the station stands fast
  setup.station.module.I_LCom_L = 200.0 * Eigen::Matrix3d::Identity();
  setup.station.foot_stiffness_n_per_m = 1e7;
  return setup;
}

/// Largest differences, and means over the second half.
struct Apart {
  double x_m = 0.0, y_m = 0.0, heading_rad = 0.0, pitch_rad = 0.0, tension_n = 0.0;
  double mean_n = 0.0, twin_mean_n = 0.0, peak_n = 0.0, twin_peak_n = 0.0;
  double way_m = 0.0, turn_rad = 0.0, swing_rad = 0.0;  // of the twin; swing of its arm
};

double ArmUp(const Pose3& X_GR, double arm_rad) {
  return std::asin((X_GR.R * RotY(arm_rad).col(0)).z());
}

Apart Compare(const char* name, const WorldSetup& setup, const MotorCommands& commands,
              double seconds) {
  World world(setup);
  MujocoTwin twin(setup, kGroundFriction, 9.81);
  const Truth start = world.truth();
  twin.SetPose(start.X_WR, start.arm_rad);
  twin.PowerOn(setup.slack_start_m);
  Apart apart;
  double lowest_rad = 0.0, highest_rad = -kPi;
  const long steps = std::lround(seconds / setup.step_s);
  for (long i = 0; i < steps; ++i) {
    world.Step(commands);
    twin.Step(commands);
    const Truth ours = world.truth();
    const Pose3 X = twin.X_GR();
    const auto Keep = [](double& most, double value) { most = std::max(most, std::abs(value)); };
    Keep(apart.x_m, ours.X_WR.p.x() - X.p.x());
    Keep(apart.y_m, ours.X_WR.p.y() - X.p.y());
    Keep(apart.heading_rad, WrapPi(ToGround(ours.X_WR).heading - ToGround(X).heading));
    const double arm_up = ArmUp(X, twin.joint_rad(2));
    lowest_rad = i == 0 ? arm_up : std::min(lowest_rad, arm_up);
    highest_rad = std::max(highest_rad, arm_up);
    Keep(apart.pitch_rad, ArmUp(ours.X_WR, ours.arm_rad) - arm_up);
    Keep(apart.tension_n, ours.tether_tension_n - twin.tension_n());
    Keep(apart.peak_n, ours.tether_tension_n);
    Keep(apart.twin_peak_n, twin.tension_n());
    if (2 * i >= steps) {
      apart.mean_n += ours.tether_tension_n * 2.0 / static_cast<double>(steps);
      apart.twin_mean_n += twin.tension_n() * 2.0 / static_cast<double>(steps);
    }
  }
  const Pose3 end = twin.X_GR();
  apart.way_m = (end.p - start.X_WR.p).head<2>().norm();
  apart.swing_rad = highest_rad - lowest_rad;
  apart.turn_rad = WrapPi(ToGround(end).heading - ToGround(start.X_WR).heading);
  std::printf(
      "%s: twin goes %.3f m, turns %.2f deg; apart at most x %.1f mm, y %.1f mm, heading %.2f deg, "
      "arm %.2f deg of a swing of %.1f deg; tension mean %.2f and %.2f N, peak %.1f and %.1f N\n",
      name, apart.way_m, Degrees(apart.turn_rad), 1e3 * apart.x_m, 1e3 * apart.y_m,
      Degrees(apart.heading_rad), Degrees(apart.pitch_rad), Degrees(apart.swing_rad), apart.mean_n,
      apart.twin_mean_n, apart.peak_n, apart.twin_peak_n);
  return apart;
}

MotorCommands Pull(double spool_current_a) {
  MotorCommands commands = AllBraked();
  At(commands, Motor::kSpool) = Velocity(1.0, spool_current_a);
  return commands;
}

TEST(Twin, IsHeldBackByItsWheelsAlike) {
  for (const double pull_n : {60.0, 120.0}) {
    MotorCommands commands = Pull(SpoolCurrent(pull_n));
    At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = Velocity(0.12, 2.8);
    const Apart apart = Compare("held back", HardSetup({3.0, 0.0, kPi}), commands, 8.0);
    EXPECT_GT(apart.way_m, 0.28);
    EXPECT_LT(apart.heading_rad, 1e-6);
    // Swings fall out of step; the axle goes with them by the radius times the pitch, and back.
    EXPECT_LT(apart.pitch_rad, 0.25 * apart.swing_rad);
    EXPECT_LT(apart.x_m, 0.3 * apart.pitch_rad + 10e-3);
    EXPECT_NEAR(apart.mean_n, apart.twin_mean_n, 0.01 * apart.twin_mean_n);
    EXPECT_NEAR(apart.peak_n, apart.twin_peak_n, 0.05 * apart.twin_peak_n);
  }
}

TEST(Twin, DrivesAnArcOnATautTetherAlike) {
  MotorCommands commands = Pull(SpoolCurrent(60.0));
  At(commands, Motor::kLeftWheel) = Velocity(0.14, 2.8);
  At(commands, Motor::kRightWheel) = Velocity(0.07, 2.8);
  const Apart apart = Compare("arc", HardSetup({3.0, 0.0, kPi}), commands, 8.0);
  EXPECT_LT(Degrees(apart.turn_rad), -10.0);
  EXPECT_LT(Degrees(apart.heading_rad), 0.4);
  EXPECT_LT(apart.y_m, 10e-3);
  EXPECT_LT(apart.x_m, 45e-3);
  EXPECT_LT(Degrees(apart.pitch_rad), 8.0);
  EXPECT_NEAR(apart.mean_n, apart.twin_mean_n, 0.02 * apart.twin_mean_n);
  EXPECT_NEAR(apart.peak_n, apart.twin_peak_n, 0.06 * apart.twin_peak_n);
}

TEST(Twin, SkidsUnderTheSamePull) {
  WorldSetup setup = HardSetup({3.0, 0.0, kPi});
  setup.slack_start_m = 0.03;
  const Apart apart = Compare("skid", setup, Pull(2.0), 4.0);
  EXPECT_LT(apart.x_m, 20e-3);
  EXPECT_LT(Degrees(apart.pitch_rad), 3.0);
  EXPECT_NEAR(apart.mean_n, apart.twin_mean_n, 0.02 * apart.twin_mean_n);
  EXPECT_NEAR(apart.peak_n, apart.twin_peak_n, 0.03 * apart.twin_peak_n);
}

}  // namespace
}  // namespace dockyard::axel
