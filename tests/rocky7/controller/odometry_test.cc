#include "controller/rocky7/odometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/motion/arcs.h"

namespace dockyard::rocky7 {
namespace {

constexpr OdometryOptions kByUnit{.turn_by_unit = true, .slip = 0.1};

TEST(Odometry, WithoutAUnitItBelievesTheWheels) {
  Odometry odometry(OdometryOptions{});
  odometry.Begin(0.3);
  const Arc arc{0.4, 0.3};
  Pose2 sum;
  for (const double share : {0.25, 0.5, 1.0}) {
    sum = sum * odometry.Step(share * 0.4, Advance({}, Part(arc, share)), {.yaw_rad = 2.0});
  }
  const Pose2 whole = Advance({}, arc);
  EXPECT_NEAR(sum.x, whole.x, 1e-12);
  EXPECT_NEAR(sum.y, whole.y, 1e-12);
  EXPECT_NEAR(sum.heading, whole.heading, 1e-12);
}

// The distance by the wheels less the slip, the turn by the unit.
TEST(Odometry, WithAUnitItIsAnArcOfTheCountedDistanceLessSlip) {
  Odometry odometry(kByUnit);
  odometry.Begin(1.0);
  const Pose2 since = odometry.Step(0.5, {0.5, 0.0, 0.0}, {.yaw_rad = 1.2});
  const double radius_m = 0.45 / 0.2;
  EXPECT_NEAR(since.x, radius_m * std::sin(0.2), 1e-12);
  EXPECT_NEAR(since.y, radius_m * (1.0 - std::cos(0.2)), 1e-12);
  EXPECT_NEAR(since.heading, 0.2, 1e-12);
}

// The gain of two independent measurements: the slip's variance over the sum of both.
TEST(Odometry, LearnsSlipByTheRatioOfVariances) {
  Odometry odometry(kByUnit);
  const double driven_m = 0.4, sigma_m = 0.01;
  odometry.Learn(0.02, sigma_m, driven_m);
  const double by_slip2 = std::pow(kSlipSigma * driven_m, 2);
  const double gain = by_slip2 / (by_slip2 + sigma_m * sigma_m);
  EXPECT_NEAR(odometry.SlipOn(1.0), 0.1 + gain * 0.02 / driven_m, 1e-12);
  EXPECT_EQ(odometry.SlipOn(-1.0), 0.1);
}

// What the wheels turn for an arc, less the slip and the share of the turn, is the arc.
TEST(Odometry, AgainstSlipTheWheelsTurnSoMuchThatTheArcIsDriven) {
  Odometry odometry(kByUnit);
  odometry.Learn(-0.12, 1e-6, -0.4);
  for (const Arc& arc : {Arc{0.3, 0.2}, Arc{-0.2, 0.1}}) {
    const Arc turned = odometry.AgainstSlip(arc);
    EXPECT_NEAR((1.0 - odometry.SlipOn(arc.length_m)) * turned.length_m, arc.length_m, 1e-12);
    EXPECT_NEAR(kTurnShare * turned.turn_rad, arc.turn_rad, 1e-12);
  }
  EXPECT_NEAR(odometry.AgainstSlip({0.3, 0.0}).length_m, 0.3 / 0.9, 1e-12);
  EXPECT_NEAR(odometry.AgainstSlip({-0.3, 0.0}).length_m, -0.3 / 0.6, 1e-4);
}

TEST(Odometry, CountsSlipFromWhereItWasLearnt) {
  Odometry odometry(kByUnit);
  odometry.Begin(0.0);
  EXPECT_NEAR(odometry.Step(0.1, {0.1, 0.0, 0.0}, {.yaw_rad = 0.0}).x, 0.09, 1e-12);
  odometry.Learn(0.02, 1e-6, 0.1);
  EXPECT_NEAR(odometry.Step(0.2, {0.2, 0.0, 0.0}, {.yaw_rad = 0.0}).x, 0.07, 1e-6);
}

// Each metre at a roll of 10 deg goes 6 cm downhill; measured 1 cm off, alternately.
TEST(Odometry, LearnsTheDriftOfACrossSlope) {
  Odometry odometry({.turn_by_unit = true, .slip = 0.1, .drifts = true});
  const double roll_rad = Radians(10.0), drift = -0.06 / std::sin(roll_rad);
  EXPECT_EQ(odometry.DriftOn(1.0, roll_rad), 0.0);
  for (int i = 0; i < 8; ++i) {
    const double rolled_m = 0.2 * std::sin(roll_rad);
    const double error_m = i % 2 == 0 ? 0.01 : -0.01;
    const double left_m = drift * rolled_m - odometry.DriftOn(0.2, roll_rad) + error_m;
    odometry.LearnDrift(left_m, 0.01, rolled_m);
  }
  EXPECT_NEAR(odometry.DriftOn(1.0, roll_rad), -0.06, 0.01);
  EXPECT_NEAR(odometry.DriftOn(-1.0, roll_rad), -0.06, 0.01);  // backwards, too
  EXPECT_NEAR(odometry.DriftOn(1.0, -roll_rad), 0.06, 0.01);
  EXPECT_EQ(odometry.DriftOn(1.0, 0.0), 0.0);
  odometry.Begin(0.0);
  const Pose2 since = odometry.Step(0.5, {0.5, 0.0, 0.0}, {.roll_rad = roll_rad, .yaw_rad = 0.0});
  EXPECT_NEAR(since.y, -0.03, 0.005);
}

// On level ground an error to the side is no drift.
// A Kalman filter of one state: with a detection as good as the prior half of the variance is left.
TEST(Odometry, ADriftIsLessUnsureOnceItIsDetected) {
  Odometry odometry({.turn_by_unit = true, .slip = 0.1, .drifts = true});
  EXPECT_NEAR(odometry.DriftSigma(-0.1), 0.1 * kDriftSigma, 1e-12);
  odometry.LearnDrift(-0.08, 0.1 * kDriftSigma, 0.1);
  EXPECT_NEAR(odometry.DriftSigma(0.1), 0.1 * kDriftSigma * std::sqrt(0.5), 1e-12);
  EXPECT_EQ(Odometry(kByUnit).DriftSigma(0.1), 0.0);
}

TEST(Odometry, LevelGroundTeachesNoDrift) {
  Odometry odometry({.turn_by_unit = true, .slip = 0.1, .drifts = true});
  for (int i = 0; i < 50; ++i) odometry.LearnDrift(i % 3 == 0 ? 0.01 : -0.005, 0.01, 1e-3);
  EXPECT_NEAR(odometry.DriftOn(1.0, Radians(0.3)), 0.0, 0.004);
}

TEST(Odometry, SlipAheadAndBackAreLearntApartAndStayWithinBounds) {
  Odometry odometry(kByUnit);
  odometry.Learn(0.5, 1e-6, 0.4);
  odometry.Learn(0.5, 1e-6, -0.4);
  EXPECT_EQ(odometry.SlipOn(0.1), kMostSlip);
  EXPECT_EQ(odometry.SlipOn(-0.1), 0.0);
  Odometry believes(OdometryOptions{});
  believes.Learn(0.5, 1e-6, 0.4);
  EXPECT_EQ(believes.SlipOn(0.1), 0.0);
}

// A turn of 4 deg teaches half of what it shows (odometry.cc), a large one nearly all.
TEST(Odometry, LearnsTheShareOfTheTurnByItsSize) {
  for (const double counted_rad : {Radians(4.0), 1.5}) {
    Odometry odometry(kByUnit);
    odometry.Begin(0.0);
    odometry.Step(0.5, {0.5, 0.0, counted_rad}, {.yaw_rad = 0.6 * counted_rad});
    odometry.Begin(0.6 * counted_rad);
    const double noise = Radians(4.0) / counted_rad;
    EXPECT_NEAR(odometry.turn_share(), kTurnShare + (0.6 - kTurnShare) / (1.0 + noise * noise),
                1e-12);
  }
}

TEST(Odometry, AStraightArcTeachesNothingOfTurns) {
  Odometry odometry(kByUnit);
  odometry.Begin(0.0);
  odometry.Step(0.5, {0.5, 0.0, 0.0}, {.yaw_rad = 0.1});
  odometry.Begin(0.1);
  EXPECT_EQ(odometry.turn_share(), kTurnShare);
}

}  // namespace
}  // namespace dockyard::rocky7
