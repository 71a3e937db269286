// Loops of links that ties close, and gears, against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

class WorldLinkages : public AtStep {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldLinkages, testing::Values(0.5e-3, 1e-3, 2e-3));

/// Its inertia at the crank, and its height energy, by the crank's angle.
struct SliderCrank {
  double r = 0.1, l = 0.3, crank_kg = 1.0, rod_kg = 0.5, slider_kg = 0.8;

  double Inertia(double angle) const {
    const double sine = r * std::sin(angle) / l, cosine = std::sqrt(1.0 - sine * sine);
    const double tilt = r * std::cos(angle) / (l * cosine);  // of the rod, per angle
    const Vector2d rod(-r * std::sin(angle) - 0.5 * l * sine * tilt, -0.5 * r * std::cos(angle));
    const double slider = -r * std::sin(angle) - l * sine * tilt;
    return crank_kg * r * r / 3.0 + rod_kg * (rod.squaredNorm() + l * l / 12.0 * tilt * tilt) +
           slider_kg * slider * slider;
  }
  double Height(double angle) const {
    return -0.5 * kEarthGravity_m_s2 * r * std::sin(angle) * (crank_kg + rod_kg);
  }
  /// Of the slider, and its change with the angle.
  double Piston(double angle) const {
    const double sine = r * std::sin(angle);
    return r * std::cos(angle) + std::sqrt(l * l - sine * sine);
  }
  double PistonRate(double angle) const {
    const double sine = r * std::sin(angle);
    return -sine - r * std::cos(angle) * sine / std::sqrt(l * l - sine * sine);
  }
  double Rate(double angle, double energy) const {
    return std::sqrt(2.0 * (energy - Height(angle)) / Inertia(angle));
  }
};

TEST_P(WorldLinkages, SliderCrankTurnsAsItsEnergySays) {
  const SliderCrank crank;
  const double start_rad_s = 25.0, seconds = 2.0;
  TreeBody tree({Mount(),
                 JointedLink(0, BoxModel(crank.crank_kg, {crank.r, 0, 0}, {0.5 * crank.r, 0, 0}),
                             {0, 0, 0}, kY),
                 JointedLink(1, BoxModel(crank.rod_kg, {crank.l, 0, 0}, {0.5 * crank.l, 0, 0}),
                             {crank.r, 0, 0}, kY),
                 JointedLink(0, BoxModel(crank.slider_kg, {0.1, 0.1, 0.1}),
                             {crank.r + crank.l, 0, 0}, kX, JointKind::kSlide)},
                {}, {}, kMounted);
  const double energy = 0.5 * crank.Inertia(0.0) * start_rad_s * start_rad_s + crank.Height(0.0);
  // Speeds belong to the middle of steps.
  const double first_rad_s = crank.Rate(-0.5 * step_s() * start_rad_s, energy);
  SetSpeeds(tree, {first_rad_s, -first_rad_s * (1.0 + crank.r / crank.l), 0.0});
  RigidWorld world(kDown);
  world.Add(std::move(tree));
  world.Add(PointTie{.a = {0, 2},
                     .b = {0, 3},
                     .p_A = {crank.l, 0, 0},
                     .stiffness_n_per_m = 1e8,
                     .damping_ns_per_m = 100.0});
  double worst = 0.0, gap_m = 0.0, piston_off_m = 0.0, piston_off_m_s = 0.0;
  for (long i = 0; i < StepsIn(seconds); ++i) {
    world.Step(step_s());
    const TreeBody& at = world.body(0);
    const double rate_rad_s = at.rate_rad_s(1);
    const double middle_rad = at.angle_rad(1) - 0.5 * step_s() * rate_rad_s;
    worst = std::max(worst, std::abs(rate_rad_s / crank.Rate(middle_rad, energy) - 1.0));
    piston_off_m =
        std::max(piston_off_m, std::abs(at.motion(3).X_GL.p.x() - crank.Piston(at.angle_rad(1))));
    gap_m =
        std::max(gap_m, (at.motion(2).X_GL * Vector3d(crank.l, 0, 0) - at.motion(3).X_GL.p).norm());
    if (i == 0) continue;  // a tie bends its path from the second step on, by the gap of the first
    piston_off_m_s = std::max(
        piston_off_m_s, std::abs(at.rate_rad_s(3) - crank.PistonRate(middle_rad) * rate_rad_s));
  }
  using Angle = Eigen::Matrix<double, 1, 1>;
  const Angle wanted = Integrated(
      Angle(0.0), seconds, [&](const Angle& angle) { return Angle(crank.Rate(angle[0], energy)); });
  const double turned = world.body(0).angle_rad(1);
  RecordProperty("off_share", std::to_string(turned / wanted[0] - 1.0));
  RecordProperty("rate_share", std::to_string(worst));
  RecordProperty("gap_um", std::to_string(1e6 * gap_m));
  RecordProperty("piston_share", std::to_string(piston_off_m / crank.r));
  RecordProperty("piston_rate_share", std::to_string(piston_off_m_s / (crank.r * start_rad_s)));
  EXPECT_NEAR(turned, wanted[0], 0.01 * wanted[0]);
  EXPECT_LT(gap_m, 2e-4);
  EXPECT_LT(piston_off_m, 0.01 * crank.r);
  EXPECT_LT(piston_off_m_s, 0.01 * crank.r * start_rad_s);
}

