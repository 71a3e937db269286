// Errors of a motor's current readings that a run draws.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "sim/drives/sensor_suite.h"

namespace dockyard {
namespace {

constexpr int kRuns = 4000;

MotorModel Reading(double offset_sigma_a, double scale_share) {
  MotorModel motor;
  motor.counts_per_rev = 1000;
  motor.current_offset_sigma_a = offset_sigma_a;
  motor.current_scale_share = scale_share;
  return motor;
}

double Read(SensorSuite& sensors, std::size_t motor, double drawn_a) {
  return sensors.Read(0, {{.current_a = drawn_a}, {.current_a = drawn_a}}, ImuSample{})
      .motors[motor]
      .current_a;
}

struct OverRuns {
  double mean = 0.0, sigma = 0.0;
};
template <class Draw>
OverRuns SpreadOf(const Draw& draw) {
  double sum = 0.0, square = 0.0;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    const double x = draw(seed);
    sum += x / kRuns;
    square += x * x / kRuns;
  }
  return {sum, std::sqrt(square - sum * sum)};
}

// A standard deviation of n draws errs by 1 / sqrt(2 n): 1.1 %; bounds are four of these.
TEST(CurrentError, OffsetAndScaleSpreadOverTheRunsByTheirSigma) {
  const MotorModel motor = Reading(0.05, 0.02);
  const auto parts = [&](std::uint64_t seed) {
    SensorSuite sensors(ImuModel{}, {motor, motor}, 20, seed);
    const double one = Read(sensors, 0, 1.0), three = Read(sensors, 0, 3.0);
    return std::pair(0.5 * (three - one), 1.5 * one - 0.5 * three);  // scale, offset
  };
  const OverRuns scale = SpreadOf([&](std::uint64_t seed) { return parts(seed).first; });
  const OverRuns offset = SpreadOf([&](std::uint64_t seed) { return parts(seed).second; });
  EXPECT_NEAR(scale.mean, 1.0, 4.0 * 0.02 / std::sqrt(kRuns));
  EXPECT_NEAR(scale.sigma, 0.02, 0.045 * 0.02);
  EXPECT_NEAR(offset.mean, 0.0, 4.0 * 0.05 / std::sqrt(kRuns));
  EXPECT_NEAR(offset.sigma, 0.05, 0.045 * 0.05);
}

TEST(CurrentError, IsTheSameForAllReadingsOfARunAndAnotherForEachMotor) {
  const MotorModel motor = Reading(0.05, 0.02);
  SensorSuite sensors(ImuModel{}, {motor, motor}, 20, 7);
  const double first = Read(sensors, 0, 2.0);
  EXPECT_EQ(Read(sensors, 0, 2.0), first);
  EXPECT_NE(Read(sensors, 1, 2.0), first);
}

TEST(CurrentError, ComesOnTopOfTheOffsetThatTheFileStates) {
  MotorModel motor = Reading(0.05, 0.0);
  SensorSuite drawn(ImuModel{}, {motor, motor}, 20, 7);
  motor.current_offset_a = 0.3;
  SensorSuite both(ImuModel{}, {motor, motor}, 20, 7);
  EXPECT_NEAR(Read(both, 0, 2.0) - Read(drawn, 0, 2.0), 0.3, 1e-12);
}

TEST(CurrentError, IsNoneUnlessAskedFor) {
  const MotorModel motor = Reading(0.0, 0.0);
  SensorSuite sensors(ImuModel{}, {motor, motor}, 20, 7);
  EXPECT_EQ(Read(sensors, 0, 1.2345), 1.2345);
}

}  // namespace
}  // namespace dockyard
