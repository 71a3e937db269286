// The rover on rocks: against closed forms of statics, and its own invariances.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>

#include "axel/sim/product.h"
#include "sim/axel/contact_world.h"
#include "sim/base/random.h"
#include "sim/physics/rocks.h"

namespace dockyard::axel {
namespace {

constexpr double kG = 9.81, kRadius = 0.265;

/// A block with its top at z, between two corners.
ConvexBody Block(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double top_m) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                        i & 4 ? top_m : top_m - 0.5);
  }
  return HullOf(points);
}

/// A rover with smooth wheels, balanced on its axle, on rocks alone; nothing drives it.
struct OnRocks {
  OnRocks(std::vector<ConvexBody> rocks, double z_m, double friction, double step_s = 1e-3,
          const WheelModel& wheel = {.rim_radius_m = kRadius, .width_m = 0.15})
      : step(step_s) {
    model.body.p_LoCom_L.setZero();
    model.arm.p_LoCom_L.setZero();
    for (MotorModel& motor : model.motors) motor.reflected_inertia_kg_m2 = 1e-9;
    model.left_wheel_soil = model.right_wheel_soil = wheel;
    rover.emplace(model, Pose3::Translation(0.0, 0.0, z_m), 0.0, false);
    world.emplace(Station().cone, Eigen::Vector3d(0.0, 0.0, -kG), *rover, station);
    world->PutRocks(model, {std::move(rocks), friction});
  }
  void Step() { world->Step(step); }
  void Play(double seconds) {
    for (long i = 0; i < std::lround(seconds / step); ++i) Step();
  }
  const LinkMotion& body() const { return rover->motion(RoverLink::kBody); }
  double Weight() const { return model.mass_kg() * kG; }
  /// Kinetic and of height.
  double Energy() const {
    double sum = 0.0;
    for (int i = 0; i < kRoverLinkCount; ++i) {
      const RoverLink link = static_cast<RoverLink>(i);
      const LinkMotion& motion = rover->motion(link);
      const LinkModel& part = LinkOf(model, link);
      const Eigen::Vector3d com = rover->CentreOfMass(link);
      const Eigen::Vector3d w = motion.X_GL.R.transpose() * motion.w_GL_G;
      sum += 0.5 * part.mass_kg * motion.VelocityAt(com).squaredNorm() +
             0.5 * w.dot(part.I_LCom_L * w) + part.mass_kg * kG * com.z();
    }
    return sum;
  }

  double step;
  RoverModel model = Axel();
  StationBody station{Station(), Pose3::Translation(-50.0, 0.0, 0.0)};
  std::optional<RoverBody> rover;
  std::optional<ContactWorld> world;
};

const ConvexBody& Floor() {
  static const ConvexBody floor = Block({-5.0, -5.0}, {5.0, 5.0}, 0.0);
  return floor;
}

TEST(Rocks, CarryTheRoversWeight) {
  OnRocks rig({Floor()}, kRadius + 1e-3, 0.6);
  rig.Play(1.0);
  EXPECT_NEAR(rig.world->rock_force_G().z(), rig.Weight(), 1e-4 * rig.Weight());
  EXPECT_LT(rig.world->rock_force_G().head<2>().norm(), 1e-6 * rig.Weight());
  // Pressed in by its weight over the stiffness of both wheels.
  EXPECT_NEAR(kRadius - rig.body().X_GL.p.z(), rig.Weight() / (2.0 * 5e5), 2e-5);
}

/// The horizontal force at the axle that lifts smooth wheels over a step [N].
double ForceOverAStep(double step_m, double expected_n, double step_s) {
  const double reach_m = std::sqrt(step_m * (2.0 * kRadius - step_m));
  OnRocks rig({Floor(), Block({reach_m + 5e-4, -2.0}, {2.0, 2.0}, step_m)}, kRadius, 0.8, step_s);
  // Slowly, so that what it gains in speed counts for nothing: 4 N/s from nine tenths on.
  double force_n = 5.0;
  for (long i = 0; i < std::lround(60.0 / step_s); ++i) {
    if (static_cast<double>(i) * step_s > 1.0) {
      force_n += (force_n < 0.9 * expected_n ? 50.0 : 4.0) * step_s;
    }
    rig.rover->AddForce(RoverLink::kBody, {force_n, 0.0, 0.0}, rig.body().X_GL.p);
    rig.Step();
    if (rig.body().X_GL.p.z() > kRadius + 1e-3) return force_n;
  }
  return 0.0;
}

