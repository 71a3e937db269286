// Robots on tyres that turn: two driven wheels with casters, four fixed wheels, and a wheel on the
// spot, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "vehicles/tyre_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

class TurningTyresAt : public AtStep {};

constexpr double kDriven_m = 0.06, kApart_m = 0.3, kCaster_m = 0.025, kTrail_m = 0.03;

/// Driven wheels 1 and 2, left and right; a caster ahead and one behind.
CartPlan TwoDriven() {
  CartPlan plan(BoxModel(15.0, {0.4, 0.3, 0.1}));
  TyreModel driven = RubberTyre(kDriven_m, 0.02), caster = RubberTyre(kCaster_m, 0.01);
  driven.rolling_resistance_m = 6e-4;
  caster.rolling_resistance_m = 5e-4;
  for (const double y : {0.5, -0.5}) plan.AddDriven(0, {0.0, y * kApart_m, 0.0}, driven);
  for (const double x : {0.17, -0.17}) {
    const int swivel = plan.AddSwivel(0, {x, 0.0, -0.01});
    plan.AddWheel(swivel, {-kTrail_m, 0.0, kCaster_m - kDriven_m + 0.01}, caster, 0.03);
  }
  return plan;
}

class DrivenCart {
 public:
  explicit DrivenCart(double step_s)
      : cart_(TwoDriven(), LevelFloor(0.7), step_s, Pose3::Translation(0.0, 0.0, kDriven_m)) {}

  void Drive(double left_rad_s, double right_rad_s, double seconds) {
    cart_.Run(seconds, [&] {
      cart_.Drive(1, left_rad_s);
      cart_.Drive(2, right_rad_s);
      const double now_rad = cart_.heading_rad();
      turned_rad_ += std::remainder(now_rad - last_rad_, 2.0 * kPi);
      last_rad_ = now_rad;
    });
  }
  Cart& cart() { return cart_; }
  double turned_rad() const { return turned_rad_; }
  double wheel_rad(int link) { return cart_.tree().angle_rad(link); }

 private:
  Cart cart_;
  double turned_rad_ = 0.0, last_rad_ = 0.0;
};

TEST_P(TurningTyresAt, DifferentialDriveTurnsInPlace) {
  DrivenCart robot(step_s());
  const double rate_rad_s = 5.0;
  robot.Drive(-rate_rad_s, rate_rad_s, 2.0);  // the casters come round
  const double turned_rad = robot.turned_rad(), left_rad = robot.wheel_rad(1),
               right_rad = robot.wheel_rad(2);
  const Vector3d start_G = robot.cart().body().X_GL.p;
  robot.Drive(-rate_rad_s, rate_rad_s, 6.0);
  const double wheels_rad = 0.5 * (robot.wheel_rad(2) - right_rad - robot.wheel_rad(1) + left_rad);
  const double wanted_rad = wheels_rad * kDriven_m / (0.5 * kApart_m);
  RecordProperty("off_share", std::to_string((robot.turned_rad() - turned_rad) / wanted_rad - 1));
  RecordProperty("off_place_mm",
                 std::to_string(1e3 * (robot.cart().body().X_GL.p - start_G).norm()));
  EXPECT_NEAR(robot.turned_rad() - turned_rad, wanted_rad, 0.01 * wanted_rad);
  EXPECT_LT((robot.cart().body().X_GL.p - start_G).norm(), 2e-3);
}

