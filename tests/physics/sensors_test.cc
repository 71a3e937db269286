#include "sim/physics/sensors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/axel_numbers.h"
#include "sim/physics/imu.h"

namespace dockyard {
namespace {

TEST(TrueImu, FeelsGravityAtRestAlongTheTiltedAxes) {
  ImuAverage imu(Eigen::Vector3d(0.1, 0, 0), 9.81);
  LinkMotion body;
  body.X_GL.R = ToRotation({0.1, 0.2, 0.3});
  imu.Start(body);
  for (int i = 0; i < 20; ++i) imu.Add(body, 1e-3);
  const ImuSample sample = imu.Take(body, FromGround({1, 2, 0.5}, 0.0));
  EXPECT_NEAR(sample.roll_rad, 0.1, 1e-12);
  EXPECT_NEAR(sample.pitch_rad, 0.2, 1e-12);
  EXPECT_NEAR(sample.yaw_rad, 0.8, 1e-12);
  EXPECT_NEAR(sample.specific_force_R.x(), -9.81 * std::sin(0.2), 1e-9);
  EXPECT_NEAR(sample.specific_force_R.y(), 9.81 * std::sin(0.1) * std::cos(0.2), 1e-9);
  EXPECT_NEAR(sample.specific_force_R.z(), 9.81 * std::cos(0.1) * std::cos(0.2), 1e-9);
  EXPECT_LT(sample.rate_R.norm(), 1e-12);
}

TEST(TrueImu, FeelsNothingFalling) {
  ImuAverage imu(Eigen::Vector3d(0.1, 0, 0), 9.81);
  LinkMotion body;
  imu.Start(body);
  for (int i = 0; i < 20; ++i) {
    body.v_GL_G.z() -= 9.81e-3;
    imu.Add(body, 1e-3);
  }
  EXPECT_LT(imu.Take(body, Pose3{}).specific_force_R.norm(), 1e-12);
}

TEST(TrueImu, FeelsTheCentripetalPullOfItsOwnPlace) {
  ImuAverage imu(Eigen::Vector3d(0.1, 0, 0), 9.81);
  LinkMotion body;
  body.w_GL_G = Eigen::Vector3d(0, 0, 2.0);
  imu.Start(body);
  for (int i = 0; i < 20; ++i) {
    body.X_GL.R = body.X_GL.R * RotZ(2e-3);
    imu.Add(body, 1e-3);
  }
  const ImuSample sample = imu.Take(body, Pose3{});
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

TEST(SensorSuite, NoiseHasTheModelsSpread) {
  const RoverModel rover = TestRover();
  SensorSuite sensors(rover, 5);
  Tick tick = 0;
  Truth truth;
  truth.motor_current_a[0] = 1.0;
  SensorFrame frame;
  const Statistics pitch = Sample(20000, [&] {
    frame = sensors.Read(tick += 20, truth, ImuSample{});
    return frame.imu.pitch_rad;
  });
  EXPECT_NEAR(pitch.sigma, rover.imu.attitude_noise_rad, 0.03 * rover.imu.attitude_noise_rad);
  const Statistics current =
      Sample(20000, [&] { return sensors.Read(tick += 20, truth, ImuSample{}).current_a[0]; });
  EXPECT_NEAR(current.mean, 1.0, 1e-3);
  EXPECT_NEAR(current.sigma, 0.02, 0.03 * 0.02);
}

TEST(SensorSuite, BiasesDifferFromPowerOnToPowerOnByTheModelsSpread) {
  const RoverModel rover = TestRover();
  std::uint64_t seed = 100;
  const Statistics pitch = Sample(
      4000, [&] { return SensorSuite(rover, seed++).Read(0, Truth{}, ImuSample{}).imu.pitch_rad; });
  const double sigma = std::hypot(rover.imu.attitude_bias_rad, rover.imu.attitude_noise_rad);
  EXPECT_NEAR(pitch.sigma, sigma, 0.05 * sigma);
  EXPECT_NEAR(pitch.mean, 0.0, 0.1 * sigma);
}

TEST(SensorSuite, YawStartsAtZeroWhateverTheTrueHeading) {
  SensorSuite sensors(TestRover(), 5);
  ImuSample truth;
  truth.yaw_rad = 2.7;
  EXPECT_EQ(sensors.Read(0, Truth{}, truth).imu.yaw_rad, 0.0);
}

TEST(SensorSuite, YawDriftsAndWalksAsTheModelSays) {
  const RoverModel rover = TestRover();
  const double seconds = 100.0;
  std::uint64_t seed = 1;
  const Statistics yaw = Sample(2000, [&] {
    SensorSuite sensors(rover, seed++);
    sensors.Read(0, Truth{}, ImuSample{});
    return sensors.Read(static_cast<Tick>(seconds / kTickSeconds), Truth{}, ImuSample{})
        .imu.yaw_rad;
  });
  const double sigma = std::hypot(rover.imu.yaw_drift_rad_s * seconds,
                                  rover.imu.yaw_walk_rad_sqrt_s * std::sqrt(seconds));
  EXPECT_NEAR(yaw.sigma, sigma, 0.06 * sigma);
}

TEST(SensorSuite, EncodersCountWholeSteps) {
  SensorSuite sensors(TestRover(), 5);
  Truth truth;
  const double step = 2.0 * kPi / 40000.0;
  truth.motor_angle_rad = {100.4 * step, -7.4 * step, 0.0, 2.6 * step};
  const SensorFrame frame = sensors.Read(0, truth, ImuSample{});
  EXPECT_EQ(frame.encoder_counts, (std::array<std::int64_t, 4>{100, -7, 0, 3}));
}

TEST(SensorSuite, SameSeedReadsTheSame) {
  SensorSuite a(TestRover(), 9), b(TestRover(), 9);
  EXPECT_EQ(a.Read(20, Truth{}, ImuSample{}).imu.pitch_rad,
            b.Read(20, Truth{}, ImuSample{}).imu.pitch_rad);
}

}  // namespace
}  // namespace dockyard
