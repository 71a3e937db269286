#include "sim/raposa/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/raposa/load_ground.h"
#include "raposa/sim/raposa_rig.h"
#include "sim/raposa/ground_trials.h"
#include "sim/rigid/slope.h"
#include "sim/soil/soil_laws.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

// Far from the pyramid.
constexpr double kAway_m = 3.0;

TEST(RaposaWorld, BrakedRobotAndPyramidStayWhereTheyArePut) {
  const WorldSetup setup = AtStart(1.33, Radians(60.0));
  World world(setup);
  const Truth start = world.truth();
  EXPECT_NEAR(start.range_m, 1.33, 1e-3);
  EXPECT_NEAR(Degrees(start.alpha_rad), 60.0, 0.1);
  Play(world, setup, {}, 10.0);
  const Truth end = world.truth();
  EXPECT_LT((end.X_WR.p - start.X_WR.p).norm(), 1e-5);
  EXPECT_LT(end.pyramid_shift_m, 1e-4);
  EXPECT_LT(std::abs(Degrees(end.pyramid_turn_rad)), 0.1);
}

// Ten degrees are below the friction of belts (31 deg) and of the pyramid's feet (26 deg).
TEST(RaposaWorld, NothingCreepsOnASlopeOfTenDegrees) {
  WorldSetup setup = AtStart(1.33);
  setup.slope = {Radians(10.0), Radians(30.0)};
  World world(setup);
  const Truth start = world.truth();
  Play(world, setup, {}, 10.0);
  const Truth end = world.truth();
  EXPECT_LT((end.X_WR.p - start.X_WR.p).norm(), 1e-3);
  EXPECT_LT(end.pyramid_shift_m, 1e-3);
}

TEST(RaposaWorld, EqualBeltsDriveStraightByWhatTheyRun) {
  const WorldSetup setup = AtStart(kAway_m);
  World world(setup);
  Play(world, setup, Belts(setup, 0.1, 0.1), 1.0);  // up to speed
  const Truth start = world.truth();
  Play(world, setup, Belts(setup, 0.1, 0.1), 5.0);
  const Truth end = world.truth();
  EXPECT_NEAR((end.X_WR.p - start.X_WR.p).norm(), 0.5, 0.005);
  EXPECT_LT(std::abs(Degrees(HeadingOf(end) - HeadingOf(start))), 0.05);
}

double EffectiveGauge(const WorldSetup& setup, double arm_rad) {
  return TryTurning(setup, arm_rad, 0.05).gauge_m;
}

// Closed forms of a rigid body on Coulomb belts with a linear pressure, nothing fitted: raised,
// level, and pressed down onto its two ends (four corners).
TEST(RaposaWorld, TurnsByTheGaugeThatLoadAndArmGive) {
  const WorldSetup setup = AtStart(kAway_m);
  EXPECT_NEAR(EffectiveGauge(setup, Radians(-30.0)), 0.472, 0.03 * 0.472);
  EXPECT_NEAR(EffectiveGauge(setup, 0.0), 0.577, 0.03 * 0.577);
  EXPECT_NEAR(EffectiveGauge(setup, Radians(19.5)), 1.13, 0.03 * 1.13);
}

TEST(RaposaWorld, GaugeAgreesBetweenSteps) {
  WorldSetup setup = AtStart(kAway_m);
  std::vector<double> gauges;
  for (const double step_s : {2e-3, 1e-3, 5e-4}) {
    setup.step_s = step_s;
    gauges.push_back(EffectiveGauge(setup, 0.0));
  }
  EXPECT_NEAR(gauges[0], gauges[2], 0.01 * gauges[2]);
  EXPECT_NEAR(gauges[1], gauges[2], 0.005 * gauges[2]);
}

/// What soil bears under the two belts of a link, from the depth z under each place of their lower
/// runs and of the rollers' arcs: the pressure is k z^n. The ground is at height 0.
double BekkerLoad(const WorldSetup& setup, const Pose3& X_WL, double rear_m, double front_m) {
  const BeltsModel& belts = setup.robot.belts;
  const SoilLaws laws = MakeRimLaws(*setup.grounds[0].soil, belts.width_m);
  constexpr int kCells = 4000;
  const double radius_m = belts.roller_radius_m;
  const double from_m = rear_m - radius_m, cell_m = (front_m - rear_m + 2.0 * radius_m) / kCells;
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i) {
    const double x_m = from_m + (i + 0.5) * cell_m;
    const double past_m = std::max({rear_m - x_m, x_m - front_m, 0.0});
    const double below_m = std::sqrt(radius_m * radius_m - past_m * past_m);
    const double z_m = -(X_WL * Eigen::Vector3d(x_m, 0.0, -below_m)).z();
    sum += cell_m * std::pow(std::max(0.0, z_m), laws.n);
  }
  return 2.0 * belts.width_m * laws.k * sum;
}

