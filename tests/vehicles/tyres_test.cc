// Tyres that roll, brake and slip, against closed forms.
#include "sim/vehicles/tyres.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicles/four_wheels.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

double WheelInertia() { return 0.5 * 0.1 * kWheel_m * kWheel_m; }

class TyresAt : public AtStep {};

// The torque f N slows the body and the wheels' turning: all energy goes into f M g / R over the
// distance.
TEST_P(TyresAt, RollingResistanceBringsAFreeCartToRest) {
  TyreModel tyre = RubberTyre(kWheel_m, 0.02);
  tyre.rolling_resistance_m = 1e-3;
  const CartPlan plan = FourWheels(tyre);
  Cart cart(plan, LevelFloor(0.7), step_s(), OnFloor());
  cart.Run(0.5);
  const double start_m = cart.body().X_GL.p.x(), speed_m_s = 0.6;
  SetRolling(cart, speed_m_s);
  cart.Run(6.0);
  const double moved_kg = plan.mass_kg() + 4.0 * WheelInertia() / (kWheel_m * kWheel_m);
  const double wanted_m = 0.5 * moved_kg * speed_m_s * speed_m_s /
                          (plan.mass_kg() * kG_m_s2 * tyre.rolling_resistance_m / kWheel_m);
  const double gone_m = cart.body().X_GL.p.x() - start_m;
  RecordProperty("off_share", std::to_string(gone_m / wanted_m - 1.0));
  EXPECT_NEAR(gone_m, wanted_m, 0.01 * wanted_m);
  EXPECT_LT(cart.body().v_GL_G.norm(), 1e-6);
}

TEST_P(TyresAt, LockedCartSlidesTillFrictionTookItsSpeed) {
  CartPlan plan(BoxModel(kBody_kg, {0.4, 0.3, 0.1}));
  for (const double x : {0.5, -0.5}) {
    for (const double y : {0.5, -0.5}) {
      plan.Fix(0, {x * kBase_m, y * kTrack_m, 0.0}, RubberTyre(kWheel_m, 0.02));
    }
  }
  Cart cart(plan, LevelFloor(0.6), step_s(), OnFloor());
  cart.Run(0.5);
  const double start_m = cart.body().X_GL.p.x(), speed_m_s = 2.0;
  SetSpeeds(cart.tree(), {speed_m_s});
  cart.Run(0.1);
  EXPECT_TRUE(cart.tyre(0).slides);
  EXPECT_NEAR(cart.tyre(0).slip(), -1.0, 1e-3);
  cart.Run(0.9);
  const double wanted_m = 0.5 * speed_m_s * speed_m_s / (0.6 * kG_m_s2);
  const double gone_m = cart.body().X_GL.p.x() - start_m;
  RecordProperty("off_share", std::to_string(gone_m / wanted_m - 1.0));
  EXPECT_NEAR(gone_m, wanted_m, 0.01 * wanted_m);
  EXPECT_FALSE(cart.tyre(0).slides);
}

// Two floors: v^2 = 2 g (mu_1 x_1 + mu_2 x_2), with wheels so near to each other that they pass
// the border together.
TEST_P(TyresAt, EachFloorRubsAsItsOwn) {
  CartPlan plan(BoxModel(kBody_kg, {0.4, 0.3, 0.02}));
  for (const double y : {0.5, -0.5}) {
    for (const double x : {0.05, -0.05}) plan.Fix(0, {x, y, 0.0}, RubberTyre(0.01, 0.0));
  }
  FirmGround ground = LevelFloor(0.6);
  ground.floors.push_back(ground.floors[0]);
  ground.floors[1].friction = 0.2;
  ground.heights.soils.assign(ground.heights.heights_m.size(), 0);
  for (int iy = 0; iy < ground.heights.ny; ++iy) {
    for (int ix = 0; ix < ground.heights.nx; ++ix) {
      const double x_m = ground.heights.x0_m + ix * ground.heights.cell_m;
      if (x_m > 0.1)
        ground.heights.soils[static_cast<std::size_t>(iy * ground.heights.nx + ix)] = 1;
    }
  }
  const double border_m = 0.25;  // half a cell before the first sample of the second floor
  Cart cart(plan, ground, step_s(), Pose3::Translation(0.0, 0.0, 0.01));
  cart.Run(0.5);
  const double speed_m_s = 2.5;
  SetSpeeds(cart.tree(), {speed_m_s});
  cart.Run(3.0);
  const double left = speed_m_s * speed_m_s / (2.0 * kG_m_s2) - 0.6 * border_m;
  const double wanted_m = border_m + left / 0.2;
  RecordProperty("off_share", std::to_string(cart.body().X_GL.p.x() / wanted_m - 1.0));
  EXPECT_NEAR(cart.body().X_GL.p.x(), wanted_m, 0.01 * wanted_m);
}

