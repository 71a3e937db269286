// A double pendulum: its normal modes, its motion and its energy.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

class WorldPendulum : public AtStep {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldPendulum, testing::Values(0.5e-3, 1e-3, 2e-3));

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

/// At these angles from the vertical, at rest.
class SwingingPendulum {
 public:
  SwingingPendulum(const DoublePendulum& pendulum, double step_s, const Vector2d& angles_rad)
      : world_(kDown), step_s_(step_s) {
    const Vector3d com(0.0, 0.0, -pendulum.c), size(0.0, 0.0, pendulum.l), y = Vector3d::UnitY();
    TreeBody tree({Mount(), JointedLink(0, BoxModel(pendulum.m1, size, com), {0, 0, 0}, y),
                   JointedLink(1, BoxModel(pendulum.m2, size, com), {0, 0, -pendulum.l}, y)},
                  {}, {}, kMounted);
    tree.SetAngle(1, angles_rad[0]);
    tree.SetAngle(2, angles_rad[1] - angles_rad[0]);
    // Speeds belong to the middle of steps: the first to half a step before the start at rest.
    const Vector4d first =
        -0.5 * step_s * pendulum.Rate(Vector4d(angles_rad[0], angles_rad[1], 0.0, 0.0));
    SetSpeeds(tree, {first[2], first[3] - first[2]});
    world_.Add(std::move(tree));
  }
  /// Angles and, of half a step before, rates.
  Vector4d State() const {
    const TreeBody& at = world_.body(0);
    return Vector4d(at.angle_rad(1), at.angle_rad(1) + at.angle_rad(2), at.rate_rad_s(1),
                    at.rate_rad_s(1) + at.rate_rad_s(2));
  }
  /// Returns the state before, with the rates of that time.
  Vector4d Step() {
    Vector4d at = State();
    world_.Step(step_s_);
    at.tail<2>() = 0.5 * (at + State()).tail<2>();
    return at;
  }

 private:
  RigidWorld world_;
  double step_s_;
};

TEST_P(WorldPendulum, DoublePendulumSwingsAsItsEquationsSayAndKeepsItsEnergy) {
  const DoublePendulum pendulum;
  const Vector4d start(0.6, -0.4, 0.0, 0.0);
  SwingingPendulum swinging(pendulum, step_s(), start.head<2>());
  const double highest = pendulum.Energy(start) - pendulum.Energy(Vector4d::Zero());
  double drift = 0.0;
  for (long i = 0; i < StepsIn(2.0); ++i) {
    const double energy = pendulum.Energy(swinging.Step());
    drift = std::max(drift, std::abs(energy - pendulum.Energy(start)));
  }
  const Vector4d wanted =
      Integrated(start, 2.0, [&](const Vector4d& s) { return pendulum.Rate(s); });
  const double off = (swinging.State() - wanted).head<2>().lpNorm<Eigen::Infinity>();
  RecordProperty("off_share", std::to_string(off / 0.6));
  RecordProperty("energy_share", std::to_string(drift / highest));
  EXPECT_LT(off, 0.01 * 0.6);
  EXPECT_LT(drift, 0.01 * highest);
}

// Small swings in one normal mode: det(K - w^2 M) = 0.
TEST_P(WorldPendulum, DoublePendulumSwingsAtTheFrequenciesOfItsNormalModes) {
  const DoublePendulum p;
  const double g = kEarthGravity_m_s2, a = p.I1 + p.m1 * p.c * p.c + p.m2 * p.l * p.l,
               b = p.m2 * p.l * p.c, c = p.I2 + p.m2 * p.c * p.c;
  const double k1 = (p.m1 * p.c + p.m2 * p.l) * g, k2 = p.m2 * p.c * g;
  const double sum = k1 * c + k2 * a, product = a * c - b * b;
  for (const double sign : {-1.0, 1.0}) {
    const double square =
        (sum + sign * std::sqrt(sum * sum - 4.0 * product * k1 * k2)) / (2.0 * product);
    const Vector2d shape = 5e-3 * Vector2d(1.0, (k1 - square * a) / (square * b));
    SwingingPendulum swinging(p, step_s(), shape);
    UpwardPasses first, second;
    for (long i = 0; i < StepsIn(6.0); ++i) {
      const Vector4d at = swinging.Step();
      first.Take(step_s() * static_cast<double>(i), at[0]);
      second.Take(step_s() * static_cast<double>(i), at[1]);
    }
    ASSERT_GE(first.count(), 3u);
    const double wanted_s = 2.0 * kPi / std::sqrt(square);
    RecordProperty(sign < 0.0 ? "slow_share" : "fast_share",
                   std::to_string(1e6 * (first.Period() / wanted_s - 1.0)));
    EXPECT_NEAR(first.Period(), wanted_s, 1e-3 * wanted_s);
    EXPECT_NEAR(second.Period(), wanted_s, 1e-3 * wanted_s);
  }
}

// Where the motion is chaotic no path can be predicted, but its energy stays.
TEST_P(WorldPendulum, DoublePendulumThatTurnsOverKeepsItsEnergy) {
  const DoublePendulum pendulum;
  const Vector4d start(2.5, 2.9, 0.0, 0.0);
  SwingingPendulum swinging(pendulum, step_s(), start.head<2>());
  const double highest = pendulum.Energy(start) - pendulum.Energy(Vector4d::Zero());
  double drift = 0.0, furthest_rad = 0.0;
  for (long i = 0; i < StepsIn(10.0); ++i) {
    const Vector4d at = swinging.Step();
    drift = std::max(drift, std::abs(pendulum.Energy(at) - pendulum.Energy(start)));
    furthest_rad = std::max(furthest_rad, std::abs(at[1]));
  }
  RecordProperty("energy_share", std::to_string(drift / highest));
  EXPECT_GT(furthest_rad, 2.0 * kPi);
  EXPECT_LT(drift, 0.01 * highest);
}

}  // namespace
}  // namespace dockyard
