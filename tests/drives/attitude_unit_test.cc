// An inertial unit with a filter of its own: its readings, and its keys in a file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "models/read/read_imu.h"
#include "sim/drives/sensor_suite.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

constexpr Tick kPeriod = 20;

ImuModel UnitWith(const std::function<void(ImuModel&)>& change) {
  ImuModel imu;
  imu.unit.emplace();
  change(imu);
  return imu;
}

TrueImu At(const Vector3d& rate_R, const Vector3d& force_R) {
  ImuSample sample;
  sample.rate_R = rate_R;
  sample.specific_force_R = force_R;
  return {sample, {2, InertialMean{0.01, rate_R, force_R}}};
}

/// The reading at the end of some control periods of the same motion.
ImuSample After(const ImuModel& imu, std::uint64_t seed, const TrueImu& truth, int periods = 1) {
  SensorSuite sensors(imu, {}, kPeriod, seed);
  sensors.Read(0, {}, At({0, 0, 0}, {0, 0, 9.81}));
  ImuSample read;
  for (int i = 1; i <= periods; ++i) read = sensors.Read(i * kPeriod, {}, truth).imu;
  return read;
}

TEST(AttitudeUnit, WithoutErrorsReadsWhatIsTrue) {
  const ImuSample read = After(UnitWith([](ImuModel&) {}), 1, At({0, 0, 0.3}, {0, 0, 9.81}), 50);
  EXPECT_NEAR(read.rate_R.z(), 0.3, 1e-12);
  EXPECT_NEAR(read.specific_force_R.z(), 9.81, 1e-12);
  EXPECT_NEAR(read.yaw_rad, 0.3, 1e-9);  // after 1 s
  EXPECT_NEAR(read.roll_rad, 0.0, 1e-9);
}

TEST(AttitudeUnit, CutsReadingsOffAtTheirRange) {
  const ImuModel imu = UnitWith([](ImuModel& imu) {
    imu.unit->gyro.range = 0.5;
    imu.unit->accelerometer.range = 20.0;
  });
  const ImuSample read = After(imu, 1, At({0.2, -3.0, 3.0}, {0.0, 5.0, 2.0 * 20.0}), 1);
  EXPECT_TRUE(read.rate_R.isApprox(Vector3d(0.2, -0.5, 0.5), 1e-12));
  EXPECT_TRUE(read.specific_force_R.isApprox(Vector3d(0.0, 5.0, 20.0), 1e-12));
  // So a turn beyond the range is lost from yaw.
  EXPECT_NEAR(After(imu, 1, At({0, 0, 3.0}, {0, 0, 9.81}), 50).yaw_rad, 0.5, 1e-9);
}

TEST(AttitudeUnit, ReadsWholeStepsToTheNearest) {
  const ImuModel imu = UnitWith([](ImuModel& imu) {
    imu.unit->gyro.step = 0.01;
    imu.unit->accelerometer.step = 0.5;
  });
  const ImuSample read = After(imu, 1, At({0.004, 0.006, -0.026}, {0.2, 0.3, 9.81}));
  EXPECT_TRUE(read.rate_R.isApprox(Vector3d(0.0, 0.01, -0.03), 1e-12)) << read.rate_R;
  EXPECT_TRUE(read.specific_force_R.isApprox(Vector3d(0.0, 0.5, 10.0), 1e-12));
}

struct Spread {
  double mean = 0.0, sigma = 0.0;
};
Spread OverSeeds(const std::function<double(std::uint64_t)>& read) {
  double sum = 0.0, square = 0.0;
  constexpr int kSeeds = 2000;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const double x = read(seed);
    sum += x / kSeeds;
    square += x * x / kSeeds;
  }
  return {sum, std::sqrt(square - sum * sum)};
}

