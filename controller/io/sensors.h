// All that the rover's brain can know at one tick. There is no field for the truth.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "controller/geometry/image.h"

namespace dockyard {

/// Time in whole milliseconds since power-on. No floating-point clock is compared anywhere.
using Tick = std::int64_t;
inline constexpr double kTickSeconds = 1e-3;
/// The brain is called every 20 ms (assumed; 10-100 ms is usual for rover flight software).
inline constexpr Tick kControlPeriod = 20;

/// The rover's inertial unit: attitude as its own filter gives it, rates and specific force.
struct ImuSample {
  double roll_rad = 0.0, pitch_rad = 0.0;  // against gravity; pitch is nose-down positive
  double yaw_rad = 0.0;                    // since power-on, drifting; knows nothing of the station
  Eigen::Vector3d rate_R = Eigen::Vector3d::Zero();            // [rad/s]
  Eigen::Vector3d specific_force_R = Eigen::Vector3d::Zero();  // [m/s^2]; +g along z at rest
};

/// The four motors, always in this order.
enum class Motor : std::uint8_t { kLeftWheel, kRightWheel, kArm, kSpool };
inline constexpr int kMotorCount = 4;

struct SensorFrame {
  Tick tick = 0;
  ImuSample imu{};
  // Counts at the output shaft since power-on (RoverSheet gives radians per count). Wheels count up
  // rolling forward, the arm counts up turning the tip down against the body (about +y), the spool
  // counts up reeling in.
  std::array<std::int64_t, kMotorCount> encoder_counts{};
  std::array<double, kMotorCount> current_a{};  // magnitude as the drive reports it [A], >= 0
  std::optional<StereoImages> images{};         // the answer to Commands::take_images
};

}  // namespace dockyard
