#include "sim/physics/tether.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/random.h"
#include "physics/axel_numbers.h"
#include "sim/physics/tether_path.h"
#include "sim/physics/tether_shape.h"

namespace dockyard {
namespace {

constexpr double kInsideArmM = 1.0;
constexpr double kDt = 1e-3;

TEST(TetherPath, IsStraightOnTheAxis) {
  const TetherPath path = FindTetherPath(TestStation().cone, 0.35, {2.0, 0.0});
  EXPECT_EQ(path.pieces, 1);
  EXPECT_DOUBLE_EQ(path.total_m(), 2.35);
}

TEST(TetherPath, BendsOverThroatAndLipFromTheSide) {
  const TetherPath path = FindTetherPath(TestStation().cone, 0.35, {1.0, 2.0});
  ASSERT_EQ(path.pieces, 3);
  EXPECT_DOUBLE_EQ(path.length_m[0], std::hypot(1.0, 1.88));
  EXPECT_DOUBLE_EQ(path.length_m[1], std::hypot(0.12, 0.0875));
  EXPECT_DOUBLE_EQ(path.length_m[2], std::hypot(0.23, 0.0325));
  EXPECT_NEAR(path.turn_rad[0] + path.turn_rad[1], std::atan2(1.88, 1.0) - std::atan2(0.0325, 0.23),
              1e-12);
}

TEST(TetherPath, IsAsShortAsABruteForceSearchFinds) {
  const ConeModel cone = TestStation().cone;
  RandomStream random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector2d tip(random.Uniform(0.01, 4.0), random.Uniform(0.0, 3.0));
    double shortest = 1e9;
    for (int i = 0; i <= 200; ++i) {  // heights at which the path crosses throat and mouth plane
      const Eigen::Vector2d throat(-cone.funnel_length_m, cone.throat_radius_m * i / 200.0);
      for (int j = 0; j <= 200; ++j) {
        const Eigen::Vector2d lip(0.0, cone.mouth_radius_m * j / 200.0);
        shortest = std::min(shortest, (throat - Eigen::Vector2d(-0.35, 0.0)).norm() +
                                          (lip - throat).norm() + (tip - lip).norm());
      }
    }
    const double found = FindTetherPath(cone, 0.35, tip).total_m();
    EXPECT_LE(found, shortest + 1e-12);
    EXPECT_GT(found, shortest - 2e-4);
  }
}

TEST(TetherPath, ChangesItsLengthSmoothlyAsTheTipGoesRound) {
  const ConeModel cone = TestStation().cone;
  double last = FindTetherPath(cone, 0.35, {2.0, 0.0}).total_m();
  for (double angle = 1e-3; angle < 1.5; angle += 1e-3) {
    const Eigen::Vector2d tip(2.0 * std::cos(angle), 2.0 * std::sin(angle));
    const double now = FindTetherPath(cone, 0.35, tip).total_m();
    EXPECT_LT(std::abs(now - last), 2.0 * 1e-3);
    last = now;
  }
}

TEST(Tether, NeverPushes) {
  Tether tether(TestRover().tether, TestStation(), kInsideArmM);
  tether.LayOut({2.0, 0.0, 0.0}, 2.5);
  const TetherLoad load = tether.Step({2.0, 0.0, 0.0}, {1.0, 0, 0}, 2.5, 0.0);
  EXPECT_EQ(load.tension_n, 0.0);
  EXPECT_EQ(load.force_on_tip_M.norm(), 0.0);
}

TEST(Tether, HangingMassStretchesByHookesLaw) {
  // 30 kg on the axis, released where the tether is just straight, until it rests.
  const TetherModel model = TestRover().tether;
  Tether tether(model, TestStation(), kInsideArmM);
  const double free = 2.35;
  Eigen::Vector3d p(2.0, 0.0, 0.0), v = Eigen::Vector3d::Zero();
  tether.LayOut(p, free);
  double most = 0.0;
  TetherLoad load;
  for (int i = 0; i < 8000; ++i) {
    load = tether.Step(p, v, free, 0.0);
    v += (load.force_on_tip_M / 30.0 + Eigen::Vector3d(9.81, 0, 0)) * kDt;
    p += v * kDt;
    most = std::max(most, load.tension_n);
  }
  EXPECT_NEAR(load.tension_n, 30.0 * 9.81, 1e-3);
  const double k = model.axial_stiffness_n / (free + kInsideArmM);
  EXPECT_NEAR(p.x() - 2.0, 30.0 * 9.81 / k, 1e-6);
  // First peak of a damped spring that is loaded at once.
  const double zeta = model.damping_ns_per_m / (2.0 * std::sqrt(k * 30.0));
  const double peak = 1.0 + std::exp(-kPi * zeta / std::sqrt(1.0 - zeta * zeta));
  EXPECT_NEAR(most / (30.0 * 9.81), peak, 0.05 * peak);
}

TEST(Tether, CatchesADroppedMassAfterTheFreeFall) {
  Tether tether(TestRover().tether, TestStation(), kInsideArmM);
  const double slack = 0.1;
  Eigen::Vector3d p(2.0, 0.0, 0.0), v = Eigen::Vector3d::Zero();
  tether.LayOut(p, 2.35 + slack);
  int steps = 0;
  while (steps < 1000) {
    const TetherLoad load = tether.Step(p, v, 2.35 + slack, 0.0);
    if (load.tension_n > 0.0) break;
    v += Eigen::Vector3d(9.81, 0, 0) * kDt;
    p += v * kDt;
    ++steps;
  }
  EXPECT_NEAR(steps * kDt, std::sqrt(2.0 * slack / 9.81), 2 * kDt);
}

/// Draws the tether in from the side until it slides over both edges.
TetherLoad PullFromTheSide(double friction, Tether* out = nullptr) {
  TetherModel model = TestRover().tether;
  model.friction_on_station = friction;
  Tether tether(model, TestStation(), kInsideArmM);
  const Eigen::Vector3d p(1.0, 2.0, 0.5);
  tether.LayOut(p, 1.0);
  double free = tether.path_m();
  tether.LayOut(p, free);
  TetherLoad load;
  for (int i = 0; i < 2000; ++i) {
    free -= 5e-6;
    load = tether.Step(p, Eigen::Vector3d::Zero(), free, 0.0);
  }
  if (out != nullptr) *out = tether;
  return load;
}

TEST(Tether, SlidesOverABendAtTheCapstanRatio) {
  Tether tether(TestRover().tether, TestStation(), kInsideArmM);
  const TetherLoad load = PullFromTheSide(0.3, &tether);
  ASSERT_EQ(load.nodes, 3);
  const TetherPath& path = tether.path();
  const double at_anchor = load.force_on_station_M[2].norm();
  const double wrap = path.turn_rad[0] + path.turn_rad[1];
  EXPECT_NEAR(load.tension_n / at_anchor, std::exp(0.3 * wrap), 1e-5);
}

TEST(Tether, PullsEquallyAllAlongWithoutFriction) {
  const TetherLoad load = PullFromTheSide(0.0);
  EXPECT_NEAR(load.force_on_station_M[2].norm(), load.tension_n, 1e-3);
}

TEST(Tether, ForcesOnTipAndStationAddUpToNothing) {
  const TetherLoad load = PullFromTheSide(0.3);
  Eigen::Vector3d sum = load.force_on_tip_M;
  Eigen::Vector3d moment = Eigen::Vector3d(1.0, 2.0, 0.5).cross(load.force_on_tip_M);
  for (int i = 0; i < load.nodes; ++i) {
    sum += load.force_on_station_M[i];
    moment += load.p_M[i].cross(load.force_on_station_M[i]);
  }
  EXPECT_GT(load.tension_n, 50.0);
  EXPECT_LT(sum.norm(), 1e-9);
  EXPECT_LT(moment.norm(), 1e-9);
}

TEST(Tether, KeepsItsLengthWhenItComesToLieOverAnEdge) {
  Tether tether(TestRover().tether, TestStation(), kInsideArmM);
  tether.LayOut({2.0, 0.0, 0.0}, 2.34);
  for (double angle = 0.0; angle < 1.4; angle += 1e-3) {
    const Eigen::Vector3d p(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
    tether.Step(p, Eigen::Vector3d::Zero(), 2.34, 0.0);
    ASSERT_NEAR(tether.free_m(), 2.34, 1e-12);
  }
}

TEST(TetherShape, SlackLiesOnTheGround) {
  const HeightGrid ground = LevelGrid(-1.0, 8.0, 4.0, 0.1);
  const auto points =
      HangingTether(TestRover().tether, ground, {3.0, 0, 0.3}, {0, 0, 0.4}, 0.0, 0.3);
  double lowest = 1.0;
  for (const auto& p : points) lowest = std::min(lowest, p.z());
  EXPECT_NEAR(lowest, 0.003, 1e-12);
}

TEST(TetherShape, TautSagsByWeightTimesSpanSquaredOverEightTensions) {
  const HeightGrid ground = LevelGrid(-1.0, 8.0, 4.0, 0.1);
  const auto points =
      HangingTether(TestRover().tether, ground, {4.0, 0, 1.0}, {0, 0, 1.0}, 20.0, 0.0);
  double lowest = 1.0;
  for (const auto& p : points) lowest = std::min(lowest, p.z());
  EXPECT_NEAR(1.0 - lowest, 0.05 * 9.81 * 16.0 / (8.0 * 20.0), 1e-9);
}

}  // namespace
}  // namespace dockyard
