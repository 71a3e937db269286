// Motion of a world's bodies where nothing touches: pendulum, gyroscope, free flight, loops and
// gears, against closed forms and integrations of their own.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

class WorldMotion : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldMotion, testing::Values(0.5e-3, 1e-3, 2e-3));

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

/// Two bars of 0.5 m, which hang from hinges; angles from the vertical.
struct DoublePendulum {
  double m1 = 1.0, m2 = 0.7, l = 0.5, c = 0.25;
  double I1 = m1 * l * l / 12.0, I2 = m2 * l * l / 12.0;

  Vector4d Rate(const Vector4d& s) const {
    const double turn = s[0] - s[1], g = kEarthGravity_m_s2;
    Eigen::Matrix2d M;
    M << I1 + m1 * c * c + m2 * l * l, m2 * l * c * std::cos(turn), m2 * l * c * std::cos(turn),
        I2 + m2 * c * c;
    const double pull = m2 * l * c * std::sin(turn);
    const Vector2d load(-pull * s[3] * s[3] - (m1 * c + m2 * l) * g * std::sin(s[0]),
                        pull * s[2] * s[2] - m2 * c * g * std::sin(s[1]));
    const Vector2d acceleration = M.inverse() * load;
    return {s[2], s[3], acceleration[0], acceleration[1]};
  }
  double Energy(const Vector4d& s) const {
    const double turn = s[0] - s[1], g = kEarthGravity_m_s2;
    return 0.5 * (I1 + m1 * c * c + m2 * l * l) * s[2] * s[2] +
           0.5 * (I2 + m2 * c * c) * s[3] * s[3] + m2 * l * c * std::cos(turn) * s[2] * s[3] -
           (m1 * c + m2 * l) * g * std::cos(s[0]) - m2 * c * g * std::cos(s[1]);
  }
};

TEST_P(WorldMotion, DoublePendulumSwingsAsItsEquationsSayAndKeepsItsEnergy) {
  const DoublePendulum pendulum;
  const Vector3d com(0.0, 0.0, -pendulum.c), size(0.0, 0.0, pendulum.l);
  TreeBody tree({Mount(), JointedLink(0, BoxModel(pendulum.m1, size, com), {0, 0, 0}, kY),
                 JointedLink(1, BoxModel(pendulum.m2, size, com), {0, 0, -pendulum.l}, kY)},
                {}, {}, kMounted);
  tree.SetAngle(1, 0.6);
  tree.SetAngle(2, -1.0);
  // Speeds belong to the middle of steps: the first to half a step before the start at rest.
  const Vector4d start(0.6, -0.4, 0.0, 0.0), first = -0.5 * GetParam() * pendulum.Rate(start);
  SetSpeeds(tree, {first[2], first[3] - first[2]});
  RigidWorld world(kDown);
  world.Add(std::move(tree));
  const auto State = [&] {
    const TreeBody& at = world.body(0);
    return Vector4d(at.angle_rad(1), at.angle_rad(1) + at.angle_rad(2), at.rate_rad_s(1),
                    at.rate_rad_s(1) + at.rate_rad_s(2));
  };
  const double highest = pendulum.Energy(start) - pendulum.Energy(Vector4d::Zero());
  double drift = 0.0;
  for (long i = 0; i < std::lround(2.0 / GetParam()); ++i) {
    Vector4d at = State();
    world.Step(GetParam());
    at.tail<2>() = 0.5 * (at + State()).tail<2>();
    drift = std::max(drift, std::abs(pendulum.Energy(at) - pendulum.Energy(start)));
  }
  const Vector4d wanted =
      Integrated(start, 2.0, [&](const Vector4d& s) { return pendulum.Rate(s); });
  const double off = (State() - wanted).head<2>().lpNorm<Eigen::Infinity>();
  RecordProperty("off_share", std::to_string(off / 0.6));
  RecordProperty("energy_share", std::to_string(drift / highest));
  EXPECT_LT(off, 0.01 * 0.6);
  EXPECT_LT(drift, 0.01 * highest);
}

