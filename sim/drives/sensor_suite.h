// From truth to readings: errors and clock of the inertial unit, encoder quantisation, errors of
// the currents.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"
#include "models/parts/imu.h"
#include "models/parts/motor.h"
#include "sim/base/random.h"
#include "sim/drives/attitude_filter.h"
#include "sim/drives/imu.h"
#include "sim/drives/imu_clock.h"
#include "sim/drives/motor_truth.h"

namespace dockyard {

class SensorSuite {
 public:
  /// Draws the power-on biases and the currents' errors from the run's seed.
  SensorSuite(const ImuModel& imu, std::vector<MotorModel> motors, Tick control_period,
              const Seed& run_seed);
  /// Readings at a control tick (no images). true_imu: averages since the last one, as ImuAverage
  /// gives them; yaw starts at zero.
  SensorFrame Read(Tick tick, const std::vector<MotorTruth>& motors, const TrueImu& true_imu);

 private:
  /// Of one motor's current in this run: what is drawn is read as scale times it, and the offset.
  struct CurrentError {
    double offset_a = 0.0, scale = 1.0;
  };
  MotorReading ReadMotor(std::size_t motor, const MotorTruth& truth);
  void Wander(double since_s);
  /// Of a unit without a filter of its own: the true attitude with errors on it.
  ImuSample Disturb(const ImuSample& truth, bool first, double since_s);
  /// Of a unit that filters its own readings, each of which errs.
  ImuSample Filter(const TrueImu& truth, bool first, double since_s);

  ImuModel imu_;
  std::vector<MotorModel> motors_;
  Tick control_period_;
  ImuClock imu_clock_;
  RandomStream imu_stream_, current_stream_;
  std::vector<CurrentError> current_errors_;  // by motor
  ImuSample bias_{};                          // since power-on
  ImuSample wandering_{};                     // first-order Gauss-Markov: the bias' instability
  double yaw_error_rad_ = 0.0, yaw_at_start_rad_ = 0.0;
  Eigen::Matrix3d gyro_axes_, accelerometer_axes_;  // true to read, of a unit with a filter
  Attitude attitude_;
  ImuSample filtered_{};  // the last reading's
  bool started_ = false;
  Tick first_tick_ = 0, last_tick_ = 0;
};

}  // namespace dockyard
