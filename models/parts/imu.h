// An inertial unit and its errors.
#pragma once

#include <Eigen/Core>

namespace dockyard {

/// An inertial unit that integrates its own attitude. Gravity holds roll and pitch. Nothing holds
/// yaw, so that it drifts by the error of the gyro about z. Angle and velocity random walk are the
/// white noise of rate and specific force: a reading over dt has sigma walk / sqrt(dt) (IEEE 952).
struct ImuModel {
  Eigen::Vector3d p_RI{0, 0, 0};        // its place on the body [m]
  double attitude_noise_rad = 0.0;      // roll and pitch, 1 sigma of one reading
  double attitude_bias_rad = 0.0;       // roll and pitch, 1 sigma from power-on to power-on
  double gyro_walk_rad_sqrt_s = 0.0;    // angle random walk
  double gyro_bias_rad_s = 0.0;         // 1 sigma from power-on to power-on
  double gyro_instability_rad_s = 0.0;  // 1 sigma of the bias' wandering
  double accel_walk_m_s_sqrt_s = 0.0;   // velocity random walk
  double accel_bias_m_s2 = 0.0;         // 1 sigma from power-on to power-on
  double accel_instability_m_s2 = 0.0;  // 1 sigma of the bias' wandering
  double instability_time_s = 100.0;    // the wandering's correlation time
};

}  // namespace dockyard
