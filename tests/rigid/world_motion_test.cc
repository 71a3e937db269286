// Free flight, and joints with stops and dampers, against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

class WorldMotion : public AtStep {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldMotion, testing::Values(0.5e-3, 1e-3, 2e-3));

const Vector3d kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

// Euler's equations in the body's axes.
TEST_P(WorldMotion, TumblingBodyKeepsItsMomentumAndFollowsEuler) {
  const LinkModel model = BoxModel(2.0, {0.1, 0.3, 0.5}, {0.05, -0.02, 0.1});
  const Vector3d moments = model.I_LCom_L.diagonal(), start_rad_s(0.5, 4.0, 0.3);
  RigidWorld world({0, 0, 0});
  TreeBody body = FreeBody(model, {});
  SetSpeeds(body, {0.1, 0.2, 0.3, start_rad_s.x(), start_rad_s.y(), start_rad_s.z()});
  const double energy = body.KineticEnergy();
  world.Add(std::move(body));
  for (long i = 0; i < StepsIn(2.0); ++i) world.Step(step_s());
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

TEST_P(WorldMotion, JointRestsOnItsStopAsDeepAsItsSpringSays) {
  RigidWorld world(kDown);
  world.Add(
      TreeBody({Mount(), JointedLink(0, BoxModel(1.0, {0.4, 0, 0}, {0.2, 0, 0}), {0, 0, 0}, kY)},
               {}, {}, kMounted));
  world.Limit({0, 1}, {.high_rad = 0.0, .stop_nm_per_rad = 1e4, .stop_nms_per_rad = 20.0});
  for (long i = 0; i < StepsIn(1.0); ++i) world.Step(step_s());
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
  for (long i = 0; i < StepsIn(0.4); ++i) world.Step(step_s());
  const double wanted = 3.0 * std::exp(-0.4 * damping / moment);
  RecordProperty("off_share", std::to_string(world.body(0).rate_rad_s(1) / wanted - 1.0));
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
