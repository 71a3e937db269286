// All that a robot's controller can know at one tick. There is no field for the truth.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <variant>
#include <vector>

#include "controller/geometry/image.h"

namespace dockyard {

/// Time in whole milliseconds since power-on. No floating-point clock is compared anywhere.
using Tick = std::int64_t;
inline constexpr double kTickSeconds = 1e-3;

/// The robot's inertial unit: attitude from its own filter, rates and specific force.
struct ImuSample {
  double roll_rad = 0.0, pitch_rad = 0.0;  // against gravity; pitch is nose-down positive
  double yaw_rad = 0.0;                    // since power-on, drifting; independent of the target
  Eigen::Vector3d rate_R = Eigen::Vector3d::Zero();            // [rad/s]
  Eigen::Vector3d specific_force_R = Eigen::Vector3d::Zero();  // [m/s^2]; +g along z at rest
};

/// The readings of one motor's drive.
struct MotorReading {
  std::int64_t encoder_counts = 0;  // at the output shaft, since power-on
  double current_a = 0.0;           // magnitude, >= 0
};

/// One image of one camera.
struct CameraImage {
  int camera = 0;  // index in the order of the robot's nominal parameters
  std::variant<GrayImage, RgbImage> pixels;
  Tick exposed{};           // the middle of its exposure; the frame that brings it may be later
  double exposure_s = 0.0;  // the nominal time of the exposure
};

/// One control period's readings. A robot's nominal parameters give the order of its motors and
/// cameras, the radians of an encoder count, and which way counts up. Its system states the order
/// of its further sensors, with name and unit (ReadyRun::sensors).
struct SensorFrame {
  Tick tick = 0;
  ImuSample imu{};
  std::vector<MotorReading> motors{};
  std::vector<double> values{};  // the newest of each further sensor; a switch: 1 closed, 0 open
  std::vector<CameraImage> images{};  // the answer to Commands::take_images
};

/// The image of that camera, or null when the frame holds none of this kind from it.
const GrayImage* GrayImageOf(const SensorFrame& frame, int camera);
const RgbImage* RgbImageOf(const SensorFrame& frame, int camera);

}  // namespace dockyard