/// Crank and rocker on the ground, a coupler between their ends; bars of even mass. Angles from x.
struct FourBar {
  double ground_m = 0.4, crank_m = 0.1, coupler_m = 0.35, rocker_m = 0.25;
  double crank_kg = 0.3, coupler_kg = 0.8, rocker_kg = 0.6;

  struct Place {
    double coupler_rad, rocker_rad;
    double coupler_per_rad, rocker_per_rad;  // of the crank's
  };
  /// The triangle of rocker, coupler and the line from the rocker's foot to the crank's end.
  Place At(double crank_rad) const {
    const Vector2d end = crank_m * Vector2d(std::cos(crank_rad), std::sin(crank_rad));
    const Vector2d to_end = end - Vector2d(ground_m, 0.0);
    const double far_m = to_end.norm();
    const double inner_rad = std::acos(
        (rocker_m * rocker_m + far_m * far_m - coupler_m * coupler_m) / (2.0 * rocker_m * far_m));
    const double rocker = std::atan2(to_end.y(), to_end.x()) - inner_rad;
    const Vector2d tip =
        Vector2d(ground_m, 0.0) + rocker_m * Vector2d(std::cos(rocker), std::sin(rocker));
    const double coupler = std::atan2(tip.y() - end.y(), tip.x() - end.x());
    return {coupler, rocker,
            crank_m * std::sin(rocker - crank_rad) / (coupler_m * std::sin(coupler - rocker)),
            crank_m * std::sin(coupler - crank_rad) / (rocker_m * std::sin(coupler - rocker))};
  }
  /// At the crank.
  double Inertia(double crank_rad) const {
    const Place at = At(crank_rad);
    const double half_m = 0.5 * coupler_m * at.coupler_per_rad;
    const double turn = at.coupler_rad - crank_rad;
    return crank_kg * crank_m * crank_m / 3.0 +
           rocker_kg * rocker_m * rocker_m / 3.0 * at.rocker_per_rad * at.rocker_per_rad +
           coupler_kg * (crank_m * crank_m + half_m * half_m / 0.75 +
                         2.0 * crank_m * half_m * std::cos(turn));
  }
};