TEST(AttitudeUnit, MisalignmentTurnsAnAxisTowardsTheOthersAndScaleAlongItself) {
  const ImuModel imu = UnitWith([](ImuModel& imu) {
    imu.unit->gyro = {.scale_share = 0.01, .misalignment_rad = 0.003};
    imu.unit->accelerometer = {.scale_share = 0.02, .misalignment_rad = 0.005};
  });
  const TrueImu turning = At({0, 0, 2.0}, {0, 0, 9.81});
  const auto rate = [&](int axis) {
    return OverSeeds([&](std::uint64_t seed) { return After(imu, seed, turning).rate_R[axis]; });
  };
  const auto force = [&](int axis) {
    return OverSeeds(
        [&](std::uint64_t seed) { return After(imu, seed, turning).specific_force_R[axis]; });
  };
  EXPECT_NEAR(rate(0).sigma, 2.0 * 0.003, 0.06 * 2.0 * 0.003);
  EXPECT_NEAR(rate(1).mean, 0.0, 4.0 * 2.0 * 0.003 / std::sqrt(2000.0));
  EXPECT_NEAR(rate(2).sigma, 2.0 * 0.01, 0.06 * 2.0 * 0.01);
  EXPECT_NEAR(force(1).sigma, 9.81 * 0.005, 0.06 * 9.81 * 0.005);
  EXPECT_NEAR(force(2).sigma, 9.81 * 0.02, 0.06 * 9.81 * 0.02);
}

TEST(AttitudeUnit, YawDriftsInProportionToTimeByTheGyrosBias) {
  const ImuModel imu = UnitWith([](ImuModel& imu) { imu.gyro_bias_rad_s = 1e-3; });
  const TrueImu rest = At({0, 0, 0}, {0, 0, 9.81});
  const double once = After(imu, 3, rest, 100).yaw_rad, twice = After(imu, 3, rest, 200).yaw_rad;
  EXPECT_GT(std::abs(once), 1e-5);
  EXPECT_NEAR(twice, 2.0 * once, 1e-2 * std::abs(once));
  const Spread yaw =
      OverSeeds([&](std::uint64_t seed) { return After(imu, seed, rest, 10).yaw_rad; });
  EXPECT_NEAR(yaw.sigma, 1e-3 * 0.2, 0.06 * 1e-3 * 0.2);
}

TEST(AttitudeUnit, AnAccelerometersBiasTiltsTheAttitude) {
  const ImuModel imu = UnitWith([](ImuModel& imu) { imu.accel_bias_m_s2 = 0.05; });
  const TrueImu rest = At({0, 0, 0}, {0, 0, 9.81});
  const Spread roll =
      OverSeeds([&](std::uint64_t seed) { return After(imu, seed, rest).roll_rad; });
  EXPECT_NEAR(roll.sigma, 0.05 / 9.81, 0.06 * 0.05 / 9.81);
}

TEST(AttitudeUnit, KeepsItsLastReadingUntilTheNext) {
  SensorSuite sensors(UnitWith([](ImuModel&) {}), {}, kPeriod, 1);
  const ImuSample first = sensors.Read(0, {}, At({0, 0, 0.1}, {0, 0, 9.81})).imu;
  const ImuSample next =
      sensors.Read(kPeriod, {}, TrueImu(At({0, 0, 0.7}, {0, 0, 9.81}).sample)).imu;
  EXPECT_EQ(next.rate_R, first.rate_R);
}

TEST(TrueImu, ReadingsShareTheTurnOfTheControlPeriodAmongThem) {
  const ImuModel imu = UnitWith([](ImuModel& imu) { imu.unit->period_s = 0.005; });
  ImuAverage average(imu, {0, 0, -9.81});
  LinkMotion body;
  average.Start(body);
  for (int i = 0; i < 20; ++i) {
    body.w_GL_G.z() = 0.01 * i;
    average.Add(body, 1e-3);
  }
  const TrueImu truth = average.Take(body, Pose3{});
  ASSERT_EQ(truth.readings.size(), 4u);
  double turn_rad = 0.0;
  for (const InertialMean& reading : truth.readings) {
    EXPECT_NEAR(reading.span_s, 0.005, 1e-12);
    turn_rad += reading.span_s * reading.rate_R.z();
  }
  EXPECT_NEAR(turn_rad, 0.02 * truth.sample.rate_R.z(), 1e-12);
  EXPECT_NEAR(truth.readings[0].rate_R.z(), 0.02, 1e-12);  // of 0, 0.01 .. 0.04
  EXPECT_TRUE(average.Take(body, Pose3{}).readings.empty());
}

