// Readings of an inertial unit whose clock is behind the controller's.
#include "sim/drives/imu_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/drives/sensor_suite.h"

namespace dockyard {
namespace {

constexpr double kFrame_s = 0.02;

ImuModel Behind(double offset_s, double drift_ppm = 0.0) {
  ImuModel imu;
  imu.clock_offset_s = offset_s;
  imu.clock_drift_ppm = drift_ppm;
  return imu;
}

/// A body that turns about the vertical at a constant rate; its push grows with time.
constexpr double kYaw_rad_s = 0.4, kPush_m_s3 = 2.0;
TrueImu Turning(double time_s) {
  ImuSample sample;
  sample.yaw_rad = kYaw_rad_s * time_s;
  sample.rate_R.z() = kYaw_rad_s;
  sample.specific_force_R.x() = kPush_m_s3 * time_s;
  return sample;
}

TEST(ImuClock, GivesWhatWasTrueOneOffsetAgo) {
  for (const double offset_s : {0.003, 0.02, 0.031, 0.2}) {
    ImuClock clock(Behind(offset_s));
    for (int i = 0; i < 60; ++i) {
      const double now_s = i * kFrame_s, then_s = std::max(0.0, now_s - offset_s);
      const ImuSample read = clock.Pass(Turning(now_s), now_s).sample;
      EXPECT_NEAR(read.yaw_rad, kYaw_rad_s * then_s, 1e-9) << offset_s << " " << now_s;
      EXPECT_NEAR(read.specific_force_R.x(), kPush_m_s3 * then_s, 1e-9);
    }
  }
}

TEST(ImuClock, DriftsByItsShareOfTheTimeAndIsNeverAhead) {
  const ImuClock losing(Behind(0.01, 50.0)), gaining(Behind(0.01, -50.0));
  EXPECT_NEAR(losing.age_s(300.0), 0.025, 1e-12);
  EXPECT_NEAR(gaining.age_s(100.0), 0.005, 1e-12);
  EXPECT_EQ(gaining.age_s(300.0), 0.0);
  ImuClock clock(Behind(0.0, 1000.0));
  double read_rad = 0.0;
  for (int i = 0; i <= 500; ++i) {
    read_rad = clock.Pass(Turning(i * kFrame_s), i * kFrame_s).sample.yaw_rad;
  }
  EXPECT_NEAR(WrapPi(read_rad - kYaw_rad_s * (10.0 - 0.01)), 0.0, 1e-9);
}

TEST(ImuClock, TurnsThroughTheShortSideBetweenTwoFrames) {
  ImuClock clock(Behind(0.01));
  ImuSample before, after;
  before.yaw_rad = kPi - 0.01;
  after.yaw_rad = -kPi + 0.03;
  clock.Pass(before, 0.0);
  EXPECT_NEAR(WrapPi(clock.Pass(after, kFrame_s).sample.yaw_rad - kPi), 0.01, 1e-9);
}

TEST(ImuClock, HoldsAUnitsOwnReadingsBackUntilTheyAreOldEnough) {
  ImuClock clock(Behind(0.012));
  std::vector<double> given;  // each reading's number
  for (int frame = 0; frame < 50; ++frame) {
    TrueImu now = Turning(frame * kFrame_s);
    for (int i = 0; frame > 0 && i < 4; ++i) {
      now.readings.push_back({0.005, {4.0 * (frame - 1) + i, 0, 0}, {0, 0, 9.81}});
    }
    const double now_s = frame * kFrame_s;
    for (const InertialMean& reading : clock.Pass(now, now_s).readings) {
      given.push_back(reading.rate_R.x());
      EXPECT_LE(0.005 * (reading.rate_R.x() + 1.0), now_s - 0.012 + 1e-9);
    }
    // The next one is too young.
    EXPECT_GT(0.005 * static_cast<double>(given.size() + 1), now_s - 0.012);
  }
  for (std::size_t i = 0; i < given.size(); ++i) EXPECT_EQ(given[i], static_cast<double>(i));
}

TEST(ImuClock, ChangesNothingWithoutAnError) {
  ImuClock clock(Behind(0.0));
  TrueImu now = Turning(1.0);
  now.readings.assign(3, InertialMean{0.005, {1, 2, 3}, {4, 5, 6}});
  const TrueImu read = clock.Pass(now, 1.0);
  EXPECT_EQ(read.sample.yaw_rad, now.sample.yaw_rad);
  EXPECT_EQ(read.readings.size(), 3u);
}

TEST(ImuClock, IsInTheReadingsOfTheSensors) {
  SensorSuite sensors(Behind(0.02), {}, 20, 1);
  ImuSample read;
  for (int i = 0; i <= 50; ++i) read = sensors.Read(20 * i, {}, Turning(i * kFrame_s)).imu;
  EXPECT_NEAR(read.yaw_rad, kYaw_rad_s * 0.98, 1e-9);
}

}  // namespace
}  // namespace dockyard
