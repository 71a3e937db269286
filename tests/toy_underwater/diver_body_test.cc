// The toy's body against closed forms.
#include "toy_underwater/diver_body.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard::diver {
namespace {

constexpr double kStep_s = 1e-3;
const Eigen::Vector3d kStill(0.0, 0.0, 0.0);

BodyModel Neutral() {
  BodyModel body;
  body.buoyancy_n = kGravity_m_s2 * body.mass_kg;
  return body;
}

BodyModel WithoutDrag(BodyModel body) {
  body.linear_n_s_m = body.quadratic_n_s2_m2 = Eigen::Vector3d::Zero();
  body.linear_nm_s = body.quadratic_nm_s2 = Eigen::Vector3d::Zero();
  return body;
}

/// Where linear and quadratic drag balance a force.
double TerminalSpeed(double linear, double quadratic, double force_n) {
  return (-linear + std::sqrt(linear * linear + 4.0 * quadratic * force_n)) / (2.0 * quadratic);
}

TEST(DiverBody, ReachesItsTerminalSpeedUnderThrust) {
  const BodyModel body = Neutral();
  for (const double speed : {50.0, 150.0, -200.0}) {
    const Wrench thrust = OfThrusters({speed, speed, 0.0, 0.0});
    BodyState state;
    for (int i = 0; i < 30'000; ++i) Step(body, thrust, kStill, kStep_s, state);
    const double expected = TerminalSpeed(body.linear_n_s_m.x(), body.quadratic_n_s2_m2.x(),
                                          2.0 * kThrust_n_s2 * speed * speed);
    EXPECT_NEAR(state.v_R.x(), std::copysign(expected, speed), 1e-9);
  }
}

TEST(DiverBody, RisesAtTheSpeedOfItsNetBuoyancy) {
  const BodyModel body;
  BodyState state;
  for (int i = 0; i < 60'000; ++i) Step(body, {}, kStill, kStep_s, state);
  const double net_n = body.buoyancy_n - kGravity_m_s2 * body.mass_kg;
  EXPECT_NEAR(state.v_R.z(),
              TerminalSpeed(body.linear_n_s_m.z(), body.quadratic_n_s2_m2.z(), net_n), 1e-9);
}

// A pendulum under its centre of buoyancy: T = 2 pi sqrt(I / (B h)), longer by a^2/16 at a rad.
TEST(DiverBody, OscillatesInRollAsAPendulum) {
  const BodyModel body = WithoutDrag(Neutral());
  BodyState state;
  const double amplitude_rad = 0.1;
  state.X_DR.R = RotX(amplitude_rad);
  const double inertia = body.inertia_kg_m2.x() + body.added_kg_m2.x();
  const double period_s = 2.0 * kPi * std::sqrt(inertia / (body.buoyancy_n * body.p_RB.z())) *
                          (1.0 + amplitude_rad * amplitude_rad / 16.0);
  double last_rad = amplitude_rad, first_s = 0.0, second_s = 0.0;
  for (int i = 1; second_s == 0.0; ++i) {
    Step(body, {}, kStill, kStep_s, state);
    const double roll_rad = ToRollPitchYaw(state.X_DR.R).roll;
    if (last_rad > 0.0 && roll_rad <= 0.0) {
      const double at_s = kStep_s * (i - roll_rad / (roll_rad - last_rad));
      (first_s == 0.0 ? first_s : second_s) = at_s;
    }
    last_rad = roll_rad;
  }
  EXPECT_NEAR(second_s - first_s, period_s, 1e-4 * period_s);
}

// M dv/dt = -(b + a |v|) v of the speed against the water.
TEST(DiverBody, IsCarriedAlongByACurrent) {
  const BodyModel body = Neutral();
  const Eigen::Vector3d current_D(0.3, 0.0, 0.0);
  BodyState state;
  state.v_R = -current_D;  // at rest on the ground
  const double mass = body.mass_kg + body.added_kg.x(), b = body.linear_n_s_m.x(),
               a = body.quadratic_n_s2_m2.x(), v0 = 0.3, seconds = 5.0;
  for (int i = 0; i < 5000; ++i) Step(body, {}, current_D, kStep_s, state);
  const double decay = std::exp(-b * seconds / mass);
  EXPECT_NEAR(-state.v_R.x(), b * v0 * decay / (b + a * v0 * (1.0 - decay)), 1e-7);
  // The path against the water is the integral of that.
  const double against_m = mass / a * std::log(1.0 + a * v0 / b * (1.0 - decay));
  EXPECT_NEAR(state.X_DR.p.x(), 0.3 * seconds - against_m, 1e-6);
}

// Kirchhoff: impulse and energy of body and water are conserved.
TEST(DiverBody, KeepsImpulseAndEnergyInStillWaterWithoutDrag) {
  BodyModel body = WithoutDrag(Neutral());
  body.p_RB.setZero();
  body.added_kg_m2 = {0.1, 0.2, 0.3};
  const Eigen::Vector3d mass = Eigen::Vector3d::Constant(body.mass_kg) + body.added_kg;
  const Eigen::Vector3d inertia = body.inertia_kg_m2 + body.added_kg_m2;
  BodyState state;
  state.v_R = {0.5, -0.2, 0.1};
  state.w_R = {0.3, 0.5, -0.4};
  const auto impulse = [&] { return Eigen::Vector3d(state.X_DR.R * mass.cwiseProduct(state.v_R)); };
  const auto moment = [&] {
    return Eigen::Vector3d(state.X_DR.R * inertia.cwiseProduct(state.w_R) +
                           state.X_DR.p.cross(impulse()));
  };
  const auto energy = [&] {
    return 0.5 * (mass.cwiseProduct(state.v_R).dot(state.v_R) +
                  inertia.cwiseProduct(state.w_R).dot(state.w_R));
  };
  const Eigen::Vector3d p0 = impulse(), l0 = moment();
  const double e0 = energy();
  for (int i = 0; i < 10'000; ++i) Step(body, {}, kStill, kStep_s, state);
  EXPECT_LT((impulse() - p0).norm(), 1e-5 * p0.norm());
  EXPECT_LT((moment() - l0).norm(), 2e-4 * l0.norm());  // the path errs by the step squared
  EXPECT_NEAR(energy(), e0, 1e-5 * e0);
  EXPECT_GT(state.X_DR.p.norm(), 1.0);  // it went somewhere
}

// Buoyancy keeps it level. Nothing keeps its heading when it is pushed from behind, so it comes
// along the axis from above.
TEST(DiverBody, IsHeldByTheCageAtTheSpringsDepth) {
  const BodyModel body = Neutral();
  const Cage cage;
  const Wrench thrust = OfThrusters({100.0, 100.0, 0.0, 0.0});
  BodyState state;
  state.X_DR = {RotZ(kPi), Eigen::Vector3d(1.0, 0.0, 0.12)};  // its nose meets the funnel
  for (int i = 0; i < 60'000; ++i) {
    const Wrench wall = OfCage(cage, state, kStill);
    Step(body, {thrust.force_n + wall.force_n, thrust.moment_nm + wall.moment_nm}, kStill, kStep_s,
         state);
  }
  const Eigen::Vector3d p_DN = state.X_DR * cage.p_RN;
  EXPECT_NEAR(-p_DN.x() - cage.length_m, thrust.force_n.x() / cage.stiffness_n_m, 1e-4);
  EXPECT_LT(p_DN.tail<2>().norm(), cage.tube_radius_m + 0.01);
  EXPECT_LT(state.v_R.norm() + state.w_R.norm(), 5e-3);
}

}  // namespace
}  // namespace dockyard::diver
