#include "sim/drives/sensor_suite.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dockyard {
namespace {

Eigen::Vector3d NormalVector(RandomStream& stream, double sigma) {
  const double x = stream.Normal(), y = stream.Normal(), z = stream.Normal();
  return sigma * Eigen::Vector3d(x, y, z);
}

std::int64_t Counts(double angle_rad, int counts_per_rev) {
  return std::llround(std::floor(angle_rad * counts_per_rev / (2.0 * kPi) + 0.5));
}

Eigen::Matrix3d DrawAxes(const InertialAxes& axes, RandomStream& stream) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      R(i, j) += (i == j ? axes.scale_share : axes.misalignment_rad) * stream.Normal();
    }
  }
  return R;
}

Eigen::Vector3d CutAndStepped(const Eigen::Vector3d& value, const InertialAxes& axes) {
  const Eigen::Vector3d cut = value.cwiseMax(-axes.range).cwiseMin(axes.range);
  if (axes.step <= 0.0) return cut;
  return axes.step * (cut / axes.step).array().round().matrix();
}

}  // namespace

SensorSuite::SensorSuite(const ImuModel& imu, std::vector<MotorModel> motors, Tick control_period,
                         const Seed& run_seed)
    : imu_(imu),
      motors_(std::move(motors)),
      control_period_(control_period),
      imu_clock_(imu),
      imu_stream_(StreamKey(run_seed, "imu")),
      current_stream_(StreamKey(run_seed, "current")) {
  RandomStream errors(StreamKey(run_seed, "current errors"));
  for (const MotorModel& motor : motors_) {
    const double offset_a = motor.current_offset_sigma_a * errors.Normal();
    current_errors_.push_back({.offset_a = motor.current_offset_a + offset_a,
                               .scale = 1.0 + motor.current_scale_share * errors.Normal()});
  }
  bias_.roll_rad = imu.attitude_bias_rad * imu_stream_.Normal();
  bias_.pitch_rad = imu.attitude_bias_rad * imu_stream_.Normal();
  bias_.rate_R = NormalVector(imu_stream_, imu.gyro_bias_rad_s);
  bias_.specific_force_R = NormalVector(imu_stream_, imu.accel_bias_m_s2);
  wandering_.rate_R = NormalVector(imu_stream_, imu.gyro_instability_rad_s);
  wandering_.specific_force_R = NormalVector(imu_stream_, imu.accel_instability_m_s2);
  if (!imu.unit) return;
  gyro_axes_ = DrawAxes(imu.unit->gyro, imu_stream_);
  accelerometer_axes_ = DrawAxes(imu.unit->accelerometer, imu_stream_);
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

ImuSample SensorSuite::Disturb(const ImuSample& truth, bool first, double since_s) {
  const double root_s = std::sqrt(std::max(since_s, kTickSeconds));
  Wander(since_s);
  const Eigen::Vector3d rate_error = bias_.rate_R + wandering_.rate_R +
                                     NormalVector(imu_stream_, imu_.gyro_walk_rad_sqrt_s / root_s);
  // The unit integrates its gyros: about the vertical nothing corrects their error.
  const Eigen::Matrix3d R_WR =
      ToRotation(RollPitchYaw{truth.roll_rad, truth.pitch_rad, truth.yaw_rad});
  if (first) yaw_at_start_rad_ = truth.yaw_rad;
  if (!first) yaw_error_rad_ += R_WR.row(2).dot(rate_error) * since_s;

  ImuSample read;
  read.roll_rad = truth.roll_rad + bias_.roll_rad + imu_.attitude_noise_rad * imu_stream_.Normal();
  read.pitch_rad =
      truth.pitch_rad + bias_.pitch_rad + imu_.attitude_noise_rad * imu_stream_.Normal();
  read.yaw_rad = WrapPi(truth.yaw_rad - yaw_at_start_rad_ + yaw_error_rad_);
  read.rate_R = truth.rate_R + rate_error;
  read.specific_force_R = truth.specific_force_R + bias_.specific_force_R +
                          wandering_.specific_force_R +
                          NormalVector(imu_stream_, imu_.accel_walk_m_s_sqrt_s / root_s);
  return read;
}

ImuSample SensorSuite::Filter(const TrueImu& truth, bool first, double since_s) {
  const AttitudeUnit& unit = *imu_.unit;
  std::vector<InertialMean> readings = truth.readings;
  if (first) readings = {{since_s, truth.sample.rate_R, truth.sample.specific_force_R}};
  InertialMean sum;
  for (const InertialMean& reading : readings) {
    const double root_s = std::sqrt(std::max(reading.span_s, kTickSeconds));
    Wander(reading.span_s);
    const Eigen::Vector3d rate_R =
        CutAndStepped(gyro_axes_ * reading.rate_R + bias_.rate_R + wandering_.rate_R +
                          NormalVector(imu_stream_, imu_.gyro_walk_rad_sqrt_s / root_s),
                      unit.gyro);
    const Eigen::Vector3d force_R =
        CutAndStepped(accelerometer_axes_ * reading.specific_force_R + bias_.specific_force_R +
                          wandering_.specific_force_R +
                          NormalVector(imu_stream_, imu_.accel_walk_m_s_sqrt_s / root_s),
                      unit.accelerometer);
    if (first) {
      attitude_ = LevelledBy(force_R);
    } else {
      TakeIn(unit, rate_R, force_R, reading.span_s, attitude_);
    }
    sum.span_s += reading.span_s;
    sum.rate_R += reading.span_s * rate_R;
    sum.specific_force_R += reading.span_s * force_R;
  }
  if (readings.empty()) return filtered_;
  const RollPitchYaw attitude = ToRollPitchYaw(attitude_.q_WR.toRotationMatrix());
  filtered_ = {attitude.roll, attitude.pitch, attitude.yaw, sum.rate_R / sum.span_s,
               sum.specific_force_R / sum.span_s};
  return filtered_;
}

MotorReading SensorSuite::ReadMotor(std::size_t motor, const MotorTruth& truth) {
  const MotorModel& model = motors_[motor];
  const CurrentError& error = current_errors_[motor];
  const double noise_a = model.current_noise_a * current_stream_.Normal();
  const double read_rad = truth.angle_rad + truth.lead_rad + model.homing_error_rad;
  return {Counts(read_rad, model.counts_per_rev),
          std::max(0.0, error.scale * truth.current_a + error.offset_a + noise_a)};
}

SensorFrame SensorSuite::Read(Tick tick, const std::vector<MotorTruth>& motors,
                              const TrueImu& true_imu) {
  const bool first = !std::exchange(started_, true);
  if (first) first_tick_ = tick;
  // The first reading averages over one control period, as all do in a run.
  const Tick since = first ? control_period_ : tick - last_tick_;
  const double since_s = static_cast<double>(since) * kTickSeconds;
  last_tick_ = tick;

  const TrueImu then =
      imu_clock_.Pass(true_imu, static_cast<double>(tick - first_tick_) * kTickSeconds);
  SensorFrame frame;
  frame.tick = tick;
  frame.imu = imu_.unit ? Filter(then, first, since_s) : Disturb(then.sample, first, since_s);
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    frame.motors.push_back(ReadMotor(i, motors[i]));
  }
  return frame;
}

}  // namespace dockyard