TEST(Rocks, AStepTakesThePullThatStaticsGive) {
  // Moments about the edge: F (R - h) = W sqrt(h (2 R - h)).
  for (const double step_m : {0.02, 0.04, 0.08}) {
    const double weight_n = Axel().mass_kg() * kG;
    const double expected =
        weight_n * std::sqrt(step_m * (2.0 * kRadius - step_m)) / (kRadius - step_m);
    const double found = ForceOverAStep(step_m, expected, 1e-3);
    std::printf("step of %.0f mm: %.1f N, by statics %.1f N\n", 1e3 * step_m, found, expected);
    EXPECT_NEAR(found, expected, 0.02 * expected);
  }
}

/// Acceleration along the fall line of a facet that tilts to the rover's side [m/s^2].
double SlideDown(double tilt_rad, double friction) {
  const Pose3 X_GF{RotX(tilt_rad), Eigen::Vector3d::Zero()};
  OnRocks rig({X_GF * Floor()}, 0.0, friction);
  // Put down along the facet.
  RoverBody& rover = *rig.rover;
  const Pose3 X_GR = X_GF * Pose3::Translation(0.0, 0.0, kRadius - 3e-4);
  rover.multibody()->setBasePos({X_GR.p.x(), X_GR.p.y(), X_GR.p.z()});
  const Eigen::Quaterniond q(X_GR.R.transpose());
  rover.multibody()->setWorldToBaseRot({q.x(), q.y(), q.z(), q.w()});
  rover.Refresh();
  rig.Play(0.5);
  const double before = rig.body().v_GL_G.norm();
  rig.Play(0.5);
  return (rig.body().v_GL_G.norm() - before) / 0.5;
}

TEST(Rocks, HoldOnAFacetUpToTheFrictionAngleAndSlideBeyondIt) {
  const double friction = 0.5;  // 26.6 deg
  EXPECT_NEAR(SlideDown(Radians(25.0), friction), 0.0, 1e-3);
  for (const double deg : {29.0, 35.0}) {
    const double expected = kG * (std::sin(Radians(deg)) - friction * std::cos(Radians(deg)));
    EXPECT_NEAR(SlideDown(Radians(deg), friction), expected, 0.03 * expected) << deg;
  }
}

std::vector<ConvexBody> SomeRocks(std::uint64_t key, bool mirrored) {
  RockField field;
  field.cover = 0.2;
  std::vector<ConvexBody> rocks{Floor()};
  for (const Rock& rock : PlaceRocks(field, {-1.5, 1.5, -1.0, 1.0}, {}, key)) {
    rocks.push_back(rock.body);
    if (!mirrored) continue;
    for (Eigen::Vector3d& p : rocks.back().vertices) p.y() = -p.y();
    rocks.back() = HullOf(rocks.back().vertices);
  }
  return rocks;
}

TEST(Rocks, GiveNoEnergyToARoverThatFallsOnThem) {
  WheelModel wheel = Axel().left_wheel_soil;
  for (const double step_s : {2e-3, 1e-3, 0.5e-3}) {
    for (std::uint64_t key = 1; key <= 3; ++key) {
      OnRocks rig(SomeRocks(key, false), 0.55, 0.6, step_s, wheel);
      const double start = rig.Energy();
      double most = start, lowest_peak = start;
      for (int i = 0; i < 20; ++i) {
        double peak = -1e9;
        for (long k = 0; k < std::lround(0.2 / step_s); ++k) {
          rig.Step();
          peak = std::max(peak, rig.Energy());
        }
        most = std::max(most, peak);
        // From one fifth of a second to the next it falls, but for what the springs hold.
        EXPECT_LT(peak, lowest_peak + 0.5) << key << ' ' << step_s;
        lowest_peak = std::min(lowest_peak, peak);
      }
      EXPECT_LE(most, start + 1e-6 * start) << key << ' ' << step_s;
      EXPECT_LT(lowest_peak, start - 20.0);  // it fell by some centimetres
    }
  }
}