// Without gravity: the rocker's angle by the loop's closing, the crank's rate by the energy.
TEST_P(WorldLinkages, FourBarRocksAsItsLoopClosesAndTurnsAsItsEnergySays) {
  const FourBar bars;
  const double start_rad_s = 8.0, start_rad = 0.5, seconds = 2.0;
  const FourBar::Place start = bars.At(start_rad);
  const auto Bar = [&](int parent, double mass_kg, double length_m, const Vector3d& p_PL) {
    return JointedLink(parent, BoxModel(mass_kg, {length_m, 0, 0}, {0.5 * length_m, 0, 0}), p_PL,
                       kZ);
  };
  TreeBody tree({Mount(), Bar(0, bars.crank_kg, bars.crank_m, {0, 0, 0}),
                 Bar(1, bars.coupler_kg, bars.coupler_m, {bars.crank_m, 0, 0}),
                 Bar(0, bars.rocker_kg, bars.rocker_m, {bars.ground_m, 0, 0})},
                {}, {}, kMounted);
  tree.SetAngle(1, start_rad);
  tree.SetAngle(2, start.coupler_rad - start_rad);
  tree.SetAngle(3, start.rocker_rad);
  const double energy = 0.5 * bars.Inertia(start_rad) * start_rad_s * start_rad_s;
  const auto RateAt = [&](double rad) { return std::sqrt(2.0 * energy / bars.Inertia(rad)); };
  // Speeds belong to the middle of steps.
  const double before_rad = start_rad - 0.5 * step_s() * start_rad_s, first = RateAt(before_rad);
  const FourBar::Place before = bars.At(before_rad);
  SetSpeeds(tree, {first, first * (before.coupler_per_rad - 1.0), first * before.rocker_per_rad});
  RigidWorld world({0, 0, 0});
  world.Add(std::move(tree));
  world.Add(PointTie{.a = {0, 2},
                     .b = {0, 3},
                     .p_A = {bars.coupler_m, 0, 0},
                     .p_B = {bars.rocker_m, 0, 0},
                     .stiffness_n_per_m = 1e8,
                     .damping_ns_per_m = 100.0});
  double off_rad = 0.0, rate_off = 0.0;
  for (long i = 0; i < StepsIn(seconds); ++i) {
    world.Step(step_s());
    const TreeBody& at = world.body(0);
    const double rate_rad_s = at.rate_rad_s(1);
    off_rad = std::max(
        off_rad,
        std::abs(std::remainder(at.angle_rad(3) - bars.At(at.angle_rad(1)).rocker_rad, 2.0 * kPi)));
    const double middle_rad = at.angle_rad(1) - 0.5 * step_s() * rate_rad_s;
    rate_off = std::max(rate_off, std::abs(rate_rad_s / RateAt(middle_rad) - 1.0));
  }
  RecordProperty("rocker_share", std::to_string(off_rad));
  RecordProperty("rate_share", std::to_string(rate_off));
  EXPECT_GT(world.body(0).angle_rad(1), 2.0 * kPi);  // round and round
  EXPECT_LT(off_rad, 1e-3);
  EXPECT_LT(rate_off, 0.01);
}

TreeBody GearTrain() {
  std::vector<TreeLink> links{Mount()};
  for (const double moment : {1e-5, 2e-4, 0.5}) {
    links.push_back(JointedLink(0, TurningModel(1.0, moment, moment), {0, 0, 0}, kZ));
  }
  // The first turns 600 times as fast as the last, in the opposite sense.
  return TreeBody(links, {{{1, 1.0}, {2, -20.0}}, {{2, 1.0}, {3, 30.0}}}, {}, kMounted);
}

TEST_P(WorldLinkages, GearTrainTurnsAsOneInertiaAndFeelsItsFirstShaftsFriction) {
  const double inertia = 0.5 + 900.0 * 2e-4 + 360000.0 * 1e-5, friction_nm = 0.01;
  for (const double load_nm : {5.0, 8.0}) {  // 600 times the friction is 6 N m
    RigidWorld world(kDown);
    world.Add(GearTrain());
    world.Limit({0, 1}, {.friction_nm = friction_nm});
    for (long i = 0; i < StepsIn(1.0); ++i) {
      world.body(0).AddJointTorque(3, load_nm);
      world.Step(step_s());
    }
    const TreeBody& train = world.body(0);
    const double wanted = std::max(0.0, load_nm - 600.0 * friction_nm) / inertia;
    EXPECT_NEAR(train.rate_rad_s(3), wanted, 1e-6 * wanted + 1e-12);
    EXPECT_NEAR(train.angle_rad(1), -600.0 * train.angle_rad(3), 1e-9);
  }
}

// n torque / (J2 + n^2 J1), at the second shaft; a tie is exact, so no step is too long for it.
TEST_P(WorldLinkages, GearTrainFeelsTheMotorsInertiaByTheSquareOfItsRatio) {
  const double ratio = 600.0, first_kg_m2 = 1e-5, last_kg_m2 = 0.5, torque_nm = 0.02;
  TreeBody train(
      {Mount(), JointedLink(0, TurningModel(1.0, first_kg_m2, first_kg_m2), {0, 0, 0}, kZ),
       JointedLink(0, TurningModel(1.0, last_kg_m2, last_kg_m2), {0, 0, 0}, kZ)},
      {{{1, 1.0}, {2, -ratio}}}, {}, kMounted);
  RigidWorld world(kDown);
  world.Add(std::move(train));
  for (long i = 0; i < StepsIn(1.0); ++i) {
    world.body(0).AddJointTorque(1, torque_nm);
    world.Step(step_s());
  }
  const double wanted = ratio * torque_nm / (last_kg_m2 + ratio * ratio * first_kg_m2);
  EXPECT_NEAR(world.body(0).rate_rad_s(2), wanted, 1e-9 * wanted);
  EXPECT_NEAR(world.body(0).angle_rad(2), 0.5 * wanted * (1.0 + step_s()), 1e-9 * wanted);
}

}  // namespace
}  // namespace dockyard
