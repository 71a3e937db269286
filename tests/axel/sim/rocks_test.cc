// A balanced rover on rocks alone, against closed forms of statics.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>

#include "axel/sim/product.h"
#include "axel/sim/rock_block.h"
#include "sim/axel/contact_world.h"
#include "sim/base/random.h"
#include "sim/rigid/rocks.h"

namespace dockyard::axel {
namespace {

constexpr double kG = 9.81, kRadius = 0.265;

/// A rover with smooth wheels, balanced on its axle, on rocks alone; nothing drives it.
struct OnRocks {
  OnRocks(std::vector<ConvexBody> rocks, double z_m, double friction, double step_s = 1e-3,
          const WheelModel& wheel = {.rim_radius_m = kRadius, .width_m = 0.15})
      : OnRocks(std::move(rocks), Pose3::Translation(0.0, 0.0, z_m), friction, step_s, wheel) {}
  OnRocks(std::vector<ConvexBody> rocks, const Pose3& X_GR, double friction, double step_s,
          const WheelModel& wheel)
      : step(step_s) {
    model.body.p_LoCom_L.setZero();
    model.arm.p_LoCom_L.setZero();
    for (MotorModel& motor : model.motors) motor.reflected_inertia_kg_m2 = 1e-9;
    model.left_wheel_soil = model.right_wheel_soil = wheel;
    rover.emplace(rigid, model, X_GR, 0.0, false);
    world.emplace(rigid, model, Station(), *rover, station);
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
    for (int i = 0; i < kOwnLinkCount; ++i) {
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
  RigidWorld rigid{{0.0, 0.0, -kG}};
  StationBody station{rigid, Station(), Pose3::Translation(-50.0, 0.0, 0.0)};
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
  std::printf("carries %.3f of %.3f N, %.4f mm deep\n", rig.world->rock_force_G().z(), rig.Weight(),
              1e3 * (kRadius - rig.body().X_GL.p.z()));
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
  // Put down along the facet.
  OnRocks rig({X_GF * Floor()}, X_GF * Pose3::Translation(0.0, 0.0, kRadius - 3e-4), friction, 1e-3,
              {.rim_radius_m = kRadius, .width_m = 0.15});
  rig.Play(0.5);
  const double before = rig.body().v_GL_G.norm();
  rig.Play(0.5);
  return (rig.body().v_GL_G.norm() - before) / 0.5;
}

TEST(Rocks, HoldOnAFacetUpToTheFrictionAngleAndSlideBeyondIt) {
  const double friction = 0.5;  // 26.6 deg
  const double held = SlideDown(Radians(25.0), friction);
  std::printf("25 deg: %.1e m/s^2\n", held);
  EXPECT_NEAR(held, 0.0, 1e-3);
  for (const double deg : {29.0, 35.0}) {
    const double expected = kG * (std::sin(Radians(deg)) - friction * std::cos(Radians(deg)));
    const double found = SlideDown(Radians(deg), friction);
    std::printf("%.0f deg: %.4f, by statics %.4f m/s^2\n", deg, found, expected);
    EXPECT_NEAR(found, expected, 0.03 * expected) << deg;
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
  double most_gain = -1e9, most_left = -1e9;
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
      most_gain = std::max(most_gain, most - start);
      most_left = std::max(most_left, lowest_peak - start);
      EXPECT_LE(most, start + 1e-6 * start) << key << ' ' << step_s;
      EXPECT_LT(lowest_peak, start - 20.0);  // it fell by some centimetres
    }
  }
  std::printf("gains at most %.1e J, ends at least %.1f J lower\n", most_gain, -most_left);
}

}  // namespace
}  // namespace dockyard::axel