/// A rover whose left wheel starts on an 8 cm rock, or drives over it from 0.5 m before.
WorldSetup WithRock(double ahead_m, double height_m = 0.08, double side = 1.0) {
  WorldSetup setup = TestSetup(CompactGravel(), {3.5, 0.0, kPi});
  setup.slack_start_m = 0.05;
  // The rover heads to -x, so that its left is at -y.
  setup.rocks.rocks = {Pose3::Translation(3.5 - ahead_m, -0.425 * side, 0.0) *
                       RockShape({0.25, height_m}, 0.3, 0.0, 5)};
  return setup;
}

TEST(Rocks, AWheelThatStartsOnOneRollsTheRoverByItsHeight) {
  for (const double height_m : {0.04, 0.08}) {
    World world(WithRock(0.0, height_m));
    const Truth truth = world.truth();
    // Against level ground: the other wheel sinks by some millimetres, and a paddle's tip may
    // stand where its neighbours' chord does not.
    const double sag_m = 0.3 * (1.0 - std::cos(kPi / 12.0));
    const double roll = ToRollPitchYaw(truth.X_WR.R).roll, expected = std::asin(height_m / 0.85);
    std::printf("on a rock of %.0f mm: roll %.2f deg, by geometry %.2f deg\n", 1e3 * height_m,
                Degrees(roll), Degrees(expected));
    EXPECT_NEAR(roll, expected, (sag_m + 0.004) / 0.85);
    // It stands: the rock carries that wheel.
    EXPECT_GT(truth.rock_force_n, 0.35 * Axel().mass_kg() * kG);
    EXPECT_LT(truth.left_wheel_load_n, 5.0);
    EXPECT_GT(truth.right_wheel_load_n, 0.35 * Axel().mass_kg() * kG);
    EXPECT_NEAR(truth.X_DR.p.x(), 3.5, 0.05);  // the arm falls to the ground and turns the wheels
  }
}

TEST(Rocks, ShareTheWeightWithTheSoil) {
  World world(WithRock(0.0));
  const Truth truth = world.truth();
  const double weight = Axel().mass_kg() * kG;
  // What is missing stands on the arm's tip; its friction and the wheels' act along the ground.
  EXPECT_NEAR(truth.rock_force_n + truth.left_wheel_load_n + truth.right_wheel_load_n +
                  truth.tip_ground_force_n,
              weight, 0.02 * weight);
}

Truth DriveOver(double step_s, double seconds, const WorldSetup& with = WithRock(0.45)) {
  WorldSetup setup = with;
  setup.step_s = step_s;
  World world(setup);
  Play(world, Drive(0.17, 0.0), seconds, step_s);
  return world.truth();
}

TEST(Rocks, AWheelClimbsOneOfEightCentimetresAndRollsOverItsTop) {
  World world(WithRock(0.45));
  double highest_m = 0.0;
  for (int i = 0; i < 250; ++i) {
    Play(world, Drive(0.17, 0.0), 0.1);
    highest_m = std::max(highest_m, world.truth().X_W_left_wheel.p.z());
  }
  const Truth truth = world.truth();
  std::printf("left wheel up to %.3f m, now at x %.2f m, largest force %.0f N\n", highest_m,
              truth.X_DR.p.x(), truth.rock_force_peak_n);
  EXPECT_NEAR(highest_m, 0.08 + 0.30, 5e-3);  // on a paddle's tip
  EXPECT_EQ(truth.rock_force_n, 0.0);
  EXPECT_NEAR(truth.X_W_left_wheel.p.z(), truth.X_W_right_wheel.p.z(), 0.015);
}