// The cable lies on the ground, but for its last piece.
TEST(RaposaWorld, PyramidSinksIntoSandAsBekkerHasIt) {
  WorldSetup setup = AtStart(kAway_m);
  setup.grounds[0].soil = LoadGround(SourceFile("models/raposa/grounds/sand.yaml")).soil;
  const World world(setup);
  const Pose3 X_WP = world.truth().X_WP;
  const PyramidModel& pyramid = setup.pyramid;
  const double radius_m = 0.5 * pyramid.foot_diameter_m;
  const SoilLaws laws = MakeRimLaws(*setup.grounds[0].soil, radius_m);
  double load_n = 0.0;
  for (const Eigen::Vector2d& p : pyramid.p_P_soles) {
    const double z_m = -(X_WP * Eigen::Vector3d(p.x(), p.y(), -pyramid.guide.height_m)).z();
    load_n += kPi * radius_m * radius_m * laws.k * std::pow(std::max(0.0, z_m), laws.n);
  }
  const double weight_n = 9.81 * pyramid.body.mass_kg;
  EXPECT_NEAR(load_n, weight_n, 0.1 * weight_n);
  EXPECT_GT(pyramid.guide.height_m - X_WP.p.z(), 0.004);
}

TEST(RaposaWorld, SinksIntoSandAsBekkerHasIt) {
  WorldSetup setup = AtStart(kAway_m);
  setup.grounds[0].soil = LoadGround(SourceFile("models/raposa/grounds/sand.yaml")).soil;
  const World world(setup);
  const Truth truth = world.truth();
  const BeltsModel& belts = setup.robot.belts;
  const double load_n = BekkerLoad(setup, truth.X_WR, belts.body_rear_m, belts.body_front_m) +
                        BekkerLoad(setup, truth.X_WA, 0.0, belts.arm_length_m);
  const double weight_n = 9.81 * setup.robot.mass_kg();
  EXPECT_NEAR(load_n, weight_n, 0.05 * weight_n);
  EXPECT_GT(belts.roller_radius_m - truth.X_WR.p.z(), 0.003);
}

TEST(RaposaWorld, BeltsWithoutFrictionDoNotTurnIt) {
  WorldSetup setup = AtStart(kAway_m);
  setup.grounds[0].belt.friction = 1e-6;
  World world(setup);
  const double from = HeadingOf(world.truth());
  Play(world, setup, Belts(setup, -0.05, 0.05), 3.0);
  EXPECT_LT(std::abs(Degrees(HeadingOf(world.truth()) - from)), 0.1);
}

// With rollers of one size on one axle height the pitch b solves L sin b = l sin(theta - b).
TEST(RaposaWorld, ArmThatIsPressedDownLeansTheBodyBack) {
  const WorldSetup setup = AtStart(kAway_m);
  const BeltsModel& belts = setup.robot.belts;
  const double length_m = belts.body_front_m - belts.body_rear_m;
  for (const double theta : {Radians(10.0), Radians(15.0), Radians(19.0)}) {
    World world(setup);
    MotorCommands commands{};
    commands[2] = GoTo(setup, Motor::kArm, theta);
    Play(world, setup, commands, 4.0);
    const Truth truth = world.truth();
    const double arm = truth.arm_rad;
    const double lean = std::atan2(belts.arm_length_m * std::sin(arm),
                                   length_m + belts.arm_length_m * std::cos(arm));
    EXPECT_NEAR(arm, theta, Radians(0.7));  // the drive gives way under the load
    EXPECT_NEAR(Degrees(std::asin(truth.X_WR.R(2, 0))), Degrees(lean), 0.15);
  }
}