// R = track/2 (right + left)/(right - left).
TEST_P(TurningTyresAt, DifferentialDriveFollowsTheArcOfItsWheels) {
  DrivenCart robot(step_s());
  robot.Drive(3.0, 6.0, 2.0);
  const double turned_rad = robot.turned_rad(), left_rad = robot.wheel_rad(1),
               right_rad = robot.wheel_rad(2);
  const Vector3d start_G = robot.cart().body().X_GL.p;
  robot.Drive(3.0, 6.0, 3.0);
  const double left = robot.wheel_rad(1) - left_rad, right = robot.wheel_rad(2) - right_rad;
  const double wanted_m = 0.5 * kApart_m * (right + left) / (right - left);
  const double arc_rad = robot.turned_rad() - turned_rad;
  const double radius_m =
      (robot.cart().body().X_GL.p - start_G).norm() / (2.0 * std::sin(0.5 * arc_rad));
  RecordProperty("off_share", std::to_string(radius_m / wanted_m - 1.0));
  EXPECT_NEAR(radius_m, wanted_m, 0.01 * wanted_m);
}

TEST_P(TurningTyresAt, TwoRunsHaveTheSameBits) {
  DrivenCart one(step_s()), other(step_s());
  for (DrivenCart* robot : {&one, &other}) {
    robot->Drive(3.0, 6.0, 0.5);
    robot->Drive(-4.0, -2.0, 0.5);
  }
  EXPECT_EQ(one.cart().world().StateHash(kHashSeed), other.cart().world().StateHash(kHashSeed));
}

// Two points of Gauss's rule, mu N w / sqrt(12): 15 % above the line's integral, mu N w / 4.
TEST_P(TurningTyresAt, WheelScrubsAsItTurnsOnTheSpot) {
  const double mass_kg = 5.0, width_m = 0.02, flywheel_kg_m2 = 0.05;
  CartPlan plan(Mount().model);
  LinkModel flywheel = BoxModel(mass_kg, {0.1, 0.1, 0.1});
  flywheel.I_LCom_L(2, 2) = flywheel_kg_m2;
  const int load = plan.Add(JointedLink(0, BoxModel(1e-3, {0.1, 0.1, 0.1}), {0, 0, 0},
                                        Vector3d::UnitZ(), JointKind::kSlide));
  const int swivel = plan.Add(JointedLink(load, flywheel, {0, 0, 0}, Vector3d::UnitZ()));
  plan.AddWheel(swivel, {0.0, 0.0, 0.0}, RubberTyre(kDriven_m, width_m), 0.01);
  Cart cart(plan, LevelFloor(0.7), step_s(), Pose3::Translation(0.0, 0.0, kDriven_m), kMounted);
  cart.Run(0.5);
  SetSpeeds(cart.tree(), {0.0, 10.0});
  cart.Run(0.1);
  const double rate_rad_s = cart.tree().rate_rad_s(swivel);
  cart.Run(0.5);
  const double inertia = flywheel_kg_m2 + 0.25 * 0.01 * kDriven_m * kDriven_m;
  const double torque_nm = inertia * (rate_rad_s - cart.tree().rate_rad_s(swivel)) / 0.5;
  const double even_nm = 0.7 * plan.mass_kg() * kG_m_s2 * width_m;
  const double load_nm = even_nm - 0.7 * plan.links[0].model.mass_kg * kG_m_s2 * width_m;
  RecordProperty("off_share", std::to_string(torque_nm / (load_nm / std::sqrt(12.0)) - 1.0));
  RecordProperty("over_line", std::to_string(torque_nm / (0.25 * load_nm)));
  EXPECT_NEAR(torque_nm, load_nm / std::sqrt(12.0), 0.01 * torque_nm);
  EXPECT_NEAR(torque_nm / (0.25 * load_nm), 2.0 / std::sqrt(3.0), 0.01);
}

constexpr double kLong_m = 0.12, kWide_m = 0.16;  // half of base and track

CartPlan SkidSteer(bool driven) {
  CartPlan plan(BoxModel(15.0, {0.4, 0.3, 0.1}));
  for (const double x : {kLong_m, -kLong_m}) {
    for (const double y : {kWide_m, -kWide_m}) {
      const TyreModel tyre = RubberTyre(kDriven_m, 0.0);
      if (driven) {
        plan.AddDriven(0, {x, y, 0.0}, tyre);
      } else {
        plan.AddWheel(0, {x, y, 0.0}, tyre);
      }
    }
  }
  return plan;
}

