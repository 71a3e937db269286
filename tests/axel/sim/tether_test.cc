#include "sim/axel/tether.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "axel/sim/product.h"
#include "sim/axel/tether_path.h"
#include "sim/base/random.h"
#include "sim/cable/cable_shape.h"

namespace dockyard::axel {
namespace {

const Eigen::Matrix3d kLevel = Eigen::Matrix3d::Identity();

constexpr double kInsideArm_m = 1.0;
constexpr double kDt = 1e-3;
constexpr double kG = 9.81;  // [m/s^2]

TEST(TetherPath, IsStraightOnTheAxis) {
  const TetherPath path = FindTetherPath(Station().cone, 0.35, {2.0, 0.0});
  EXPECT_EQ(path.pieces, 1);
  EXPECT_DOUBLE_EQ(path.total_m(), 2.35);
}

TEST(TetherPath, BendsOverThroatAndLipFromTheSide) {
  const TetherPath path = FindTetherPath(Station().cone, 0.35, {1.0, 2.0});
  ASSERT_EQ(path.pieces, 3);
  EXPECT_DOUBLE_EQ(path.length_m[0], std::hypot(1.0, 1.88));
  EXPECT_DOUBLE_EQ(path.length_m[1], std::hypot(0.12, 0.088));
  EXPECT_DOUBLE_EQ(path.length_m[2], std::hypot(0.23, 0.0320));
  EXPECT_NEAR(path.turn_rad[0] + path.turn_rad[1], std::atan2(1.88, 1.0) - std::atan2(0.0320, 0.23),
              1e-12);
}

TEST(TetherPath, IsAsShortAsABruteForceSearchFinds) {
  const ConeModel cone = Station().cone;
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
  const ConeModel cone = Station().cone;
  double last = FindTetherPath(cone, 0.35, {2.0, 0.0}).total_m();
  for (double angle = 1e-3; angle < 1.5; angle += 1e-3) {
    const Eigen::Vector2d tip(2.0 * std::cos(angle), 2.0 * std::sin(angle));
    const double now = FindTetherPath(cone, 0.35, tip).total_m();
    EXPECT_LT(std::abs(now - last), 2.0 * 1e-3);
    last = now;
  }
}

TEST(Tether, NeverPushes) {
  Tether tether(Axel().tether, Station(), kInsideArm_m);
  tether.LayOut({2.0, 0.0, 0.0}, 2.5);
  const TetherLoad load = tether.Step({2.0, 0.0, 0.0}, {1.0, 0, 0}, 2.5, 0.0);
  EXPECT_EQ(load.tension_n, 0.0);
  EXPECT_EQ(load.force_on_tip_M.norm(), 0.0);
}

/// 30 kg on the axis, released where the tether is just straight, with a tenth of critical damping.
struct Hung {
  double stretch_m = 0.0, tension_n = 0.0, peak_n = 0.0;
};
Hung Hang(double stiffness_n_per_m, double seconds) {
  const double mass = 30.0, free = 2.35;
  TetherModel model = Axel().tether;
  model.axial_stiffness_n = stiffness_n_per_m * (free + kInsideArm_m);
  model.damping_ns_per_m = 0.1 * 2.0 * std::sqrt(stiffness_n_per_m * mass);
  Tether tether(model, Station(), kInsideArm_m);
  Eigen::Vector3d p(2.0, 0.0, 0.0), v = Eigen::Vector3d::Zero();
  tether.LayOut(p, free);
  Hung hung;
  for (long i = 0; i < std::lround(seconds / kDt); ++i) {
    const TetherLoad load = tether.Step(p, v, free, 0.0);
    v += (load.force_on_tip_M / mass + Eigen::Vector3d(9.81, 0, 0)) * kDt;
    p += v * kDt;
    hung.tension_n = load.tension_n;
    hung.peak_n = std::max(hung.peak_n, load.tension_n);
  }
  hung.stretch_m = p.x() - 2.0;
  return hung;
}

/// Peak of k x + c v of a damped spring that is loaded at once, in units of the load:
/// 1 - exp(-z w t)(cos(d t) - z / s sin(d t)), s = sqrt(1 - z^2), d = w s.
double PeakOfADampedSpring(double z) {
  const double s = std::sqrt(1.0 - z * z);
  double peak = 0.0;
  for (double t = 0.0; t < 2.0 * kPi; t += 1e-4) {
    peak = std::max(peak, 1.0 - std::exp(-z * t) * (std::cos(s * t) - z / s * std::sin(s * t)));
  }
  return peak;
}

TEST(Tether, HangingMassStretchesByHookesLawAndPeaksAsADampedSpring) {
  const double weight = 30.0 * 9.81;
  EXPECT_NEAR(PeakOfADampedSpring(0.1) * weight, 514.0, 2.0);
  for (double k : {2e4, 2e5}) {
    const Hung hung = Hang(k, 8.0);
    EXPECT_NEAR(hung.tension_n, weight, 1e-6);
    EXPECT_NEAR(hung.stretch_m, weight / k, 1e-9);
    EXPECT_NEAR(hung.peak_n, PeakOfADampedSpring(0.1) * weight, 0.01 * 514.0) << k;
  }
}

TEST(Tether, CatchesADroppedMassAfterTheFreeFall) {
  for (double slack : {0.01, 0.1, 0.5}) {
    Tether tether(Axel().tether, Station(), kInsideArm_m);
    Eigen::Vector3d p(2.0, 0.0, 0.0), v = Eigen::Vector3d::Zero();
    tether.LayOut(p, 2.35 + slack);
    int steps = 0;
    while (steps < 1000) {
      if (tether.Step(p, v, 2.35 + slack, 0.0).tension_n > 0.0) break;
      v += Eigen::Vector3d(9.81, 0, 0) * kDt;
      p += v * kDt;
      ++steps;
    }
    EXPECT_NEAR(steps * kDt, std::sqrt(2.0 * slack / 9.81), kDt) << slack;
  }
}

/// Draws the tether in from the side until it slides over both edges.
TetherLoad PullFromTheSide(double friction, Tether* out = nullptr) {
  TetherModel model = Axel().tether;
  model.friction_on_station = friction;
  Tether tether(model, Station(), kInsideArm_m);
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
  Tether tether(Axel().tether, Station(), kInsideArm_m);
  const TetherLoad load = PullFromTheSide(0.3, &tether);
  ASSERT_EQ(load.nodes, 3);
  const TetherPath& path = tether.path();
  const double at_anchor = load.force_on_station_M[2].norm();
  const double wrap = path.turn_rad[0] + path.turn_rad[1];
  EXPECT_NEAR(load.tension_n / at_anchor, std::exp(0.3 * wrap), 1e-6);
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
  Tether tether(Axel().tether, Station(), kInsideArm_m);
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
      HangingTether(Axel().tether, ground, kLevel, {3.0, 0, 0.3}, {0, 0, 0.4}, 0.0, 0.3, kG);
  double lowest = 1.0;
  for (const auto& p : points) lowest = std::min(lowest, p.z());
  EXPECT_NEAR(lowest, 0.003, 1e-12);
}

double Length(const std::vector<Eigen::Vector3d>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

TEST(TetherShape, TautHangsInTheCatenaryOfItsTension) {
  // a = H / w with H = T - w sag at level supports: sag = a (cosh(h / 2a) - 1), length
  // 2 a sinh(h / 2a).
  const HeightGrid ground = LevelGrid(-1.0, 8.0, 4.0, 0.1);
  const double span = 4.0;
  for (const auto& [tension, g] :
       {std::pair(2.0, kG), {5.0, kG}, {20.0, kG}, {100.0, kG}, {2.0, 3.71}, {20.0, 3.71}}) {
    const double w = 0.05 * g;
    const auto points =
        HangingTether(Axel().tether, ground, kLevel, {span, 0, 1.0}, {0, 0, 1.0}, tension, 0.0, g);
    double a = tension / w;
    for (int i = 0; i < 50; ++i) a = (tension / w) / std::cosh(0.5 * span / a);
    double lowest = 1.0;
    for (const auto& p : points) lowest = std::min(lowest, p.z());
    EXPECT_NEAR(1.0 - lowest, a * (std::cosh(0.5 * span / a) - 1.0), 1e-6) << tension;
    const double length = 2.0 * a * std::sinh(0.5 * span / a);
    EXPECT_NEAR(Length(points), length, 1e-4 * length) << tension;
  }
}

TEST(TetherShape, SlackHangsInTheCatenaryOfItsLength) {
  const HeightGrid ground = LevelGrid(-1.0, 8.0, 4.0, 0.1);
  for (double rise : {0.0, 0.4}) {
    const Eigen::Vector3d tip(3.0, 0.2, 5.0), anchor(0.0, 0.0, 5.0 + rise);
    const double straight = (anchor - tip).norm(), excess = 0.3;
    const auto points = HangingTether(Axel().tether, ground, kLevel, tip, anchor, 0.0, excess, kG);
    EXPECT_EQ(points.front(), tip);
    EXPECT_EQ(points.back(), anchor);
    EXPECT_NEAR(Length(points), straight + excess, 2e-3 * straight) << rise;
    // Every inner point stands where a catenary has it: z'' = sqrt(1 + z'^2) / a with one a.
    const double dx = (points[1] - points[0]).head<2>().norm();
    double least = 1e9, most = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const double second =
          (points[i + 1].z() - 2.0 * points[i].z() + points[i - 1].z()) / (dx * dx);
      const double first = (points[i + 1].z() - points[i - 1].z()) / (2.0 * dx);
      const double a = std::sqrt(1.0 + first * first) / second;
      least = std::min(least, a);
      most = std::max(most, a);
    }
    EXPECT_NEAR(least, most, 5e-3 * most) << rise;
  }
}

}  // namespace
}  // namespace dockyard::axel