// Steady rolling has the force k relaxation x slip: tyre.h. A pull backwards at the floor's height
// loads the driven wheels alone, which turn at a constant rate.
TEST_P(TyresAt, DrivenWheelsSlipInProportionToThePull) {
  const TyreModel tyre = RubberTyre(kWheel_m, 0.02);
  const CartPlan plan = FourWheels(tyre, true);
  Cart cart(plan, LevelFloor(0.7), step_s(), OnFloor());
  for (const double speed_m_s : {0.1, 0.5}) {
    for (const double pull_n : {10.0, 30.0}) {
      SetRolling(cart, speed_m_s);
      const auto Pull = [&] {
        for (const int link : {3, 4}) cart.Drive(link, speed_m_s / kWheel_m);
        Vector3d at_G = cart.body().X_GL.p;
        at_G.z() = 0.0;
        cart.tree().AddForce(0, {-pull_n, 0.0, 0.0}, at_G);
      };
      cart.Run(2.0, Pull);
      const TyreTruth driven = cart.tyre(2);
      const double wanted = 0.5 * pull_n / (tyre.stiffness_n_per_m * tyre.relaxation_m);
      const double slip = -driven.along_m_s / driven.rolling_m_s;
      RecordProperty("off_share_" + std::to_string(std::lround(10 * speed_m_s)) + "_" +
                         std::to_string(std::lround(pull_n)),
                     std::to_string(slip / wanted - 1.0));
      EXPECT_NEAR(driven.along_n, 0.5 * pull_n, 0.005 * pull_n);
      EXPECT_NEAR(slip, wanted, 0.01 * wanted) << speed_m_s << ' ' << pull_n;
      EXPECT_FALSE(driven.slides);
    }
  }
}

// A cart that rolls freely drifts by the side force over the slip stiffness of its four wheels, and
// slides from Coulomb's limit on.
TEST_P(TyresAt, RollingCartDriftsInProportionToTheSideForce) {
  const TyreModel tyre = RubberTyre(kWheel_m, 0.0);
  const CartPlan plan = FourWheels(tyre);
  const double speed_m_s = 0.5, limit_n = 0.7 * plan.mass_kg() * kG_m_s2;
  for (const double share : {0.2, 0.9, 1.1}) {
    Cart cart(plan, LevelFloor(0.7), step_s(), OnFloor());
    cart.Run(0.3);
    SetRolling(cart, speed_m_s);
    const double side_n = share * limit_n;
    cart.Run(0.5, [&] {
      Vector3d at_G = cart.body().X_GL.p;
      at_G.z() = 0.0;
      cart.tree().AddForce(0, {0.0, side_n, 0.0}, at_G);
    });
    const double drift = cart.body().v_GL_G.y() / cart.body().v_GL_G.x();
    if (share > 1.0) {
      EXPECT_TRUE(cart.tyre(0).slides);
      const double wanted_m_s = (share - 1.0) * 0.7 * kG_m_s2 * 0.5;
      EXPECT_GT(cart.body().v_GL_G.y(), 0.8 * wanted_m_s);
      continue;
    }
    const double wanted = 0.25 * side_n / (tyre.stiffness_n_per_m * tyre.relaxation_m);
    RecordProperty("off_share_" + std::to_string(std::lround(100 * share)),
                   std::to_string(drift / wanted - 1.0));
    EXPECT_NEAR(drift, wanted, 0.01 * wanted) << share;
    EXPECT_FALSE(cart.tyre(0).slides);
  }
}

// A heavy mass drifts aside from where its wheel rolls: the side force follows with the relaxation
// as its length, 1 - 1/e of it after that distance.
TEST_P(TyresAt, SideForceBuildsUpOverTheRelaxation) {
  TyreModel tyre = RubberTyre(kWheel_m, 0.0);
  tyre.relaxation_m = 0.05;
  CartPlan plan(Mount().model);
  const LinkModel heavy = BoxModel(1e8, {0.1, 0.1, 0.1}), load = BoxModel(5.0, {0.1, 0.1, 0.1});
  plan.Add(JointedLink(0, heavy, {0, 0, 0}, Vector3d::UnitX(), JointKind::kSlide));
  plan.Add(JointedLink(1, heavy, {0, 0, 0}, Vector3d::UnitY(), JointKind::kSlide));
  plan.Add(JointedLink(2, load, {0, 0, 0}, Vector3d::UnitZ(), JointKind::kSlide));
  plan.AddWheel(3, {0, 0, 0}, tyre);
  Cart cart(plan, LevelFloor(0.7), step_s(), OnFloor(), {TreeBase::kFixed});
  cart.Run(0.5);
  const double speed_m_s = 0.2, drift = 1e-3;
  SetSpeeds(cart.tree(), {speed_m_s, drift * speed_m_s, 0.0, speed_m_s / kWheel_m});
  cart.Run(tyre.relaxation_m / speed_m_s);
  const double after_n = cart.tyre(0).across_n;
  cart.Run(10.0 * tyre.relaxation_m / speed_m_s);
  const double steady_n = cart.tyre(0).across_n;
  const double wanted_n = tyre.stiffness_n_per_m * tyre.relaxation_m * drift;
  const double share = after_n / steady_n, wanted = 1.0 - std::exp(-1.0);
  RecordProperty("off_share", std::to_string(share / wanted - 1.0));
  EXPECT_NEAR(std::abs(steady_n), wanted_n, 0.01 * wanted_n);
  EXPECT_NEAR(share, wanted, 0.01 * wanted);
}

INSTANTIATE_TEST_SUITE_P(Steps, TyresAt, testing::Values(0.5e-3, 1e-3, 2e-3));

}  // namespace
}  // namespace dockyard