// A disc that spins about a level axle whose one end is held: m g l / (C s) about the vertical.
TEST_P(WorldMotion, GyroscopePrecessesByWeightOverSpin) {
  const double mass_kg = 1.0, arm_m = 0.1, moment = 0.01, spin_rad_s = 100.0;
  const double wanted_rad_s = mass_kg * kEarthGravity_m_s2 * arm_m / (moment * spin_rad_s);
  RigidWorld world(kDown);
  TreeBody disc = FreeBody(TurningModel(mass_kg, moment, 0.5 * moment, {0.0, 0.0, arm_m}),
                           {RotY(0.5 * kPi), Vector3d::Zero()});
  SetSpeeds(disc, {0.0, wanted_rad_s * arm_m, 0.0, spin_rad_s, 0.0, wanted_rad_s});
  world.Add(std::move(disc));
  world.Add(PointTie{.a = {0, 0}, .stiffness_n_per_m = 1e7, .damping_ns_per_m = 100.0});
  for (long i = 0; i < std::lround(1.0 / GetParam()); ++i) world.Step(GetParam());
  const Vector3d axle = world.body(0).motion(0).X_GL.R.col(2);
  const double rate_rad_s = std::atan2(axle.y(), axle.x());
  RecordProperty("off_share", std::to_string(rate_rad_s / wanted_rad_s - 1.0));
  EXPECT_NEAR(rate_rad_s, wanted_rad_s, 0.01 * wanted_rad_s);
  EXPECT_NEAR(axle.z(), 0.0, 0.01);
  EXPECT_LT(world.body(0).motion(0).X_GL.p.norm(), 1e-4);
}

// Euler's equations in the body's axes.
TEST_P(WorldMotion, TumblingBodyKeepsItsMomentumAndFollowsEuler) {
  const LinkModel model = BoxModel(2.0, {0.1, 0.3, 0.5}, {0.05, -0.02, 0.1});
  const Vector3d moments = model.I_LCom_L.diagonal(), start_rad_s(0.5, 4.0, 0.3);
  RigidWorld world({0, 0, 0});
  TreeBody body = FreeBody(model, {});
  SetSpeeds(body, {0.1, 0.2, 0.3, start_rad_s.x(), start_rad_s.y(), start_rad_s.z()});
  const double energy = body.KineticEnergy();
  world.Add(std::move(body));
  for (long i = 0; i < std::lround(2.0 / GetParam()); ++i) world.Step(GetParam());
  const LinkMotion& motion = world.body(0).motion(0);
  const Vector3d w_L = motion.X_GL.R.transpose() * motion.w_GL_G;
  const Vector3d spin = motion.X_GL.R * moments.cwiseProduct(w_L);
  EXPECT_LT((spin - moments.cwiseProduct(start_rad_s)).norm(), 1e-12);
  EXPECT_NEAR(world.body(0).KineticEnergy(), energy, 1e-3 * energy);
  const Vector3d wanted = Integrated(start_rad_s, 2.0, [&](const Vector3d& w) {
    return Vector3d(moments.cwiseProduct(w).cross(w).cwiseQuotient(moments));
  });
  RecordProperty("off_share", std::to_string((w_L - wanted).norm() / wanted.norm()));
  EXPECT_LT((w_L - wanted).norm(), 0.01 * wanted.norm());
}

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
  double Rate(double angle, double energy) const {
    return std::sqrt(2.0 * (energy - Height(angle)) / Inertia(angle));
  }
};

