// An inertial unit and its errors.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>

namespace dockyard {

/// Three like sensors along the axes of the body: how their readings err beyond noise and bias. In
/// SI units of the reading.
struct InertialAxes {
  double scale_share = 0.0;       // error of an axis' scale, 1 sigma
  double misalignment_rad = 0.0;  // of an axis towards each of the others, 1 sigma
  double range = std::numeric_limits<double>::infinity();  // beyond it a reading is cut off
  double step = 0.0;                                       // of a reading; 0: none
};

/// Mahony, Hamel and Pflimlin, IEEE TAC 53(5), 2008, eq. (32), and Madgwick, Harrison and
/// Vaidyanathan, ICORR 2011: both by gyros and accelerometers alone.
enum class AttitudeFilter : std::uint8_t { kMahony, kMadgwick };

/// How a unit estimates its attitude from its own readings.
struct AttitudeUnit {
  AttitudeFilter filter = AttitudeFilter::kMahony;
  double period_s = 0.01;     // of a reading
  double kp_per_s = 1.0;      // Mahony: of the experiments of 2008; assumed, 0.1-10
  double ki_per_s2 = 0.3;     // the same; assumed, 0-1
  double beta_per_s = 0.033;  // Madgwick: the best without a compass; assumed, 0.01-0.5
  InertialAxes gyro{}, accelerometer{};
};

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
  // A frame has the readings of clock_offset_s + clock_drift_ppm * 1e-6 t before, at the time t
  // since power-on, and never those to come: the unit's clock is behind the controller's.
  double clock_offset_s = 0.0, clock_drift_ppm = 0.0;
  /// Without one, roll and pitch err by attitude noise and bias, and yaw by the gyros.
  std::optional<AttitudeUnit> unit{};
};

}  // namespace dockyard