constexpr const char* kPlain = R"(imu:
  position_m: [0, 0, 0]
  gyro_walk_deg_per_sqrt_h: 3
  gyro_bias_deg_per_h: 30
  gyro_instability_deg_per_h: 10
  accel_walk_m_s_per_sqrt_h: 0.1
  accel_bias_m_s2: 0.05
  accel_instability_m_s2: 0.001
  instability_time_s: 100
)";

ImuModel Load(const ScratchFolder& folder, const std::string& more) {
  const YamlNode root = LoadYaml(folder.Write("robot.yaml", kPlain + more));
  ImuModel imu;
  ReadKeys(root, "",
           [&](Keys& keys) { keys.Mapping("imu", [&](Keys& in) { VisitImu(in, imu); }); });
  return imu;
}

TEST(ImuFile, AFilterAndItsReadingsAreReadInDegreesAndHeldInRadians) {
  const ScratchFolder folder;
  const ImuModel imu = Load(folder,
                            "  filter: {kind: mahony, rate_hz: 50, kp_per_s: 2}\n"
                            "  gyro: {scale_share: 0.01, range_deg_s: 180, step_deg_s: 0.1}\n"
                            "  accelerometer: {misalignment_deg: 0.5, range_m_s2: 20}\n");
  ASSERT_TRUE(imu.unit);
  EXPECT_EQ(imu.unit->filter, AttitudeFilter::kMahony);
  EXPECT_DOUBLE_EQ(imu.unit->period_s, 0.02);
  EXPECT_EQ(imu.unit->kp_per_s, 2.0);
  EXPECT_EQ(imu.unit->ki_per_s2, AttitudeUnit{}.ki_per_s2);
  EXPECT_DOUBLE_EQ(imu.unit->gyro.range, kPi);
  EXPECT_DOUBLE_EQ(imu.unit->gyro.step, Radians(0.1));
  EXPECT_DOUBLE_EQ(imu.unit->accelerometer.misalignment_rad, Radians(0.5));
  EXPECT_EQ(imu.unit->accelerometer.step, 0.0);
  EXPECT_EQ(
      Load(folder, "  filter: {kind: madgwick, rate_hz: 100, beta_per_s: 0.1}\n").unit->beta_per_s,
      0.1);
  const std::string today = "  attitude_noise_deg: 0.1\n  attitude_bias_deg: 0.3\n";
  EXPECT_FALSE(Load(folder, today).unit);
}

TEST(ImuFile, WhatAFilterCannotUseIsRefused) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& more) {
    return MessageOf([&] { Load(folder, more); }, folder);
  };
  const std::string filter = "  filter: {kind: mahony, rate_hz: 100}\n";
  EXPECT_THAT(message(filter + "  attitude_noise_deg: 0.1\n"),
              HasSubstr("robot.yaml:11:23: imu.attitude_noise_deg: expected 0 with a filter"));
  EXPECT_THAT(message("  attitude_noise_deg: 0\n  attitude_bias_deg: 0\n  gyro: {step_deg_s: 1}\n"),
              HasSubstr("imu.gyro: expected a filter as well"));
  EXPECT_THAT(message("  filter: {kind: mahony, rate_hz: 400}\n"),
              HasSubstr("imu.filter.rate_hz: expected"));
  EXPECT_THAT(message("  filter: {kind: mahony, rate_hz: 100, beta_per_s: 1}\n"),
              HasSubstr("imu.filter.beta_per_s: expected kp_per_s and ki_per_s2"));
  EXPECT_THAT(message("  filter: {kind: madgwick, rate_hz: 100, kp_per_s: 1}\n"),
              HasSubstr("imu.filter.kp_per_s: expected beta_per_s"));
  EXPECT_THAT(message("  filter: {kind: kalman, rate_hz: 100}\n"), HasSubstr("imu.filter.kind"));
  EXPECT_THAT(message(filter + "  gyro: {range_m_s2: 3}\n"), HasSubstr("imu.gyro"));
  EXPECT_THAT(message(""), HasSubstr("attitude_noise_deg"));
}

}  // namespace
}  // namespace dockyard
