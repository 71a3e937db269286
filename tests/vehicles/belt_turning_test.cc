// How belts turn a robot, against closed forms. For uniform pressure and Coulomb friction the
// effective gauge solves, with u half of what it has more than the gauge B and a half the length,
//   B u asinh(a / u) = a sqrt(a^2 + u^2) - u^2 asinh(a / u).
// The instantaneous centres are those of Martinez et al. (IROS 2004).
#include <gtest/gtest.h>

#include <cmath>

#include "vehicles/belt_rig.h"

namespace dockyard {
namespace {

constexpr double kGauge_m = 0.426, kLength_m = 0.386;

/// The root u of the equation above.
double BeyondGauge(double length_m, double gauge_m) {
  const double a = 0.5 * length_m;
  double low = 1e-9, high = 10.0 * length_m;
  for (int i = 0; i < 200; ++i) {
    const double u = 0.5 * (low + high), log = std::asinh(a / u);
    const bool too_wide = gauge_m * u * log > a * std::hypot(a, u) - u * u * log;
    (too_wide ? high : low) = u;
  }
  return low;
}
double ClosedGauge(double length_m, double gauge_m) {
  return gauge_m + 2.0 * BeyondGauge(length_m, gauge_m);
}

BeltGround Floor(double friction, double lateral_ratio = 1.0) {
  BeltGround floor = kHardFloor;
  floor.friction = friction;
  floor.lateral_ratio = lateral_ratio;
  return floor;
}

TEST(TurningInPlace, HasTheClosedFormsEffectiveGauge) {
  const double ratios[] = {0.6, 0.8, 0.906, 1.0, 1.2, 1.4, 1.6, 2.0};
  const double published[] = {1.058, 1.116, 1.158, 1.201, 1.314, 1.456, 1.629, 2.066};
  for (std::size_t i = 0; i < std::size(ratios); ++i) {
    const double length = ratios[i] * kGauge_m;
    EXPECT_NEAR(ClosedGauge(length, kGauge_m) / kGauge_m, published[i], 6e-4) << ratios[i];
    BeltRig rig = TwoBelts(length, kGauge_m);
    const Turning turn = TurnInPlace(rig);
    EXPECT_NEAR(turn.gauge_m / kGauge_m, published[i], 0.01 * published[i]) << ratios[i];
    EXPECT_LT(turn.ripple, 1e-4) << ratios[i];
  }
}

TEST(TurningInPlace, NeedsTheClosedFormsMoment) {
  const double shares[] = {0.94, 0.85}, ratios[] = {0.906, 1.456};
  for (std::size_t i = 0; i < 2; ++i) {
    const double length = ratios[i] * kGauge_m, a = 0.5 * length;
    const double u = BeyondGauge(length, kGauge_m);
    const double share = (a * std::hypot(a, u) - u * u * std::asinh(a / u)) / (a * a);
    EXPECT_NEAR(share, shares[i], 0.006);
    BeltRig rig = TwoBelts(length, kGauge_m);
    TurnInPlace(rig);
    const double moment =
        0.5 * kGauge_m * (rig.belts[1].load.traction_n - rig.belts[0].load.traction_n);
    const double sideways = 0.25 * kHardFloor.friction * rig.Weight() * length;
    EXPECT_NEAR(moment / sideways, share, 0.02 * share) << ratios[i];
  }
}

TEST(TurningInPlace, WithoutLongitudinalSlipTakesAQuarterOfLoadTimesLength) {
  BeltRig rig = TwoBelts(kLength_m, kGauge_m);
  rig.Run(0.5);
  const double rate = 0.2;
  rig.Drive(-0.5 * kGauge_m * rate, 0.5 * kGauge_m * rate);
  rig.w_GR_G = {0.0, 0.0, rate};
  rig.v_GCom_G.setZero();
  Eigen::Vector3d torque;
  for (int i = 0; i < 3000; ++i) {
    torque = rig.Load(1e-3).second;
    rig.X_GR.R =
        Eigen::AngleAxisd(1e-3 * rate, Eigen::Vector3d::UnitZ()).toRotationMatrix() * rig.X_GR.R;
  }
  const double closed = 0.25 * kHardFloor.friction * rig.Weight() * kLength_m;
  EXPECT_NEAR(-torque.z(), closed, 0.02 * closed);
}

TEST(TurningInPlace, DoesNotDependOnFriction) {
  double least = 1e9, most = 0.0;
  for (const double friction : {0.3, 0.6, 0.9}) {
    BeltRig rig = TwoBelts(kLength_m, kGauge_m, 0.0, Floor(friction));
    const double gauge = TurnInPlace(rig).gauge_m;
    least = std::min(least, gauge);
    most = std::max(most, gauge);
  }
  EXPECT_LT(most / least, 1.01);
}

TEST(TurningInPlace, WidensWithLateralFriction) {
  const double ratios[] = {0.8, 1.0, 1.2}, gauges[] = {0.58, 0.64, 0.70};
  for (std::size_t i = 0; i < 3; ++i) {
    BeltRig rig = TwoBelts(1.456 * kGauge_m, kGauge_m, 0.0, Floor(0.6, ratios[i]));
    EXPECT_NEAR(TurnInPlace(rig).gauge_m, gauges[i], 0.0125 * gauges[i]) << ratios[i];
  }
}

// Coulomb's law on Janosi and Hanamoto's curve, integrated over the contact as Wong and Chiang do.
TEST(TurningInPlace, NarrowsWithTheShearDisplacement) {
  const double K_mm[] = {0.1, 1.0, 5.0, 10.0, 25.0, 50.0};
  const double gauges[] = {0.493, 0.493, 0.491, 0.488, 0.481, 0.473};
  for (std::size_t i = 0; i < std::size(K_mm); ++i) {
    BeltGround ground = kHardFloor;
    ground.shear_displacement_m = 1e-3 * K_mm[i];
    BeltRig rig = TwoBelts(kLength_m, kGauge_m, 0.0, ground);
    EXPECT_NEAR(TurnInPlace(rig).gauge_m, gauges[i], 0.01 * gauges[i]) << K_mm[i];
  }
}

// Belts that run as fast as the ground under them slide sideways only.
TEST(TurningInPlace, TurnsAboutThePressuresMedianWithSideFrictionAlone) {
  for (const double ahead : {0.02, 0.05, 0.1, 1.0 / 6.0}) {
    BeltRig rig = TwoBelts(kLength_m, kGauge_m, ahead * kLength_m);
    const double rate = 0.1;
    rig.Run(0.5);
    rig.Drive(-0.5 * kGauge_m * rate, 0.5 * kGauge_m * rate);
    for (int i = 0; i < 3000; ++i) {
      rig.twist_nm = 1000.0 * (rate - rig.w_GR_G.z());
      rig.Step(1e-3);
    }
    const double centre = -rig.VelocityInR().y() / rig.w_GR_G.z();
    const double median = (std::sqrt(1.0 + 36.0 * ahead * ahead) - 1.0) / (12.0 * ahead);
    EXPECT_NEAR(centre, median * kLength_m, 0.003) << ahead;
  }
}

TEST(TurningInPlace, TurnsNearThePressuresMedianWithBothFrictions) {
  const double ahead[] = {0.05, 0.1, 1.0 / 6.0}, centres[] = {0.070, 0.135, 0.205};
  for (std::size_t i = 0; i < 3; ++i) {
    BeltRig rig = TwoBelts(kLength_m, kGauge_m, ahead[i] * kLength_m);
    EXPECT_NEAR(TurnInPlace(rig).centre_m, centres[i] * kLength_m, 0.003) << ahead[i];
  }
}

/// Four short belts at the corners, as wheels.
BeltRig FourCorners(double apart_m, double gauge_m) {
  BeltRig rig;
  for (const double x : {-0.5 * apart_m, 0.5 * apart_m}) {
    for (const double y : {0.5 * gauge_m, -0.5 * gauge_m}) {
      rig.belts.push_back({{}, RigBeltModel(x - 0.01, x + 0.01, 0.03, y, 0.0155), 0.0});
      rig.belts.back().model.stiffness_pa_per_m *= 10.0;
      rig.belts.back().model.damping_pa_s_per_m *= 10.0;
      rig.belts.back().model.shear_stiffness_pa_per_m *= 10.0;
      rig.belts.back().model.shear_damping_pa_s_per_m *= 10.0;
    }
  }
  rig.X_GR.p.z() = 0.03;
  rig.PutOn(kHardFloor);
  return rig;
}

// Effective gauges that skid-steered wheeled robots are configured with, by their makers: Clearpath
// Husky 1.875 x 0.555 m, Jackal 1.5 x 0.3756 m.
TEST(TurningInPlace, OnFourCornersHasTheGaugeOfWheeledRobots) {
  struct Robot {
    double apart_m, gauge_m, published_m;
  };
  for (const Robot& robot : {Robot{0.512, 0.5708, 1.041}, Robot{0.262, 0.3756, 0.563}}) {
    BeltRig rig = FourCorners(robot.apart_m, robot.gauge_m);
    const double gauge = TurnInPlace(rig).gauge_m, ratio = robot.apart_m / robot.gauge_m;
    EXPECT_NEAR(gauge, robot.gauge_m * (1.0 + ratio * ratio), 0.01 * gauge);
    EXPECT_NEAR(gauge, robot.published_m, 0.02 * gauge);
  }
}

struct Arm {
  double down_deg, gauge_m, centre_m;
};
// Linear pressure under a rigid body on straight runs. The rollers bear a little beyond them, so
// that the elastic belts turn as if they were longer; with stiffer ones that goes (0.474 m at -30
// deg with 16 times the stiffness).
constexpr Arm kArms[] = {{-30.0, 0.472, 0.015}, {0.0, 0.577, -0.010}, {20.0, 1.13, -0.019}};

TEST(TurningInPlace, FollowsTheArm) {
  for (const Arm& arm : kArms) {
    BeltRig rig = ArmedRobot(Radians(arm.down_deg));
    const Turning turn = TurnInPlace(rig);
    EXPECT_NEAR(turn.gauge_m, arm.gauge_m, 0.03 * arm.gauge_m) << arm.down_deg;
    EXPECT_NEAR(turn.centre_m, arm.centre_m, 0.005) << arm.down_deg;
    EXPECT_LT(turn.ripple, 3e-3) << arm.down_deg;
  }
}

TEST(TurningInPlace, RestsAsTheArmsLeversSay) {
  BeltRig rig = ArmedRobot(Radians(20.0));
  rig.Run(1.0);
  const double rear = rig.belts[0].load.normal_n + rig.belts[2].load.normal_n;
  EXPECT_NEAR(rear / rig.Weight(), 0.57, 0.005);
  // Nose up by b: Lw sin b = la sin(theta - b), 6.3 deg.
  EXPECT_NEAR(Degrees(std::asin(rig.X_GR.R(2, 0))), 6.3, 0.1);
}

TEST(TurningInPlace, AgreesBetweenSteps) {
  for (const Arm& arm : kArms) {
    BeltRig coarse = ArmedRobot(Radians(arm.down_deg)), fine = coarse, finest = coarse;
    const Turning two = TurnInPlace(coarse, 0.1, 2e-3), one = TurnInPlace(fine, 0.1, 1e-3),
                  half = TurnInPlace(finest, 0.1, 5e-4);
    EXPECT_NEAR(two.gauge_m, one.gauge_m, 1e-3 * one.gauge_m) << arm.down_deg;
    EXPECT_NEAR(half.gauge_m, one.gauge_m, 1e-3 * one.gauge_m) << arm.down_deg;
    EXPECT_NEAR(two.centre_m, one.centre_m, 5e-4) << arm.down_deg;
    EXPECT_NEAR(half.centre_m, one.centre_m, 5e-4) << arm.down_deg;
  }
}

}  // namespace
}  // namespace dockyard