TEST_P(WorldMotion, SliderCrankTurnsAsItsEnergySays) {
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
  const double first_rad_s = crank.Rate(-0.5 * GetParam() * start_rad_s, energy);
  SetSpeeds(tree, {first_rad_s, -first_rad_s * (1.0 + crank.r / crank.l), 0.0});
  RigidWorld world(kDown);
  world.Add(std::move(tree));
  world.Add(PointTie{.a = {0, 2},
                     .b = {0, 3},
                     .p_A = {crank.l, 0, 0},
                     .stiffness_n_per_m = 1e8,
                     .damping_ns_per_m = 100.0});
  double worst = 0.0, gap_m = 0.0;
  for (long i = 0; i < std::lround(seconds / GetParam()); ++i) {
    world.Step(GetParam());
    const TreeBody& at = world.body(0);
    const double rate_rad_s = at.rate_rad_s(1);
    const double wanted_rad_s = crank.Rate(at.angle_rad(1) - 0.5 * GetParam() * rate_rad_s, energy);
    worst = std::max(worst, std::abs(rate_rad_s / wanted_rad_s - 1.0));
    gap_m =
        std::max(gap_m, (at.motion(2).X_GL * Vector3d(crank.l, 0, 0) - at.motion(3).X_GL.p).norm());
  }
  using Angle = Eigen::Matrix<double, 1, 1>;
  const Angle wanted = Integrated(
      Angle(0.0), seconds, [&](const Angle& angle) { return Angle(crank.Rate(angle[0], energy)); });
  const double turned = world.body(0).angle_rad(1);
  RecordProperty("off_share", std::to_string(turned / wanted[0] - 1.0));
  RecordProperty("rate_share", std::to_string(worst));
  RecordProperty("gap_um", std::to_string(1e6 * gap_m));
  EXPECT_NEAR(turned, wanted[0], 0.01 * wanted[0]);
  EXPECT_LT(gap_m, 2e-4);
}

TreeBody GearTrain() {
  std::vector<TreeLink> links{Mount()};
  for (const double moment : {1e-5, 2e-4, 0.5}) {
    links.push_back(JointedLink(0, TurningModel(1.0, moment, moment), {0, 0, 0}, kZ));
  }
  // The first turns 600 times as fast as the last, in the opposite sense.
  return TreeBody(links, {{{1, 1.0}, {2, -20.0}}, {{2, 1.0}, {3, 30.0}}}, {}, kMounted);
}

TEST_P(WorldMotion, GearTrainTurnsAsOneInertiaAndFeelsItsFirstShaftsFriction) {
  const double inertia = 0.5 + 900.0 * 2e-4 + 360000.0 * 1e-5, friction_nm = 0.01;
  for (const double load_nm : {5.0, 8.0}) {  // 600 times the friction is 6 N m
    RigidWorld world(kDown);
    world.Add(GearTrain());
    world.Limit({0, 1}, {.friction_nm = friction_nm});
    for (long i = 0; i < std::lround(1.0 / GetParam()); ++i) {
      world.body(0).AddJointTorque(3, load_nm);
      world.Step(GetParam());
    }
    const TreeBody& train = world.body(0);
    const double wanted = std::max(0.0, load_nm - 600.0 * friction_nm) / inertia;
    EXPECT_NEAR(train.rate_rad_s(3), wanted, 1e-6 * wanted + 1e-12);
    EXPECT_NEAR(train.angle_rad(1), -600.0 * train.angle_rad(3), 1e-9);
  }
}

TEST_P(WorldMotion, JointRestsOnItsStopAsDeepAsItsSpringSays) {
  RigidWorld world(kDown);
  world.Add(
      TreeBody({Mount(), JointedLink(0, BoxModel(1.0, {0.4, 0, 0}, {0.2, 0, 0}), {0, 0, 0}, kY)},
               {}, {}, kMounted));
  world.Limit({0, 1}, {.high_rad = 0.0, .stop_nm_per_rad = 1e4, .stop_nms_per_rad = 20.0});
  for (long i = 0; i < std::lround(1.0 / GetParam()); ++i) world.Step(GetParam());
  EXPECT_NEAR(world.body(0).angle_rad(1), 0.2 * kEarthGravity_m_s2 / 1e4, 1e-9);
}

