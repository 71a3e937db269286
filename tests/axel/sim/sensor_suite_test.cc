#include "sim/drives/sensor_suite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "axel/sim/product.h"
#include "sim/drives/imu.h"

namespace dockyard::axel {
namespace {

TEST(TrueImu, FeelsGravityAtRestAlongTheTiltedAxes) {
  ImuAverage imu({.p_RI = {0.1, 0, 0}}, {0.0, 0.0, -9.81});
  LinkMotion body;
  body.X_GL.R = ToRotation({0.1, 0.2, 0.3});
  imu.Start(body);
  for (int i = 0; i < 20; ++i) imu.Add(body, 1e-3);
  const ImuSample sample = imu.Take(body, FromGround({1, 2, 0.5}, 0.0)).sample;
  EXPECT_NEAR(sample.roll_rad, 0.1, 1e-12);
  EXPECT_NEAR(sample.pitch_rad, 0.2, 1e-12);
  EXPECT_NEAR(sample.yaw_rad, 0.8, 1e-12);
  EXPECT_NEAR(sample.specific_force_R.x(), -9.81 * std::sin(0.2), 1e-9);
  EXPECT_NEAR(sample.specific_force_R.y(), 9.81 * std::sin(0.1) * std::cos(0.2), 1e-9);
  EXPECT_NEAR(sample.specific_force_R.z(), 9.81 * std::cos(0.1) * std::cos(0.2), 1e-9);
  EXPECT_LT(sample.rate_R.norm(), 1e-12);
}

TEST(TrueImu, FeelsNothingFalling) {
  ImuAverage imu({.p_RI = {0.1, 0, 0}}, {0.0, 0.0, -9.81});
  LinkMotion body;
  imu.Start(body);
  for (int i = 0; i < 20; ++i) {
    body.v_GL_G.z() -= 9.81e-3;
    imu.Add(body, 1e-3);
  }
  EXPECT_LT(imu.Take(body, Pose3{}).sample.specific_force_R.norm(), 1e-12);
}

TEST(TrueImu, FeelsTheCentripetalPullOfItsOwnPlace) {
  ImuAverage imu({.p_RI = {0.1, 0, 0}}, {0.0, 0.0, -9.81});
  LinkMotion body;
  body.w_GL_G = Eigen::Vector3d(0, 0, 2.0);
  imu.Start(body);
  for (int i = 0; i < 20; ++i) {
    body.X_GL.R = body.X_GL.R * RotZ(2e-3);
    imu.Add(body, 1e-3);
  }
  const ImuSample sample = imu.Take(body, Pose3{}).sample;
  EXPECT_NEAR(sample.specific_force_R.x(), -0.1 * 4.0, 1e-3);
  EXPECT_NEAR(sample.rate_R.z(), 2.0, 1e-12);
}

struct Statistics {
  double mean = 0.0, sigma = 0.0;
};

template <class Draw>
Statistics Sample(int count, Draw draw) {
  double sum = 0.0, square = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = draw();
    sum += x;
    square += x * x;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(square / count - mean * mean)};
}

const std::vector<MotorTruth> kStill(kMotorCount);

SensorSuite Sensors(const RoverModel& rover, std::uint64_t seed) {
  return {rover.imu, {rover.motors.begin(), rover.motors.end()}, kControlPeriod, seed};
}

TEST(SensorSuite, NoiseHasTheModelsSpread) {
  const RoverModel rover = Axel();
  SensorSuite sensors = Sensors(rover, 5);
  Tick tick = 0;
  std::vector<MotorTruth> motors = kStill;
  motors[0].current_a = 1.0;
  SensorFrame frame;
  const Statistics pitch = Sample(20000, [&] {
    frame = sensors.Read(tick += 20, motors, ImuSample{});
    return frame.imu.pitch_rad;
  });
  EXPECT_NEAR(pitch.sigma, rover.imu.attitude_noise_rad, 0.03 * rover.imu.attitude_noise_rad);
  const Statistics current = Sample(
      20000, [&] { return sensors.Read(tick += 20, motors, ImuSample{}).motors[0].current_a; });
  EXPECT_NEAR(current.mean, 1.0, 1e-3);
  EXPECT_NEAR(current.sigma, 0.02, 0.03 * 0.02);
}

TEST(SensorSuite, BiasesDifferFromPowerOnToPowerOnByTheModelsSpread) {
  const RoverModel rover = Axel();
  std::uint64_t seed = 100;
  const Statistics pitch = Sample(
      4000, [&] { return Sensors(rover, seed++).Read(0, kStill, ImuSample{}).imu.pitch_rad; });
  const double sigma = std::hypot(rover.imu.attitude_bias_rad, rover.imu.attitude_noise_rad);
  EXPECT_NEAR(pitch.sigma, sigma, 0.05 * sigma);
  EXPECT_NEAR(pitch.mean, 0.0, 0.1 * sigma);
}

TEST(SensorSuite, YawStartsAtZeroWhateverTheTrueHeading) {
  SensorSuite sensors = Sensors(Axel(), 5);
  ImuSample truth;
  truth.yaw_rad = 2.7;
  EXPECT_EQ(sensors.Read(0, kStill, truth).imu.yaw_rad, 0.0);
}

TEST(SensorSuite, YawDriftsAsItsGyroErrs) {
  const RoverModel rover = Axel();
  const double seconds = 100.0;
  std::uint64_t seed = 1;
  const Statistics yaw = Sample(1000, [&] {
    SensorSuite sensors = Sensors(rover, seed++);
    SensorFrame frame;
    for (Tick tick = 0; tick <= 100000; tick += 1000) {
      frame = sensors.Read(tick, kStill, ImuSample{});
    }
    return frame.imu.yaw_rad;
  });
  // Bias t, walk sqrt(t), and the wandering's integral: its variance for a Gauss-Markov process is
  // 2 s^2 tau^2 (t / tau - 1 + exp(-t / tau)).
  const ImuModel& imu = rover.imu;
  const double tau = imu.instability_time_s, x = seconds / tau;
  const double wandering =
      imu.gyro_instability_rad_s * tau * std::sqrt(2.0 * (x - 1.0 + std::exp(-x)));
  const double sigma = std::hypot(imu.gyro_bias_rad_s * seconds,
                                  imu.gyro_walk_rad_sqrt_s * std::sqrt(seconds), wandering);
  EXPECT_NEAR(yaw.sigma, sigma, 0.07 * sigma);  // 3 sigma of the spread of 1000
  EXPECT_NEAR(yaw.mean, 0.0, 0.1 * sigma);
}

/// Allan deviation over neighbouring averages.
double Allan(const std::vector<double>& averages) {
  double sum = 0.0;
  for (std::size_t i = 1; i < averages.size(); ++i) {
    sum += 0.5 * (averages[i] - averages[i - 1]) * (averages[i] - averages[i - 1]);
  }
  return std::sqrt(sum / static_cast<double>(averages.size() - 1));
}

/// Averages over tau of one axis' rate and specific force, read in every control period.
struct Averages {
  std::vector<double> rate, force;
};
Averages Average(const RoverModel& rover, int count, double tau_s) {
  SensorSuite sensors = Sensors(rover, 77);
  const int readings = static_cast<int>(std::lround(tau_s / (kControlPeriod * kTickSeconds)));
  Averages averages;
  Tick tick = 0;
  for (int i = 0; i < count; ++i) {
    double rate = 0.0, force = 0.0;
    for (int j = 0; j < readings; ++j) {
      const SensorFrame frame = sensors.Read(tick += kControlPeriod, kStill, ImuSample{});
      rate += frame.imu.rate_R.x() / readings;
      force += frame.imu.specific_force_R.y() / readings;
    }
    averages.rate.push_back(rate);
    averages.force.push_back(force);
  }
  return averages;
}

TEST(SensorSuite, AllanDeviationAtOneSecondIsTheRandomWalk) {
  const RoverModel rover = Axel();
  const Averages averages = Average(rover, 4000, 1.0);
  const double walk = rover.imu.gyro_walk_rad_sqrt_s, push = rover.imu.accel_walk_m_s_sqrt_s;
  EXPECT_NEAR(Allan(averages.rate), walk, 0.04 * walk);
  EXPECT_NEAR(Allan(averages.force), push, 0.04 * push);
}

TEST(SensorSuite, AllanDeviationFallsWithTheRootOfTheAveragingTime) {
  RoverModel rover = Axel();
  rover.imu.gyro_instability_rad_s = 0.0;
  const double walk = rover.imu.gyro_walk_rad_sqrt_s;
  EXPECT_NEAR(Allan(Average(rover, 2000, 0.1).rate), walk / std::sqrt(0.1),
              0.06 * walk / std::sqrt(0.1));
  EXPECT_NEAR(Allan(Average(rover, 1000, 4.0).rate), walk / 2.0, 0.08 * walk / 2.0);
}

TEST(SensorSuite, BiasWandersByItsInstabilityOverItsTime) {
  RoverModel rover = Axel();
  rover.imu.gyro_walk_rad_sqrt_s = rover.imu.gyro_bias_rad_s = 0.0;
  std::uint64_t seed = 300;
  double product = 0.0;
  const Statistics later = Sample(4000, [&] {
    SensorSuite sensors = Sensors(rover, seed++);
    const double now = sensors.Read(0, kStill, ImuSample{}).imu.rate_R.z();
    const double then = sensors.Read(100000, kStill, ImuSample{}).imu.rate_R.z();
    product += now * then / 4000.0;
    return then;
  });
  const double s = rover.imu.gyro_instability_rad_s;
  EXPECT_NEAR(later.sigma, s, 0.05 * s);
  EXPECT_NEAR(product, s * s * std::exp(-1.0), 0.06 * s * s);  // one correlation time
}

TEST(SensorSuite, RateAndForceBiasesSpreadAsTheModelSays) {
  const RoverModel rover = Axel();
  std::uint64_t seed = 900;
  ImuSample read;
  const Statistics rate = Sample(4000, [&] {
    read = Sensors(rover, seed++).Read(0, kStill, ImuSample{}).imu;
    return read.rate_R.y();
  });
  const Statistics force = Sample(4000, [&] {
    read = Sensors(rover, seed++).Read(0, kStill, ImuSample{}).imu;
    return read.specific_force_R.x();
  });
  const ImuModel& imu = rover.imu;
  const double root_s = std::sqrt(kControlPeriod * kTickSeconds);
  const double rates = std::hypot(imu.gyro_bias_rad_s, imu.gyro_walk_rad_sqrt_s / root_s,
                                  imu.gyro_instability_rad_s);
  const double forces = std::hypot(imu.accel_bias_m_s2, imu.accel_walk_m_s_sqrt_s / root_s,
                                   imu.accel_instability_m_s2);
  EXPECT_NEAR(rate.sigma, rates, 0.05 * rates);
  EXPECT_NEAR(force.sigma, forces, 0.05 * forces);
}

TEST(SensorSuite, EncodersCountWholeSteps) {
  SensorSuite sensors = Sensors(Axel(), 5);
  const double step = 2.0 * kPi / 204800.0, spool_step = 2.0 * kPi / 122880.0;
  const std::vector<MotorTruth> motors{
      {.angle_rad = 100.4 * step}, {.angle_rad = -7.4 * step}, {}, {.angle_rad = 2.6 * spool_step}};
  const SensorFrame frame = sensors.Read(0, motors, ImuSample{});
  std::vector<std::int64_t> counts;
  for (const MotorReading& motor : frame.motors) counts.push_back(motor.encoder_counts);
  EXPECT_EQ(counts, (std::vector<std::int64_t>{100, -7, 0, 3}));
}

TEST(SensorSuite, EncodersErrEvenlyWithinHalfACount) {
  SensorSuite sensors = Sensors(Axel(), 5);
  const double step = 2.0 * kPi / 204800.0;
  std::vector<MotorTruth> motors = kStill;
  RandomStream angle(3);
  double worst = 0.0;
  int inner = 0;
  const Statistics error = Sample(20000, [&] {
    motors[0].angle_rad = angle.Uniform(-10.0, 10.0);
    const auto counts = sensors.Read(0, motors, ImuSample{}).motors[0].encoder_counts;
    const double e = static_cast<double>(counts) * step - motors[0].angle_rad;
    worst = std::max(worst, std::abs(e));
    inner += std::abs(e) < 0.25 * step ? 1 : 0;
    return e;
  });
  EXPECT_NEAR(error.sigma, step / std::sqrt(12.0), 0.02 * step / std::sqrt(12.0));
  EXPECT_NEAR(error.mean, 0.0, 0.01 * step);
  EXPECT_LE(worst, 0.5 * step * (1.0 + 1e-9));
  EXPECT_NEAR(inner / 20000.0, 0.5, 0.015);
}

TEST(SensorSuite, SameSeedReadsTheSame) {
  SensorSuite a = Sensors(Axel(), 9), b = Sensors(Axel(), 9);
  EXPECT_EQ(a.Read(20, kStill, ImuSample{}).imu.pitch_rad,
            b.Read(20, kStill, ImuSample{}).imu.pitch_rad);
}

}  // namespace
}  // namespace dockyard::axel