// All wheels slide: across by w a, along by u - w b, and the force on each is against it. Those
// along the wheels turn the body by b as those across resist by a, so the slidings are as b to a:
// w = u b/(a^2 + b^2). The force along a wheel is mu N a/sqrt(a^2 + b^2).
TEST_P(TurningTyresAt, FourFixedWheelsTurnByTheTorqueOfTheirSliding) {
  const CartPlan plan = SkidSteer(true);
  Cart cart(plan, LevelFloor(0.6), step_s(), Pose3::Translation(0.0, 0.0, kDriven_m));
  const double rate_rad_s = 4.0;
  const auto Drive = [&] {
    for (int link = 1; link <= 4; ++link) {
      cart.Drive(link, link % 2 == 1 ? -rate_rad_s : rate_rad_s);
    }
  };
  cart.Run(2.0, Drive);
  double turned_rad = 0.0, wheels_rad = cart.tree().angle_rad(2), last_rad = cart.heading_rad();
  double along_n = 0.0;
  const double seconds = 2.0;
  cart.Run(seconds, [&] {
    Drive();
    const double now_rad = cart.heading_rad();
    turned_rad += std::remainder(now_rad - last_rad, 2.0 * kPi);
    last_rad = now_rad;
    along_n += cart.tyre(1).along_n * step_s() / seconds;
  });
  wheels_rad = cart.tree().angle_rad(2) - wheels_rad;
  const double square = kLong_m * kLong_m + kWide_m * kWide_m;
  const double wanted_rad = wheels_rad * kDriven_m * kWide_m / square;
  const double wanted_n = 0.6 * 0.25 * plan.mass_kg() * kG_m_s2 * kLong_m / std::sqrt(square);
  RecordProperty("turn_off_share", std::to_string(turned_rad / wanted_rad - 1.0));
  RecordProperty("force_off_share", std::to_string(along_n / wanted_n - 1.0));
  EXPECT_NEAR(turned_rad, wanted_rad, 0.01 * wanted_rad);
  EXPECT_NEAR(along_n, wanted_n, 0.01 * wanted_n);
}

// Free wheels roll along and slide across: the turn is slowed by mu M g a.
TEST_P(TurningTyresAt, FourFreeWheelsSlowATurnByTheirSlidingAcross) {
  const CartPlan plan = SkidSteer(false);
  Cart cart(plan, LevelFloor(0.6), step_s(), Pose3::Translation(0.0, 0.0, kDriven_m));
  cart.Run(0.5);
  const double start_rad_s = 8.0, roll_rad_s = start_rad_s * kWide_m / kDriven_m;
  SetSpeeds(cart.tree(),
            {0, 0, 0, 0, 0, start_rad_s, -roll_rad_s, roll_rad_s, -roll_rad_s, roll_rad_s});
  cart.Run(0.02);
  const double rate_rad_s = cart.body().w_GL_G.z();
  cart.Run(0.08);
  const double slowing = (rate_rad_s - cart.body().w_GL_G.z()) / 0.08;
  const LinkModel wheel = WheelLink(0.1, kDriven_m);
  const double square = kLong_m * kLong_m + kWide_m * kWide_m;
  const double inertia = plan.links[0].model.I_LCom_L(2, 2) +
                         4.0 * (wheel.mass_kg * square + wheel.I_LCom_L(2, 2) +
                                wheel.I_LCom_L(1, 1) * std::pow(kWide_m / kDriven_m, 2));
  const double wanted = 0.6 * plan.mass_kg() * kG_m_s2 * kLong_m / inertia;
  RecordProperty("off_share", std::to_string(slowing / wanted - 1.0));
  EXPECT_NEAR(slowing, wanted, 0.01 * wanted);
}

INSTANTIATE_TEST_SUITE_P(Steps, TurningTyresAt, testing::Values(0.5e-3, 1e-3, 2e-3));

}  // namespace
}  // namespace dockyard
