// Dead reckoning of A (drive.h) from encoders and the inertial unit. O: A at power-on.
#pragma once

#include <optional>
#include <vector>

#include "controller/custom/drive.h"
#include "controller/io/sensors.h"

namespace dockyard::custom {

/// Motion between two frames.
struct Motion {
  double length_m = 0.0, turn_rad = 0.0;
};

class Odometry {
 public:
  Odometry(const Nominal& nominal, const Drive& drive);

  /// Adds the motion since the last frame, and returns it; none at the first. The length is the
  /// mean of the wheels, by side; the turn is the unit's, where there is one.
  Motion Read(const SensorFrame& sensed);
  const Pose2& X_OA() const { return X_OA_; }
  /// Drive::turn_share as the unit's turns show it.
  double turn_share() const { return by_both_ / by_wheels_; }

 private:
  void Learn(double wheels_rad, double unit_rad);

  struct Last {
    std::vector<std::int64_t> counts;
    double yaw_rad = 0.0;
  };

  std::vector<double> rad_per_count_;
  Drive drive_;
  bool has_imu_;
  std::optional<Last> last_;
  Pose2 X_OA_;
  // Of the present stretch of a turn, by wheels and by the unit.
  double wheels_rad_ = 0.0, unit_rad_ = 0.0;
  // Least squares of the share over the stretches: sums of products, with a first belief [rad^2].
  double by_both_, by_wheels_;
};

}  // namespace dockyard::custom
