#include "sim/drives/attitude_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kReading_s = 0.005, kGravity_m_s2 = 9.81;

/// Tilted about x; level ground is up.
Attitude Tilted(double rad) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(rad, Vector3d::UnitX()))};
}

/// A level body at rest, as its gyros read it, for so long.
Attitude Rest(const AttitudeUnit& unit, Attitude attitude, const Vector3d& read_rad_s,
              double seconds) {
  for (long i = 0; i < std::lround(seconds / kReading_s); ++i) {
    TakeIn(unit, read_rad_s, {0.0, 0.0, kGravity_m_s2}, kReading_s, attitude);
  }
  return attitude;
}

double Tilt(const Attitude& attitude) {
  return ToRollPitchYaw(attitude.q_WR.toRotationMatrix()).roll;
}
double Yaw(const Attitude& attitude) {
  return ToRollPitchYaw(attitude.q_WR.toRotationMatrix()).yaw;
}

TEST(AttitudeFilter, LevelsItselfByTheForceAtRest) {
  const RollPitchYaw leaning{0.3, -0.2, 0.0};
  const Vector3d force_R = ToRotation(leaning).transpose() * Vector3d(0.0, 0.0, kGravity_m_s2);
  const RollPitchYaw found = ToRollPitchYaw(LevelledBy(force_R).q_WR.toRotationMatrix());
  EXPECT_NEAR(found.roll, leaning.roll, 1e-12);
  EXPECT_NEAR(found.pitch, leaning.pitch, 1e-12);
  EXPECT_NEAR(found.yaw, 0.0, 1e-12);
}

TEST(AttitudeFilter, AConstantRateAboutTheVerticalIntegratesToItsAngle) {
  for (const AttitudeFilter filter : {AttitudeFilter::kMahony, AttitudeFilter::kMadgwick}) {
    const AttitudeUnit unit{.filter = filter};
    EXPECT_NEAR(Yaw(Rest(unit, {}, {0.0, 0.0, 0.25}, 10.0)), 2.5, 1e-9);
  }
}

TEST(AttitudeFilter, ATurnAboutALevelAxisIsFollowedThroughTheVertical) {
  const double rate = 0.5;
  for (const AttitudeFilter filter : {AttitudeFilter::kMahony, AttitudeFilter::kMadgwick}) {
    const AttitudeUnit unit{.filter = filter};
    Attitude attitude;
    for (int i = 1; i <= 800; ++i) {  // 2 rad
      const Vector3d up_R = RotX(rate * kReading_s * i).transpose() * Vector3d::UnitZ();
      TakeIn(unit, {rate, 0.0, 0.0}, kGravity_m_s2 * up_R, kReading_s, attitude);
    }
    EXPECT_NEAR(Tilt(attitude), 2.0, 2e-3);
  }
}

// The tilt t of a filter without integral: t' = -k sin t, so that tan(t / 2) falls by exp(-k time).
TEST(AttitudeFilter, MahonysTiltErrorFallsByTheGainsTimeConstant) {
  for (const double kp_per_s : {0.5, 1.0, 2.0}) {
    const AttitudeUnit unit{.kp_per_s = kp_per_s, .ki_per_s2 = 0.0};
    for (const double seconds : {0.5, 1.0, 2.0}) {
      const double half = std::tan(0.5) * std::exp(-kp_per_s * seconds);
      EXPECT_NEAR(Tilt(Rest(unit, Tilted(1.0), {0, 0, 0}, seconds)), 2.0 * std::atan(half), 3e-3);
    }
  }
}

// Its correction has length beta in the quaternion, and an angle is twice that.
TEST(AttitudeFilter, MadgwicksTiltErrorFallsAtTwiceBeta) {
  const AttitudeUnit unit{.filter = AttitudeFilter::kMadgwick, .beta_per_s = 0.05};
  const double start = Radians(5.0);
  EXPECT_NEAR(start - Tilt(Rest(unit, Tilted(start), {0, 0, 0}, 0.5)), 2.0 * 0.05 * 0.5, 3e-4);
  EXPECT_LT(std::abs(Tilt(Rest(unit, Tilted(start), {0, 0, 0}, 3.0))), 2.0 * 0.05 * kReading_s);
}

TEST(AttitudeFilter, ABiasTiltsMahonysFilterUntilItsIntegralHasLearnedIt) {
  const Vector3d bias(0.02, 0.0, 0.0);
  const AttitudeUnit stiff{.kp_per_s = 0.5, .ki_per_s2 = 0.0};
  EXPECT_NEAR(std::sin(Tilt(Rest(stiff, {}, bias, 40.0))), 0.02 / 0.5, 2e-4);
  const Attitude learned = Rest(AttitudeUnit{}, {}, bias, 60.0);
  EXPECT_NEAR(Tilt(learned), 0.0, 1e-4);
  EXPECT_NEAR(learned.bias_R.x(), 0.02, 1e-4);
}

TEST(AttitudeFilter, ABiasAboutTheVerticalIsDriftThatGravityDoesNotHold) {
  for (const AttitudeFilter filter : {AttitudeFilter::kMahony, AttitudeFilter::kMadgwick}) {
    const AttitudeUnit unit{.filter = filter};
    for (const double seconds : {20.0, 40.0}) {
      EXPECT_NEAR(Yaw(Rest(unit, {}, {0.0, 0.0, 1e-3}, seconds)), 1e-3 * seconds, 1e-9);
    }
  }
}

TEST(AttitudeFilter, AFallWithoutForceLeavesTheGyrosAlone) {
  for (const AttitudeFilter filter : {AttitudeFilter::kMahony, AttitudeFilter::kMadgwick}) {
    const AttitudeUnit unit{.filter = filter};
    Attitude attitude;
    for (int i = 0; i < 100; ++i) TakeIn(unit, {0.4, 0, 0}, {0, 0, 0}, kReading_s, attitude);
    EXPECT_NEAR(Tilt(attitude), 0.2, 1e-12);
  }
}

}  // namespace
}  // namespace dockyard
