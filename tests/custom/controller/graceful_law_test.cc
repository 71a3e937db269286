#include "controller/custom/graceful_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/motion/arcs.h"

namespace dockyard::custom {
namespace {

struct Path {
  Pose2 X_TA;  // at its end, in the target
  double length_m = 0.0;
  double most_curvature = 0.0;  // within the last fifth of a metre
  double curvature = 0.0;       // at its end
};

/// Drives along the law from a pose until it is `near_m` from the target.
Path DriveAlong(Pose2 X_TA, double travel, const DockingOptions& options, double near_m = 0.02) {
  Path path;
  for (int i = 0; i < 20000 && std::hypot(X_TA.x, X_TA.y) > near_m; ++i) {
    const Twist twist = GracefulTwist(Inverse(X_TA), travel, options);
    const Arc step{0.005 * twist.speed_m_s, 0.005 * twist.turn_rad_s};
    X_TA = Advance(X_TA, step);
    path.length_m += std::abs(step.length_m);
    path.curvature = std::abs(twist.turn_rad_s / twist.speed_m_s);
    if (std::hypot(X_TA.x, X_TA.y) < 0.2)
      path.most_curvature = std::max(path.most_curvature, path.curvature);
  }
  path.X_TA = X_TA;
  return path;
}

TEST(GracefulLaw, IsThePapersEquationAtSamplePoints) {
  // (14) with k1 = 1, k2 = 3, written out: r = 2, theta = 1, delta = 0.5:
  // -(1/2)(3 (0.5 + pi/4) + (1 + 1/2) sin 0.5).
  const DockingOptions paper{.k_phi = 1.0, .k_delta = 3.0};
  EXPECT_NEAR(GracefulCurvature({2.0, 1.0, 0.5}, paper),
              -0.5 * (3.0 * (0.5 + 0.25 * kPi) + 1.5 * std::sin(0.5)), 1e-12);
  // theta = 0: -(1/r)(k2 delta + (1 + k1) sin delta).
  EXPECT_NEAR(GracefulCurvature({0.5, 0.0, -0.3}, paper), 2.0 * (0.9 + 2.0 * std::sin(0.3)), 1e-12);
  // delta = 0: (k2/r) atan(-k1 theta).
  const DockingOptions nav2{};
  EXPECT_NEAR(GracefulCurvature({1.0, -0.7, 0.0}, nav2), 2.0 * std::atan(2.1), 1e-12);
}

TEST(GracefulLaw, TurnsWithTheErrorOfTheHeadingAtTheSpeedRatioOfThePaper) {
  // (13): the error z = delta - atan(-k1 theta) falls as dz/dt = -k2 (v/r) z.
  const DockingOptions options{};
  const Pose2 X_TA{-1.2, 0.4, 0.3};
  const auto error = [&](const Pose2& at) {
    const SightCoords coords = ToSightCoords(Inverse(at));
    return coords.delta_rad - std::atan(-options.k_phi * coords.theta_rad);
  };
  const double curvature = GracefulCurvature(ToSightCoords(Inverse(X_TA)), options);
  const double h = 1e-6;
  const double slope = (error(Advance(X_TA, Arc{h, h * curvature})) -
                        error(Advance(X_TA, Arc{-h, -h * curvature}))) /
                       (2.0 * h);
  EXPECT_NEAR(slope, -options.k_delta * error(X_TA) / std::hypot(X_TA.x, X_TA.y), 1e-6);
}

TEST(GracefulLaw, SpeedFollowsTheCurvatureAndFallsNearTheTarget) {
  DockingOptions options{};
  options.least_m_s = 0.001;
  const Pose2 X_AT{1.0, 0.2, 0.5};
  const double curvature = GracefulCurvature(ToSightCoords(X_AT), options);
  const Twist twist = GracefulTwist(X_AT, 1.0, options);
  EXPECT_NEAR(twist.speed_m_s, 0.25 / (1.0 + 0.4 * curvature * curvature), 1e-12);
  EXPECT_NEAR(twist.turn_rad_s, curvature * twist.speed_m_s, 1e-12);
  EXPECT_NEAR(GracefulTwist({0.05, 0.0, 0.0}, 1.0, options).speed_m_s, 0.25 * 0.05 / 0.25, 1e-12);
}

TEST(GracefulLaw, GoesStraightWhereTheRobotPointsAtATargetThatPointsAway) {
  for (const double travel : {1.0, -1.0}) {
    const Twist twist = GracefulTwist({travel * 1.0, 0.0, 0.0}, travel, DockingOptions{});
    EXPECT_NEAR(twist.turn_rad_s, 0.0, 1e-9);
    EXPECT_NEAR(twist.speed_m_s, travel * 0.25, 1e-9);
  }
}

TEST(GracefulLaw, BackwardIsForwardOfTheRobotTurnedHalfRound) {
  const Pose2 half{0.0, 0.0, kPi}, X_AT{-0.9, 0.3, 0.4};
  const Twist backward = GracefulTwist(X_AT, -1.0, DockingOptions{});
  const Twist forward = GracefulTwist(half * X_AT * half, 1.0, DockingOptions{});
  EXPECT_NEAR(backward.speed_m_s, -forward.speed_m_s, 1e-12);
  EXPECT_NEAR(backward.turn_rad_s, forward.turn_rad_s, 1e-9);
}

TEST(GracefulLaw, ReachesThePoseFromAGridOfStartsWithLittleCurvatureAtItsEnd) {
  const DockingOptions options{};
  for (const double travel : {1.0, -1.0}) {
    for (const double r : {0.7, 1.5, 3.0}) {
      for (double bearing = -60.0; bearing <= 60.0; bearing += 20.0) {
        for (double heading = -60.0; heading <= 60.0; heading += 20.0) {
          const Pose2 start{-travel * r * std::cos(Radians(bearing)),
                            -travel * r * std::sin(Radians(bearing)), Radians(heading)};
          const Path path = DriveAlong(start, travel, options);
          EXPECT_LT(std::abs(path.X_TA.y), 0.002) << r << " " << bearing << " " << heading;
          EXPECT_LT(std::abs(path.X_TA.heading), 0.05) << r << " " << bearing << " " << heading;
          EXPECT_LT(path.length_m, 2.0 * r + 1.0) << r << " " << bearing << " " << heading;
          // Its error falls as r to the power of k_delta = 2, so the curvature falls as r: here to
          // a tenth.
          EXPECT_LT(path.curvature, 0.25 * path.most_curvature + 0.2)
              << r << " " << bearing << " " << heading;
        }
      }
    }
  }
}

TEST(GracefulLaw, KeepsTheLimitsOfSpeedAndTurningRate) {
  const DockingOptions options{};
  for (double x = -1.0; x <= 1.0; x += 0.1) {
    for (double y = -1.0; y <= 1.0; y += 0.1) {
      const Pose2 X_AT{x, y, 3.0 * x};
      const Twist twist = GracefulTwist(X_AT, 1.0, options);
      EXPECT_LE(twist.speed_m_s, options.most_m_s);
      EXPECT_LE(std::abs(twist.turn_rad_s), options.most_rad_s + 1e-12);
      EXPECT_GT(twist.speed_m_s, 0.0);
    }
  }
}

}  // namespace
}  // namespace dockyard::custom
