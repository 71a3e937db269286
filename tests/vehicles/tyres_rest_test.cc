// Tyres that rest, on slopes and carpets, and balls, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "vehicles/four_wheels.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

class RestingTyresAt : public AtStep {};

// Brakes hold the wheels by Coulomb's friction of their joints.
TEST_P(RestingTyresAt, BrakedCartRestsOnASlopeWithoutCreep) {
  const CartPlan plan = FourWheels(RubberTyre(kWheel_m, 0.02));
  Cart cart(plan, LevelFloor(0.7), step_s(), OnFloor());
  for (int link = 1; link <= 4; ++link) cart.world().Limit({0, link}, {.friction_nm = 5.0});
  const double slope_rad = 15.0 * kPi / 180.0;
  cart.world().SetGravity(
      kG_m_s2 * Vector3d(std::sin(slope_rad), 0.3 * std::sin(slope_rad), -std::cos(slope_rad)));
  cart.Run(1.0);
  const Vector3d start_G = cart.body().X_GL.p;
  cart.Run(60.0);
  const double creep_m = (cart.body().X_GL.p - start_G).norm();
  RecordProperty("creep_nm", std::to_string(1e9 * creep_m));
  EXPECT_LT(creep_m, 1e-7);
}

// Free wheels stay below the slope f / R, and roll above it.
TEST_P(RestingTyresAt, RollingResistanceHoldsFreeWheelsOnAGentleSlope) {
  TyreModel tyre = RubberTyre(kWheel_m, 0.02);
  tyre.rolling_resistance_m = 1e-3;
  const CartPlan plan = FourWheels(tyre);
  for (const double share : {0.95, 1.05}) {
    Cart cart(plan, LevelFloor(0.7), step_s(), OnFloor());
    const double slope = share * tyre.rolling_resistance_m / kWheel_m;
    cart.world().SetGravity(kG_m_s2 * Vector3d(slope, 0.0, -1.0));
    cart.Run(1.0);
    const double start_m = cart.body().X_GL.p.x();
    cart.Run(5.0);
    const double gone_m = cart.body().X_GL.p.x() - start_m;
    if (share < 1.0) {
      RecordProperty("creep_nm", std::to_string(1e9 * gone_m));
      EXPECT_LT(std::abs(gone_m), 1e-7);
    } else {
      EXPECT_GT(gone_m, 0.05);
    }
  }
}

// A ball caster's link stays as it is: it drags by its socket's grip and the rolling loss.
TEST_P(RestingTyresAt, BallCastersDragByTheirGrip) {
  TyreModel ball = RubberTyre(0.01, 0.0);
  ball.ball = true;
  ball.grip = 0.05;
  ball.rolling_resistance_m = 2e-4;
  CartPlan plan(BoxModel(5.0, {0.3, 0.3, 0.05}));
  for (const double x : {0.1, -0.1}) {
    for (const double y : {0.1, -0.1}) plan.Fix(0, {x, y, 0.0}, ball);
  }
  Cart cart(plan, LevelFloor(0.8), step_s(), Pose3::Translation(0.0, 0.0, 0.01));
  cart.Run(0.5);
  const double speed_m_s = 0.5;
  const Vector3d start_G = cart.body().X_GL.p;
  SetSpeeds(cart.tree(), {0.6 * speed_m_s, 0.8 * speed_m_s});
  cart.Run(2.0);
  const double wanted_m = 0.5 * speed_m_s * speed_m_s / ((0.05 * 0.8 + 0.02) * kG_m_s2);
  const double gone_m = (cart.body().X_GL.p - start_G).head<2>().norm();
  RecordProperty("off_share", std::to_string(gone_m / wanted_m - 1.0));
  EXPECT_NEAR(gone_m, wanted_m, 0.01 * wanted_m);
}

// A tyre on a carpet: one spring behind the other.
TEST(RestingTyres, SinksIntoACarpetByBothSprings) {
  FirmGround ground = LevelFloor(0.7);
  ground.floors[0].stiffness_n_per_m = 2e4;
  ground.floors[0].damping_ns_per_m = 300.0;
  const CartPlan plan = FourWheels(RubberTyre(kWheel_m, 0.02));
  Cart cart(plan, ground, 1e-3, OnFloor());
  cart.Run(2.0);
  const double load_n = 0.25 * plan.mass_kg() * kG_m_s2;
  EXPECT_NEAR(cart.tyre(1).load_n, load_n, 1e-6 * load_n);
  EXPECT_NEAR(kWheel_m - cart.body().X_GL.p.z(), load_n * (1.0 / 1e5 + 1.0 / 2e4), 1e-8);
}

// A wheel that is tilted far rests on its edge, one that lies on its whole rim.
TEST(RestingTyres, FallsOverAndLiesOnItsRim) {
  CartPlan plan(WheelLink(0.5, kWheel_m));
  plan.Fix(0, {0, 0, 0}, RubberTyre(kWheel_m, 0.03));
  Pose3 X_GB = Pose3::Translation(0.0, 0.0, kWheel_m);
  X_GB.R = Eigen::AngleAxisd(0.6, Vector3d::UnitX()).toRotationMatrix();
  Cart cart(plan, LevelFloor(0.7), 1e-3, X_GB);
  cart.Run(5.0);
  EXPECT_NEAR(std::abs(cart.body().X_GL.R(2, 1)), 1.0, 1e-3);
  EXPECT_NEAR(cart.body().X_GL.p.z(), 0.015, 2e-4);
  EXPECT_LT(cart.body().w_GL_G.norm(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Steps, RestingTyresAt, testing::Values(0.5e-3, 1e-3, 2e-3));

}  // namespace
}  // namespace dockyard
