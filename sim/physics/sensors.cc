#include "sim/physics/sensors.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

Eigen::Vector3d NormalVector(RandomStream& stream, double sigma) {
  const double x = stream.Normal(), y = stream.Normal(), z = stream.Normal();
  return sigma * Eigen::Vector3d(x, y, z);
}

std::int64_t Counts(double angle_rad, int counts_per_rev) {
  return std::llround(std::floor(angle_rad * counts_per_rev / (2.0 * kPi) + 0.5));
}

}  // namespace

SensorSuite::SensorSuite(const RoverModel& rover, std::uint64_t run_seed)
    : rover_(rover),
      imu_stream_(StreamKey(run_seed, "imu")),
      current_stream_(StreamKey(run_seed, "current")) {
  const ImuModel& imu = rover_.imu;
  bias_.roll_rad = imu.attitude_bias_rad * imu_stream_.Normal();
  bias_.pitch_rad = imu.attitude_bias_rad * imu_stream_.Normal();
  bias_.rate_R = NormalVector(imu_stream_, imu.gyro_bias_rad_s);
  bias_.specific_force_R = NormalVector(imu_stream_, imu.accel_bias_m_s2);
  yaw_drift_rad_s_ = imu.yaw_drift_rad_s * imu_stream_.Normal();
}

SensorFrame SensorSuite::Read(Tick tick, const Truth& truth, const ImuSample& true_imu) {
  const ImuModel& imu = rover_.imu;
  if (!started_) {
    yaw_at_start_rad_ = true_imu.yaw_rad;
    started_ = true;
  } else {
    const double since_s = static_cast<double>(tick - last_tick_) * kTickSeconds;
    yaw_walk_rad_ += imu.yaw_walk_rad_sqrt_s * std::sqrt(since_s) * imu_stream_.Normal() +
                     yaw_drift_rad_s_ * since_s;
  }
  last_tick_ = tick;

  SensorFrame frame;
  frame.tick = tick;
  frame.imu.roll_rad =
      true_imu.roll_rad + bias_.roll_rad + imu.attitude_noise_rad * imu_stream_.Normal();
  frame.imu.pitch_rad =
      true_imu.pitch_rad + bias_.pitch_rad + imu.attitude_noise_rad * imu_stream_.Normal();
  frame.imu.yaw_rad = WrapPi(true_imu.yaw_rad - yaw_at_start_rad_ + yaw_walk_rad_);
  frame.imu.rate_R =
      true_imu.rate_R + bias_.rate_R + NormalVector(imu_stream_, imu.gyro_noise_rad_s);
  frame.imu.specific_force_R = true_imu.specific_force_R + bias_.specific_force_R +
                               NormalVector(imu_stream_, imu.accel_noise_m_s2);
  for (int i = 0; i < kMotorCount; ++i) {
    const MotorModel& motor = rover_.motors[i];
    frame.encoder_counts[i] = Counts(truth.motor_angle_rad[i], motor.counts_per_rev);
    frame.current_a[i] =
        std::max(0.0, truth.motor_current_a[i] + motor.current_noise_a * current_stream_.Normal());
  }
  return frame;
}

}  // namespace dockyard
