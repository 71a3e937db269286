// From truth to readings: IMU noise, bias and drift; encoder quantisation; current noise.
#pragma once

#include "controller/io/sensors.h"
#include "models/random.h"
#include "models/rover_model.h"
#include "sim/physics/world.h"

namespace dockyard {

class SensorSuite {
 public:
  /// Draws the power-on biases from the run's seed.
  SensorSuite(const RoverModel& rover, std::uint64_t run_seed);
  /// Readings at a control tick (no images). true_imu from World::TakeTrueImu; yaw starts at zero.
  SensorFrame Read(Tick tick, const Truth& truth, const ImuSample& true_imu);

 private:
  void Wander(double since_s);

  RoverModel rover_;
  RandomStream imu_stream_, current_stream_;
  ImuSample bias_{};       // since power-on
  ImuSample wandering_{};  // first-order Gauss-Markov: the bias' instability
  double yaw_error_rad_ = 0.0, yaw_at_start_rad_ = 0.0;
  bool started_ = false;
  Tick last_tick_ = 0;
};

}  // namespace dockyard
