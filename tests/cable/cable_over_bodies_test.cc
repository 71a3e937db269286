// A cable over solids against the capstan's law, T_1 / T_2 = exp(mu x turn) (Euler, Eytelwein).
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "cable/cords.h"

namespace dockyard {
namespace {

/// The tension at the fed end while a cable is drawn in or paid out over a solid whose top right
/// edge is at (edge, 0, edge), against a constant pull straight down. The solid may turn about y.
struct Drawn {
  double least_n = 1e9, most_n = 0.0, mean_n = 0.0;
};
Drawn DrawOver(const CableBody& over_body, double edge_m, const Eigen::Vector3d& fed, double pull_n,
               double rate_m_s) {
  const double radius = 0.5 * Cord().diameter_m, step_m = Cord().spacing_m;
  const Eigen::Vector3d over(edge_m + radius, 0.0, edge_m + radius);
  const Eigen::Vector3d along = (over - fed).normalized(), down(0.0, 0.0, -1.0);
  Cable cable(Cord());
  cable.LayOut(fed, fed + step_m * along, 1);
  const double first = (over - fed).norm();
  for (double s = 2.0 * step_m; s < first + 2.5; s += step_m) {
    const Eigen::Vector3d p =
        s < first ? Eigen::Vector3d(fed + s * along) : Eigen::Vector3d(over + (s - first) * down);
    cable.AddLast(p, Eigen::Vector3d::Zero(), step_m);
  }
  const ConstantEnd load(pull_n * down);
  std::vector<CableBody> bodies{over_body};
  CableStep step;
  step.bodies = &bodies;
  step.p_GF = fed;
  step.end = &load;
  Drawn drawn;
  const int steps = 8000, counted = 5000;
  for (int i = 0; i < steps; ++i) {
    step.fed_m = rate_m_s * step.step_s;
    const double turned = i * step.step_s * over_body.motion.w_GL_G.y();
    bodies[0].motion.X_GL.R = RotY(turned) * over_body.motion.X_GL.R;
    cable.Step(step);
    if (i < steps - counted) continue;
    drawn.least_n = std::min(drawn.least_n, cable.tension_at_fed_end_n());
    drawn.most_n = std::max(drawn.most_n, cable.tension_at_fed_end_n());
    drawn.mean_n += cable.tension_at_fed_end_n() / counted;
  }
  return drawn;
}

TEST(CableOverBodies, SlidesOverAnEdgeAtTheCapstansRatio) {
  const Eigen::Vector3d fed(-1.5, 0.0, 0.6);
  const double turn = std::atan2(2.003, -0.097);  // from the line to fed to straight down
  for (const double mu : {0.0, 0.2, 0.5}) {
    const CableBody box = CableBox({1.0, 1.0, 1.0}, mu);
    const double ratio = std::exp(mu * (kPi - turn));
    const Drawn in = DrawOver(box, 0.5, fed, 30.0, -0.1), out = DrawOver(box, 0.5, fed, 30.0, 0.1);
    EXPECT_NEAR(in.mean_n, 30.0 * ratio, 0.005 * 30.0 * ratio) << mu;
    EXPECT_NEAR(out.mean_n, 30.0 / ratio, 0.005 * 30.0 / ratio) << mu;
    // A mass that passes the edge is felt for a millisecond.
    EXPECT_GT(in.least_n, 0.85 * 30.0 * ratio) << mu;
    EXPECT_LT(in.most_n, 1.15 * 30.0 * ratio) << mu;
  }
}

TEST(CableOverBodies, SlidesOverAWheelAtTheCapstansRatio) {
  for (const int sides : {12, 20}) {
    CableBody wheel = CablePrism(0.3, 0.15, sides, 0.1, 0.3);
    wheel.motion.X_GL.R = RotX(0.5 * kPi);
    const double ratio = std::exp(0.3 * 0.5 * kPi);
    const Drawn drawn = DrawOver(wheel, 0.3, {-1.5, 0.0, 0.303}, 30.0, -0.1);
    EXPECT_NEAR(drawn.mean_n, 30.0 * ratio, 0.01 * 30.0 * ratio) << sides;
    EXPECT_LT(drawn.most_n - drawn.least_n, 0.05 * 30.0 * ratio) << sides;
  }
}

TEST(CableOverBodies, SlidesOverARocksEdgeAtTheCapstansRatio) {
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double z : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) corners.emplace_back(x, y, z);
    }
  }
  corners.emplace_back(-0.9, 0.0, -0.2);  // a ridge behind
  const double mu = 0.4, ratio = std::exp(mu * (kPi - std::atan2(2.003, -0.097)));
  const Drawn drawn = DrawOver(CableRock(HullOf(corners), mu), 0.5, {-1.5, 0.0, 0.6}, 30.0, -0.1);
  EXPECT_NEAR(drawn.mean_n, 30.0 * ratio, 0.005 * 30.0 * ratio);
}

TEST(CableOverBodies, HoldsByFrictionWhatTheCapstansRatioCarries) {
  // 30 N on one side; on the other a hand pays out until nothing slides any more.
  const double ratio = std::exp(0.3 * 0.5 * kPi);
  const CableBody box = CableBox({1.0, 1.0, 1.0}, 0.3);
  const Drawn held = DrawOver(box, 0.5, {-1.5, 0.0, 0.503}, 30.0, 0.0);
  EXPECT_LT(held.most_n, 30.0 * ratio);
  EXPECT_GT(held.least_n, 30.0 / ratio * 0.999);
  EXPECT_LT(held.most_n - held.least_n, 1e-3);
}

TEST(CableOverBodies, IsDraggedAlongByATurningWheelAtTheCapstansRatio) {
  // Held at both ends, the cable rubs on the wheel that turns below it.
  for (const double rad_s : {0.3, -0.3}) {
    CableBody wheel = CablePrism(0.3, 0.15, 12, 0.1, 0.3);
    wheel.motion.w_GL_G = {0.0, rad_s, 0.0};  // > 0: towards the load
    wheel.motion.X_GL.R = RotX(0.5 * kPi);
    const double ratio = std::exp(0.3 * 0.5 * kPi),
                 wanted = rad_s > 0.0 ? 30.0 * ratio : 30.0 / ratio;
    const Drawn drawn = DrawOver(wheel, 0.3, {-1.5, 0.0, 0.303}, 30.0, 0.0);
    EXPECT_NEAR(drawn.mean_n, wanted, 0.02 * wanted) << rad_s;
    EXPECT_LT(drawn.most_n - drawn.least_n, 0.1 * wanted) << rad_s;
  }
}

}  // namespace
}  // namespace dockyard