TEST_P(WorldMotion, JointsDamperSlowsItExponentially) {
  const double moment = 0.2, damping = 0.5;
  TreeLink rotor = JointedLink(0, TurningModel(1.0, moment, moment), {0, 0, 0}, kZ);
  rotor.damping_nms_per_rad = damping;
  TreeBody tree({Mount(), rotor}, {}, {}, kMounted);
  SetSpeeds(tree, {3.0});
  RigidWorld world(kDown);
  world.Add(std::move(tree));
  for (long i = 0; i < std::lround(0.4 / GetParam()); ++i) world.Step(GetParam());
  const double wanted = 3.0 * std::exp(-0.4 * damping / moment);
  EXPECT_NEAR(world.body(0).rate_rad_s(1), wanted, 0.01 * wanted);
}

// The time of five swings, by where the joint passes the angle at which its spring is free.
double PeriodOf(TreeBody tree, double rest_rad, double step_s) {
  RigidWorld world(Vector3d::Zero());
  world.Add(std::move(tree));
  std::vector<double> passed_s;
  double before_rad = world.body(0).angle_rad(1) - rest_rad;
  for (long i = 0; passed_s.size() < 11; ++i) {
    world.Step(step_s);
    const double now_rad = world.body(0).angle_rad(1) - rest_rad;
    if ((now_rad > 0.0) != (before_rad > 0.0)) {
      const double share = before_rad / (before_rad - now_rad);
      passed_s.push_back((static_cast<double>(i) + share) * step_s);
    }
    before_rad = now_rad;
  }
  return (passed_s.back() - passed_s.front()) / 5.0;
}

TEST_P(WorldMotion, JointSwingsOnItsSpringAtItsPeriod) {
  const double moment = 0.2, mass_kg = 3.0, rate_rad_s = 20.0, rest = 0.3;
  for (const JointKind kind : {JointKind::kHinge, JointKind::kSlide}) {
    TreeLink rotor = JointedLink(0, TurningModel(mass_kg, moment, moment), {0, 0, 0}, kZ, kind);
    rotor.stiffness_nm_per_rad = (rotor.IsHinge() ? moment : mass_kg) * rate_rad_s * rate_rad_s;
    rotor.rest_rad = rest;
    for (const TreeRules& rules : {kMounted, TreeRules{TreeBase::kFixed}}) {
      const double wanted = 2.0 * kPi / rate_rad_s;
      EXPECT_NEAR(PeriodOf(TreeBody({Mount(), rotor}, {}, {}, rules), rest, GetParam()), wanted,
                  0.01 * wanted);
    }
  }
}

// The stiffer spring would swing many times within a step.
TEST_P(WorldMotion, JointHangsOnItsSpringByTheLoadOverItsStiffness) {
  const double mass_kg = 3.0, weight_n = mass_kg * kEarthGravity_m_s2;
  for (const double stiffness_n_per_m : {300.0, 1e7}) {
    TreeLink hung =
        JointedLink(0, BoxModel(mass_kg, {0.1, 0.1, 0.1}), {0, 0, 0}, kZ, JointKind::kSlide);
    hung.stiffness_nm_per_rad = stiffness_n_per_m;
    hung.damping_nms_per_rad = std::sqrt(mass_kg * stiffness_n_per_m);
    hung.rest_rad = 0.05;
    RigidWorld world(kDown);
    world.Add(TreeBody({Mount(), hung}, {}, {}, kMounted));
    for (long i = 0; i < std::lround(3.0 / GetParam()); ++i) world.Step(GetParam());
    const double wanted = weight_n / stiffness_n_per_m;
    EXPECT_NEAR(0.05 - world.body(0).angle_rad(1), wanted, 1e-4 * wanted);
  }
}

}  // namespace
}  // namespace dockyard