TEST(RaposaWorld, GuideThatTheDoorsHoldFollowsTheRobotAway) {
  const WorldSetup setup = AtStart(0.35);
  World world(setup);
  DockStraight(world, setup, 0.33, Radians(18.0));
  const Truth held = world.truth();
  EXPECT_LT(held.p_SP_R.norm(), 3e-3);
  EXPECT_LT(held.left_door_m, 0.012);
  MotorCommands away = Belts(setup, 0.05, 0.05);
  const double closed_rad = setup.robot.doors.travel_m / setup.robot.doors.pinion_radius_m;
  away[2] = GoTo(setup, Motor::kArm, Radians(18.0));
  away[3] = GoTo(setup, Motor::kLeftDoor, closed_rad);
  away[4] = GoTo(setup, Motor::kRightDoor, closed_rad);
  Play(world, setup, away, 6.0);
  const Truth gone = world.truth();
  EXPECT_LT(gone.p_SP_R.norm(), 5e-3);
  EXPECT_NEAR((gone.X_WP.p - held.X_WP.p).norm(), 0.3, 0.02);
}

TEST(RaposaWorld, GuideThatOpenDoorsLeaveStaysBehind) {
  const WorldSetup setup = AtStart(0.35);
  World world(setup);
  MotorCommands in = Belts(setup, -0.03, -0.03);
  in[2] = GoTo(setup, Motor::kArm, Radians(18.0));
  Play(world, setup, in, 0.33 / 0.03);
  EXPECT_LT(world.truth().p_SP_R.norm(), 0.01);
  MotorCommands away = Belts(setup, 0.05, 0.05);
  away[2] = in[2];
  Play(world, setup, away, 6.0);
  EXPECT_GT(world.truth().p_SP_R.norm(), 0.25);
}

// A robot that comes in from 60 deg turns the pyramid before it slides it: the guide lies far ahead
// of the feet.
TEST(RaposaWorld, RobotFromTheSideTurnsThePyramid) {
  const WorldSetup setup = AtStart(0.33, Radians(60.0));
  World world(setup);
  Play(world, setup, Belts(setup, -0.03, -0.03), 9.0);
  const Truth truth = world.truth();
  EXPECT_GT(truth.contact_peak_n, 0.5);
  EXPECT_GT(std::abs(Degrees(truth.pyramid_turn_rad)), 3.0);
}

TEST(RaposaWorld, SameCallsGiveTheSameBits) {
  const WorldSetup setup = AtStart(0.4, Radians(10.0));
  World a(setup), b(setup);
  for (World* world : {&a, &b}) Play(*world, setup, Belts(setup, -0.05, -0.045), 5.0);
  EXPECT_EQ(a.StateHash(1), b.StateHash(1));
}

// Where robot and pyramid are apart, no contact is looked for. With the search in each step the
// same comes out, on the way from there into contact.
TEST(RaposaWorld, SearchForContactsChangesNothingWhereThereAreNone) {
  WorldSetup setup = AtStart(0.6, Radians(10.0));
  World fast(setup);
  setup.search_always = true;
  World slow(setup);
  for (World* world : {&fast, &slow}) Play(*world, setup, Belts(setup, -0.1, -0.095), 6.0);
  const Truth a = fast.truth(), b = slow.truth();
  EXPECT_GT(a.contact_peak_n, 0.1);
  EXPECT_LT((a.X_WR.p - b.X_WR.p).norm(), 1e-6);
  EXPECT_LT((a.X_WP.p - b.X_WP.p).norm(), 1e-6);
}

// The reading is off by an error that the drive cannot see: it runs by the reading, the robot turns
// by the truth.
TEST(RaposaWorld, DriveHoldsTheSpeedThatItReadsNotTheTrueOne) {
  WorldSetup setup = AtStart(kAway_m);
  setup.robot.belts.speed_offset = 0.02;
  setup.seed = 3;
  World world(setup);
  Play(world, setup, Belts(setup, 0.1, 0.1), 10.0);
  const Truth truth = world.truth();
  const double radius_m = setup.robot.belts.roller_radius_m;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(truth.motors[static_cast<std::size_t>(i)].angle_rad, 10.0 * 0.1 / radius_m, 0.3);
  }
  EXPECT_GT(std::abs(truth.motors[0].speed_rad_s - truth.motors[1].speed_rad_s), 1e-3);
}

}  // namespace
}  // namespace dockyard::raposa
