#include "sim/drives/sensor_suite.h"

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

SensorSuite::SensorSuite(const ImuModel& imu, std::vector<MotorModel> motors, Tick control_period,
                         const Seed& run_seed)
    : imu_(imu),
      motors_(std::move(motors)),
      control_period_(control_period),
      imu_stream_(StreamKey(run_seed, "imu")),
      current_stream_(StreamKey(run_seed, "current")) {
  bias_.roll_rad = imu.attitude_bias_rad * imu_stream_.Normal();
  bias_.pitch_rad = imu.attitude_bias_rad * imu_stream_.Normal();
  bias_.rate_R = NormalVector(imu_stream_, imu.gyro_bias_rad_s);
  bias_.specific_force_R = NormalVector(imu_stream_, imu.accel_bias_m_s2);
  wandering_.rate_R = NormalVector(imu_stream_, imu.gyro_instability_rad_s);
  wandering_.specific_force_R = NormalVector(imu_stream_, imu.accel_instability_m_s2);
}

void SensorSuite::Wander(double since_s) {
  const ImuModel& imu = imu_;
  const double keep = std::exp(-since_s / imu.instability_time_s);
  const double stir = std::sqrt(1.0 - keep * keep);
  wandering_.rate_R =
      keep * wandering_.rate_R + NormalVector(imu_stream_, stir * imu.gyro_instability_rad_s);
  wandering_.specific_force_R = keep * wandering_.specific_force_R +
                                NormalVector(imu_stream_, stir * imu.accel_instability_m_s2);
}

SensorFrame SensorSuite::Read(Tick tick, const std::vector<MotorTruth>& motors,
                              const ImuSample& true_imu) {
  const ImuModel& imu = imu_;
  const bool first = !started_;
  if (first) yaw_at_start_rad_ = true_imu.yaw_rad;
  started_ = true;
  // The first reading averages over one control period, as all do in a run.
  const Tick since = first ? control_period_ : tick - last_tick_;
  const double since_s = static_cast<double>(since) * kTickSeconds;
  last_tick_ = tick;
  const double root_s = std::sqrt(std::max(since_s, kTickSeconds));
  Wander(since_s);
  const Eigen::Vector3d rate_error = bias_.rate_R + wandering_.rate_R +
                                     NormalVector(imu_stream_, imu.gyro_walk_rad_sqrt_s / root_s);
  // The unit integrates its gyros: about the vertical nothing corrects their error.
  const Eigen::Matrix3d R_WR =
      ToRotation(RollPitchYaw{true_imu.roll_rad, true_imu.pitch_rad, true_imu.yaw_rad});
  if (!first) yaw_error_rad_ += R_WR.row(2).dot(rate_error) * since_s;

  SensorFrame frame;
  frame.tick = tick;
  frame.imu.roll_rad =
      true_imu.roll_rad + bias_.roll_rad + imu.attitude_noise_rad * imu_stream_.Normal();
  frame.imu.pitch_rad =
      true_imu.pitch_rad + bias_.pitch_rad + imu.attitude_noise_rad * imu_stream_.Normal();
  frame.imu.yaw_rad = WrapPi(true_imu.yaw_rad - yaw_at_start_rad_ + yaw_error_rad_);
  frame.imu.rate_R = true_imu.rate_R + rate_error;
  frame.imu.specific_force_R = true_imu.specific_force_R + bias_.specific_force_R +
                               wandering_.specific_force_R +
                               NormalVector(imu_stream_, imu.accel_walk_m_s_sqrt_s / root_s);
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const double noise_a = motors_[i].current_noise_a * current_stream_.Normal();
    frame.motors.push_back({Counts(motors[i].angle_rad, motors_[i].counts_per_rev),
                            std::max(0.0, motors[i].current_a + noise_a)});
  }
  return frame;
}

}  // namespace dockyard
