// Balls of a world that roll, and that meet: closed forms and sums that stay.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

class WorldBalls : public AtStep {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldBalls, testing::Values(0.5e-3, 1e-3, 2e-3));

constexpr double g = kEarthGravity_m_s2;

// 2 pi sqrt(7 (R - r) / 5 g), less a part in 3000 of a swing of this width.
TEST_P(WorldBalls, BallRollsInABowlAtItsFrequency) {
  const double bowl_m = 0.5, ball_m = 0.05, mass_kg = 0.5, swing_rad = 0.1;
  const double moment = 0.4 * mass_kg * ball_m * ball_m;
  RigidWorld world(kDown);
  const double away_m = bowl_m - ball_m;
  world.Add(FreeBody(
      TurningModel(mass_kg, moment, moment),
      Pose3::Translation(away_m * std::sin(swing_rad), 0.0, -away_m * std::cos(swing_rad))));
  UpwardPasses passes;
  for (long i = 0; i < StepsIn(8.0); ++i) {
    const Vector3d p_G = world.body(0).motion(0).X_GL.p, normal_G = -p_G.normalized();
    world.AddContact({.a = {0, 0},
                      .p_G = p_G - ball_m * normal_G,
                      .normal_G = normal_G,
                      .gap_m = away_m - p_G.norm(),
                      .material = {1e6, 500.0, 0.8, 0.0}});
    world.Step(step_s());
    passes.Take(step_s() * static_cast<double>(i), world.body(0).motion(0).X_GL.p.x());
  }
  ASSERT_GE(passes.count(), 4u);
  const double period_s = passes.Period();
  const double wanted_s = 2.0 * kPi * std::sqrt(1.4 * away_m / g);
  RecordProperty("off_share", std::to_string(period_s / wanted_s - 1.0));
  EXPECT_NEAR(period_s, wanted_s, 0.01 * wanted_s);
}

// It slows down by 5/7 g times the resistance over the radius, and comes to rest.
TEST_P(WorldBalls, RollingResistanceSlowsABallAndHoldsIt) {
  const double ball_m = 0.1, mass_kg = 2.0, resistance_m = 5e-3, start_m_s = 0.5;
  const double moment = 0.4 * mass_kg * ball_m * ball_m;
  RigidWorld world(kDown);
  TreeBody ball = FreeBody(TurningModel(mass_kg, moment, moment),
                           Pose3::Translation(0.0, 0.0, ball_m - mass_kg * g / 1e6));
  SetSpeeds(ball, {start_m_s, 0.0, 0.0, 0.0, start_m_s / ball_m, 0.0});
  world.Add(std::move(ball));
  const auto Roll = [&](double seconds) {
    for (long i = 0; i < StepsIn(seconds); ++i) {
      const Vector3d p_G = world.body(0).motion(0).X_GL.p;
      world.AddContact({.a = {0, 0},
                        .p_G = p_G - ball_m * Vector3d::UnitZ(),
                        .gap_m = p_G.z() - ball_m,
                        .material = {1e6, 1e3, 0.5, resistance_m}});
      world.Step(step_s());
    }
  };
  Roll(1.0);
  const double wanted_m_s = start_m_s - g * resistance_m / ball_m / 1.4;
  EXPECT_NEAR(world.body(0).motion(0).v_GL_G.x(), wanted_m_s, 0.01 * start_m_s);
  Roll(1.0);
  EXPECT_LT(world.body(0).motion(0).v_GL_G.norm(), 1e-6);
  // On a slope below resistance over radius it stays, above it does not.
  world.SetGravity(g * Vector3d(0.9 * resistance_m / ball_m, 0.0, -1.0));
  Roll(1.0);
  EXPECT_LT(world.body(0).motion(0).v_GL_G.norm(), 1e-6);
  world.SetGravity(g * Vector3d(1.1 * resistance_m / ball_m, 0.0, -1.0));
  Roll(1.0);
  EXPECT_NEAR(world.body(0).motion(0).v_GL_G.x(), 0.1 * g * resistance_m / ball_m / 1.4,
              0.03 * 0.1 * g * resistance_m / ball_m / 1.4);
}

// Off-centre, with friction: the sums of momentum and of its moment stay.
TEST_P(WorldBalls, BlowOfTwoBallsKeepsMomentumAndItsMoment) {
  const double ball_m = 0.1;
  const auto Run = [&](Vector3d& momentum, Vector3d& moment) {
    RigidWorld world({0, 0, 0});
    for (const double side : {-1.0, 1.0}) {
      const double mass_kg = side < 0.0 ? 1.0 : 3.0;
      TreeBody ball = FreeBody(TurningModel(mass_kg, 0.01, 0.02),
                               Pose3::Translation(0.12 * side, 0.03 * side, 0.0));
      SetSpeeds(ball, {-side, 0.1, 0.0, 0.5, 2.0, -side});
      world.Add(std::move(ball));
    }
    const auto Sum = [&] {
      momentum = moment = Vector3d::Zero();
      for (int i = 0; i < 2; ++i) {
        const LinkMotion& at = world.body(i).motion(0);
        const LinkModel& model = world.body(i).link(0).model;
        momentum += model.mass_kg * at.v_GL_G;
        moment += at.X_GL.p.cross(model.mass_kg * at.v_GL_G) +
                  at.X_GL.R * (model.I_LCom_L * (at.X_GL.R.transpose() * at.w_GL_G));
      }
    };
    Sum();
    const Vector3d before = momentum, moment_before = moment;
    double pressed_ns = 0.0;
    for (long i = 0; i < StepsIn(0.2); ++i) {
      const Vector3d a = world.body(0).motion(0).X_GL.p, b = world.body(1).motion(0).X_GL.p;
      const Vector3d normal_G = (a - b).normalized();
      world.AddContact({.a = {0, 0},
                        .b = {1, 0},
                        .p_G = 0.5 * (a + b),
                        .normal_G = normal_G,
                        .gap_m = (a - b).norm() - 2.0 * ball_m,
                        .material = {1e5, 50.0, 0.4, 1e-3}});
      world.Step(step_s());
      pressed_ns += world.contacts()[0].impulse_G.norm();
    }
    Sum();
    EXPECT_GT(pressed_ns, 0.5);
    momentum -= before;
    moment -= moment_before;
    return world.StateHash(1);
  };
  Vector3d momentum, moment;
  const std::uint64_t hash = Run(momentum, moment);
  EXPECT_LT(momentum.norm(), 1e-12);
  EXPECT_LT(moment.norm(), 1e-12);
  EXPECT_EQ(Run(momentum, moment), hash);
}

}  // namespace
}  // namespace dockyard