TEST(Rocks, TheWayOverOneIsTheSameAtEachStep) {
  const Truth coarse = DriveOver(2e-3, 12.0), middle = DriveOver(1e-3, 12.0),
              fine = DriveOver(0.5e-3, 12.0);
  for (const Truth* t : {&coarse, &middle, &fine}) {
    std::printf("x %.5f y %.5f m, heading %.3f deg, roll %.3f deg, peak %.1f N\n", t->X_DR.p.x(),
                t->X_DR.p.y(), Degrees(ToGround(t->X_DR).heading),
                Degrees(ToRollPitchYaw(t->X_WR.R).roll), t->rock_force_peak_n);
  }
  for (const Truth* t : {&coarse, &middle}) {
    EXPECT_NEAR(t->X_DR.p.x(), fine.X_DR.p.x(), 2e-3);
    EXPECT_NEAR(t->X_DR.p.y(), fine.X_DR.p.y(), 2e-3);
    EXPECT_NEAR(ToGround(t->X_DR).heading, ToGround(fine.X_DR).heading, Radians(0.3));
    EXPECT_NEAR(t->rock_force_peak_n, fine.rock_force_peak_n, 0.02 * fine.rock_force_peak_n);
  }
}

TEST(Rocks, SameCallsGiveTheSameBits) {
  const WorldSetup setup = WithRock(0.45);
  World a(setup), b(setup);
  Play(a, Drive(0.17, 0.0), 10.0);
  Play(b, Drive(0.17, 0.0), 10.0);
  EXPECT_GT(a.truth().rock_force_peak_n, 50.0);
  EXPECT_EQ(a.StateHash(1), b.StateHash(1));
}

TEST(Rocks, MirroredOnesMirrorTheMotion) {
  WorldSetup setup = WithRock(0.45);
  setup.rover.left_wheel_soil.phase_rad = 0.1;
  setup.rover.right_wheel_soil.phase_rad = 0.23;
  WorldSetup mirrored = setup;
  std::swap(mirrored.rover.left_wheel_soil.phase_rad, mirrored.rover.right_wheel_soil.phase_rad);
  mirrored.add_right_side_first = true;
  for (Eigen::Vector3d& p : mirrored.rocks.rocks[0].vertices) p.y() = -p.y();
  mirrored.rocks.rocks[0] = HullOf(mirrored.rocks.rocks[0].vertices);
  World a(setup), b(mirrored);
  for (int i = 0; i < 6; ++i) {
    Play(a, Drive(0.17, 0.0), 1.0);
    Play(b, Drive(0.17, 0.0), 1.0);
    const Truth left = a.truth(), right = b.truth();
    EXPECT_NEAR(left.X_DR.p.x(), right.X_DR.p.x(), 1e-4) << i;
    EXPECT_NEAR(left.X_DR.p.y(), -right.X_DR.p.y(), 1e-4) << i;
    EXPECT_NEAR(ToRollPitchYaw(left.X_WR.R).roll, -ToRollPitchYaw(right.X_WR.R).roll, 1e-4) << i;
  }
  EXPECT_GT(a.truth().rock_force_peak_n, 50.0);
}

TEST(Rocks, CarryTheArmsTip) {
  WorldSetup setup = TestSetup(CompactGravel(), {3.5, 0.0, kPi});
  setup.rocks.rocks = {Block({3.5 - 1.1, -0.2}, {3.5 - 0.8, 0.2}, 0.15)};
  World world(setup);
  Play(world, AllBraked(), 1.0);
  const Truth truth = world.truth();
  EXPECT_EQ(truth.tip_ground_force_n, 0.0);
  // The net nose-down moment of 10.2 N m about the axle (axel.urdf) over the metre to the tip, less
  // what the braked wheels hold on the soil.
  EXPECT_GT(truth.rock_force_n, 5.0);
  EXPECT_LT(truth.rock_force_n, 10.2);
  const Eigen::Vector3d tip_W = truth.X_WA * Eigen::Vector3d(setup.rover.arm_length_m, 0.0, 0.0);
  EXPECT_NEAR(tip_W.z(), 0.15 + setup.rover.tip.radius_m, 0.01);
}

TEST(Rocks, FarAwayChangeNothing) {
  WorldSetup setup = TestSetup(CompactGravel(), {3.5, 0.0, kPi}), with = setup;
  with.rocks.rocks = {Pose3::Translation(6.0, 2.0, 0.0) * RockShape({0.25, 0.1}, 0.3, 0.0, 5)};
  World a(setup), b(with);
  Play(a, Drive(0.17, 0.0), 3.0);
  Play(b, Drive(0.17, 0.0), 3.0);
  EXPECT_EQ(a.StateHash(1), b.StateHash(1));
}

}  // namespace
}  // namespace dockyard::axel
